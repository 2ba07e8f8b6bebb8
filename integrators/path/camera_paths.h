#pragma once
/// A source of paths for PathPacket: one path from the camera for each sample of a part of the picture.
#include <span>
#include <vector>

#include "steradian/integrators/path/path_packet.h"
#include "steradian/integrators/render/camera_samples.h"

namespace STERADIAN_API steradian {

template <class F>
class CameraPaths {
 public:
  /// results[i] becomes the i-th of the samples.
  CameraPaths(CameraSamples<F>& samples, std::span<PixelSample> results)
      : samples_(samples), results_(results), weights_(results.size()) {}

  bool empty() const { return samples_.empty(); }
  PathStart take() {
    const auto next = samples_.take();
    results_[next.number] = kMiss;
    weights_[next.number] = next.weight;
    return {PathState<float>(next.ray), 0, next.pixel, next.sample, next.number};
  }
  void arrived(const PathLanes<F>& lanes, const typename PathLanes<F>::Vertex& vertex, UintOf<F> bounce,
               const typename PathPacket<F>::Numbers& numbers) {
    const MaskOf<F> first = vertex.hit & (bounce == UintOf<F>(0u));
    if (!any(first)) return;
    lanes.recordFirstHit(vertex, first,
                         [&](int i) -> PixelSample& { return results_[numbers[static_cast<std::size_t>(i)]]; });
  }
  void ended(std::uint32_t number, Rgb radiance) {
    results_[number].radiance = radiance * weights_[number];
    results_[number].alpha *= weights_[number];
  }

 private:
  CameraSamples<F>& samples_;
  std::span<PixelSample> results_;
  std::vector<float> weights_;
};

}  // namespace steradian
