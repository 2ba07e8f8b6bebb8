#pragma once
/// What all passes of one render share.
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <stop_token>
#include <vector>

#include "steradian/core/film/film.h"
#include "steradian/core/film/filter.h"
#include "steradian/core/math/morton.h"
#include "steradian/core/samplers/sampler.h"
#include "steradian/core/scene/camera.h"
#include "steradian/integrators/render/render_statistics.h"

namespace STERADIAN_API steradian {

struct RenderProgress {
  double fraction = 0.0;              ///< done, 0..1: of the samples, or of the time limit if that is nearer its end
  double seconds = 0.0;               ///< since render() was called
  std::uint64_t samples = 0;          ///< done, over all pixels
  std::uint32_t samplesPerPixel = 0;  ///< that every pixel has
};
/// Called after each tile by the thread that rendered it, never by two at once; the fraction never falls. Keep it
/// short: the others wait.
using ProgressCallback = std::function<void(const RenderProgress&)>;

/// Adds up what tiles have rendered, reports progress, and tells tiles whether to stop. Shared by all threads of a
/// render.
class RenderMonitor {
 public:
  /// Makes progress of the number of samples in the film; called with the lock held.
  using Report = std::function<void(std::uint64_t samples)>;

  RenderMonitor(std::stop_token stop, Report report) : stop_(std::move(stop)), report_(std::move(report)) {}

  bool stopRequested() const { return stop_.stop_requested(); }
  /// `samples` more samples are in the film.
  void finishedTile(std::uint64_t samples, const PathCounts& counts);

  // Not to be called while a pass runs.
  std::uint64_t samples() const { return samples_; }
  const PathCounts& counts() const { return counts_; }

 private:
  std::stop_token stop_;
  Report report_;
  std::mutex mutex_;
  std::uint64_t samples_ = 0;
  PathCounts counts_;
};

/// Samples first, ..., end - 1 of every pixel.
struct PassRange {
  std::uint32_t first = 0, end = 0;
  std::uint32_t count() const { return end - first; }
};

/// A camera ray; what it finds is multiplied by `weight`.
template <class F>
struct WeightedRay {
  Ray<F> ray;
  F weight;
};

struct RenderJob {
  const Camera& camera;
  const Filter& filter;
  SamplerSettings samplerSettings;
  int tileSize;
  RenderMonitor& monitor;
  bool dependsOnTime = true;  ///< false: all rays are at time 0, and no random number is drawn for it

  /// The number by which samplers know pixel (x, y) of the full picture: its place along the Z curve. (The curve takes
  /// 16 bits of each coordinate; higher bits are mixed in.)
  static std::uint32_t pixelKey(int x, int y) {
    const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
    return mortonOf(column, row) ^ mixBits((row & 0xffff0000u) | (column >> 16));
  }
  /// A camera ray through pixel (x, y), both whole numbers.
  template <class F>
  WeightedRay<F> cameraRay(F x, F y, const Sampler<F>& sampler) const {
    const UintOf<F> start(0u);
    const FilterSample<F> place = filter.sample(sampler.get2D(start, Purpose::Film));
    const Vec2<F> film{x + F(0.5f) + place.offset.x, y + F(0.5f) + place.offset.y};
    const Vec2<F> lens = camera.hasLens() ? sampler.get2D(start, Purpose::Lens) : Vec2<F>{};
    const F time = dependsOnTime ? sampler.get1D(start, Purpose::Time) : F(0.0f);
    return {camera.ray<F>({film, lens, time}), place.weight};
  }
};

/// The crop cut by the squares of edge `size` that the picture is divided into from its corner (0, 0), row by row.
std::vector<Crop> tilesOf(const Crop& crop, int size);

}  // namespace steradian
