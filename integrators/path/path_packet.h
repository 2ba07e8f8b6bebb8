#pragma once
/// Traces several paths at once: the loop of path_loop.h with a path in each lane. A lane whose path has ended takes
/// the next one, so that all lanes have work until there are no more paths.
///
/// Paths come from a Source, which is also told what becomes of them:
///
///     bool empty();                                   // there are no more paths
///     PathStart take();                               // the next path; there must be one
///     void arrived(const PathLanes<F>&, const Vertex&, Uint bounce, const Numbers&);  // at the vertices with
///     vertex.hit void ended(std::uint32_t number, Rgb radiance); // the path of that number, and the radiance that it
///     has found
#include <array>
#include <optional>

#include "steradian/integrators/path/path_lanes.h"

namespace STERADIAN_API steradian {

struct PathStart {
  PathState<float> path;
  std::uint32_t bounce;         ///< bounces so far; must be 0 in scenes with volumes
  std::uint32_t pixel, sample;  ///< what its random numbers are a function of (Sampler)
  std::uint32_t number;         ///< by which the source knows the path
};

template <class F>
class PathPacket {
 public:
  static constexpr int width = widthOf<F>;
  using Numbers = std::array<std::uint32_t, static_cast<std::size_t>(width)>;

  PathPacket(const WideScene& scene, const PathPlan& plan, const SamplerSettings& samplerSettings, PathCounts& counts)
      : scene_(scene), plan_(plan), samplerSettings_(samplerSettings), counts_(counts), lanes_(scene, plan, counts) {}

  /// Traces every path of the source.
  template <class Source>
  void run(Source& source) {
    for (int i = 0; i < width; ++i) start(i, source);
    rebuildSampler();
    while (any(active_)) step(source);
  }

 private:
  using Mask = MaskOf<F>;
  using Uint = UintOf<F>;

  template <class Source>
  void start(int i, Source& source);
  template <class Source>
  void step(Source& source);
  void rebuildSampler() { sampler_.emplace(samplerSettings_, pixel_, sample_); }

  const WideScene& scene_;
  const PathPlan& plan_;
  const SamplerSettings samplerSettings_;
  PathCounts& counts_;
  PathLanes<F> lanes_;

  Mask active_{false};
  PathState<F> path_;
  Spectrum<F> radiance_;
  Uint bounce_{0u}, pixel_{0u}, sample_{0u};
  Numbers number_{};
  std::optional<Sampler<F>> sampler_;
};

/// Gives lane i the next path; if there is none, the lane is no longer active.
template <class F>
template <class Source>
void PathPacket<F>::start(int i, Source& source) {
  setLane(active_, i, !source.empty());
  if (source.empty()) return;
  const PathStart next = source.take();
  setLane(path_, i, next.path);
  setLane(radiance_, i, Rgb{});
  setLane(bounce_, i, next.bounce);
  setLane(pixel_, i, next.pixel);
  setLane(sample_, i, next.sample);
  if (lanes_.hasVolumes()) lanes_.flight().start(i, next.path.ray);
  number_[static_cast<std::size_t>(i)] = next.number;
}

/// One bounce of every path.
template <class F>
template <class Source>
void PathPacket<F>::step(Source& source) {
  // Intersect the rays with the scene, and add the radiance that is emitted there.
  const typename PathLanes<F>::Vertex vertex = lanes_.nextVertex(path_, *sampler_, bounce_, active_, radiance_);
  source.arrived(lanes_, vertex, bounce_, number_);
  Mask going = vertex.hit & (bounce_ != Uint(plan_.maxDepth));

  // Sample direct light.
  const Spectrum<F> light = path_.throughput * lanes_.sampleDirectLight(vertex, *sampler_, bounce_, going);
  radiance_ = select(going, radiance_ + light, radiance_);

  // Sample the BSDF, play Russian roulette and spawn the next rays.
  going = lanes_.scatter(vertex, *sampler_, bounce_, going, path_).going;

  // Lanes whose paths have ended take the next paths.
  const Mask ended = active_ & !going;
  forEachLane(ended, [&](int i) {
    source.ended(number_[static_cast<std::size_t>(i)], lane(radiance_, i));
    counts_.countPath(lane(bounce_, i));
  });
  bounce_ = bounce_ + select(going, Uint(1u), Uint(0u));
  if (!any(ended)) return;
  forEachLane(ended, [&](int i) { start(i, source); });
  rebuildSampler();
}

}  // namespace steradian
