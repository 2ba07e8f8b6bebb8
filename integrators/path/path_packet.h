#pragma once
/// Several paths at once: the loop of path_loop.h with a path in each lane. A lane whose path has ended takes the next
/// one, so that all lanes have work until paths run out.
///
/// Where they come from and what becomes of them is the Source's:
///
///     bool empty();
///     PathStart take();                              // the next path; there must be one
///     void arrived(const PathLanes<F>&, const Vertex&, Uint bounce, const Numbers&);  // of lanes with vertex.hit
///     void ended(std::uint32_t number, Rgb radiance);
#include <array>
#include <optional>

#include "steradian/integrators/path/path_lanes.h"

namespace STERADIAN_API steradian {

struct PathStart {
  PathState<float> path;
  std::uint32_t bounce;  ///< 0: at the camera. Others are not for scenes with volumes.
  std::uint32_t pixel, sample;
  std::uint32_t number;
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

/// Gives lane i the next path, or nothing to do.
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

/// Brings every path to its next vertex and sends it on from there.
template <class F>
template <class Source>
void PathPacket<F>::step(Source& source) {
  const typename PathLanes<F>::Vertex vertex = lanes_.arrive(path_, *sampler_, bounce_, active_, radiance_);
  source.arrived(lanes_, vertex, bounce_, number_);
  Mask going = vertex.hit & (bounce_ != Uint(plan_.maxDepth));
  const Spectrum<F> light = path_.throughput * lanes_.directLight(vertex, *sampler_, bounce_, going);
  radiance_ = select(going, radiance_ + light, radiance_);
  going = lanes_.leave(vertex, *sampler_, bounce_, going, path_).going;
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
