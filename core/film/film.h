#pragma once
/// The film: exact sums of samples, per pixel.
///
/// A sample is rounded once, when it enters fixed point (core/film/fixed_point.h); from there on nothing rounds. The
/// same set of samples gives the same bits however it was cut into runs, passes, tiles, threads and shards.
#include <array>
#include <compare>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "steradian/core/base/isa.h"
#include "steradian/core/film/fixed_point.h"
#include "steradian/core/film/sample_ledger.h"
#include "steradian/core/image/image.h"
#include "steradian/core/math/vec.h"
#include "steradian/core/statistics/standard_error.h"
#include "steradian/core/transport/spectrum.h"

namespace STERADIAN_API steradian {

/// What one sample of a pixel measured. Filter weights have mean 1 and are multiplied into `radiance` and `alpha`
/// beforehand (filter importance sampling).
struct PixelSample {
  Rgb radiance{};           ///< W sr^-1 m^-2
  float alpha = 1.0f;       ///< 0 where the camera ray missed
  Rgb albedo{};             ///< of the first surface
  Vec3f normal{};           ///< of the first surface, world space
  float depth = kInfinity;  ///< distance to the first surface, scene units; +inf: a miss
};

/// Pixels x0 <= x < x1, y0 <= y < y1; y runs downwards.
struct Crop {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  bool operator==(const Crop&) const = default;
  bool contains(int x, int y) const { return x >= x0 && x < x1 && y >= y0 && y < y1; }
};

struct FilmSettings {
  int width = 0, height = 0;                ///< of the full picture
  std::optional<Crop> crop = std::nullopt;  ///< the part that is stored; by default all
  /// 1: one sequence, whose error is judged by its 5 to 8 sub-sequences (core/statistics/standard_error.h). R >= 2:
  /// sample i belongs to the independently scrambled sequence i mod R; let R divide the number of samples.
  std::uint32_t replicates = 1;
  std::uint64_t memoryLimit = 0;  ///< bytes; 0: the machine's memory
};

/// A sample that was not finite, by which the render can be repeated.
struct DroppedSample {
  std::uint32_t sample = 0;
  int x = 0, y = 0;
  auto operator<=>(const DroppedSample&) const = default;
};

struct FilmImageOptions {
  bool features = true;  ///< Albedo.*, N.*, Z
  bool errors = true;    ///< StdErr.Y, Samples
};

struct FilmKernels;

class Film {
 public:
  static constexpr std::uint32_t kMaxReplicates = 256;
  static constexpr std::size_t kRememberedDrops = 16;

  /// All sums are zero. Throws `Error`: Usage if a side is not in [1, Image::maxSide], the crop is empty or reaches
  /// beyond the picture, or replicates are not in [1, kMaxReplicates]; Memory if there is not enough of it. `isa`, the
  /// instruction set of the code that adds samples, must be usable.
  explicit Film(const FilmSettings& settings, Isa isa = bestIsa());

  const FilmSettings& settings() const { return settings_; }
  const Crop& crop() const { return crop_; }
  /// The largest number of groups of samples that the standard error is computed from: `replicates`, or 8 if that is 1.
  std::uint32_t groupCount() const { return groups_; }
  /// Memory per pixel: 224 bytes with 8 groups, and 12 for each group more or less.
  static std::uint64_t bytesPerPixel(std::uint32_t replicates);

  /// Adds the samples firstSample, firstSample + 1, ... of pixel (x, y), which is inside the crop. Runs may be split
  /// and added in any order. Samples with a value that is not finite (depth may be +inf) are dropped, lower the count
  /// and are remembered. Different pixels may be added to at the same time from several threads.
  void addSamples(int x, int y, std::uint32_t firstSample, std::span<const PixelSample> samples);

  /// Which samples were added: the caller of addSamples() enters them when they are complete.
  SampleLedger& ledger() { return ledger_; }
  const SampleLedger& ledger() const { return ledger_; }

  /// Adds all that `other` holds. Throws `Error` (Usage), leaving this film as it is, if the picture, crop or
  /// replicates differ or a sample is in both ledgers.
  void merge(const Film& other);

  // The following must not run while samples are added.

  std::uint32_t sampleCount(int x, int y) const;  ///< without dropped ones
  std::uint64_t sampleCount() const;              ///< of all pixels
  std::uint64_t droppedCount() const;
  /// The first kRememberedDrops dropped samples in order of (sample, x, y).
  std::vector<DroppedSample> dropped() const;

  Rgb radiance(int x, int y) const;  ///< mean; 0 without samples
  /// Luminance (Rec.709 Y) with its standard error. The error is +inf where it is not known: with fewer than two
  /// groups of samples, or where the sums have saturated (samples of luminance that add up to more than 2^31).
  MeanEstimate luminanceEstimate(int x, int y) const;

  /// The crop as an image, metadata left to the caller: R G B A; Albedo.R .G .B, N.X .Y .Z (means over all samples,
  /// misses counting 0), Z (mean over hits, +inf without any); StdErr.Y, Samples.
  Image image(const FilmImageOptions& options = {}) const;

 private:
  static constexpr int kNarrow = 7;  // alpha, albedo, normal

  struct Sums {
    std::array<FixedPoint128, 3> radiance;
    FixedPoint128 depth;  // of hits
    std::array<FixedPoint64, kNarrow> narrow;
    std::uint32_t hits = 0;
    std::uint32_t shift = 0;  // sub-sequences are runs of 2^shift samples
  };
  struct Drops {
    std::mutex mutex;
    std::uint64_t count = 0;
    std::vector<DroppedSample> first;  // sorted
  };

  std::size_t pixelIndex(int x, int y) const;
  std::uint32_t groupOf(std::size_t pixel, std::uint32_t sample) const {
    return settings_.replicates == 1 ? sample >> sums_[pixel].shift : sample % settings_.replicates;
  }
  void widenSubSequences(std::size_t pixel, std::uint32_t shift);
  void addBatch(int x, int y, std::uint32_t firstSample, std::span<const PixelSample> samples);
  void addExtraordinary(int x, int y, std::uint32_t sample, const PixelSample& s);
  void drop(const DroppedSample& sample);

  FilmSettings settings_;
  Crop crop_;
  std::uint32_t groups_;
  std::vector<Sums> sums_;                    // per pixel
  std::vector<FixedPoint64> groupLuminance_;  // per pixel and group
  std::vector<std::uint32_t> groupCount_;     // per pixel and group
  SampleLedger ledger_;
  std::unique_ptr<Drops> drops_;
  const FilmKernels* kernels_;
};

}  // namespace steradian
