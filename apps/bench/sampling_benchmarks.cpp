#include "steradian/apps/bench/micro.h"
#include "steradian/apps/bench/micro_loop.h"
#include "steradian/core/samplers/sampler.h"
#include "steradian/core/sampling/warp.h"

namespace steradian::bench {
namespace {

/// The lanes that wide code will run.
using Wide = Lanes<8>;

/// 0, 1, 2, ... in the lanes.
template <class F>
UintOf<F> consecutive(std::uint32_t first) {
  UintOf<F> lanes(0u);
  for (int i = 0; i < widthOf<F>; ++i) setLane(lanes, i, first + static_cast<std::uint32_t>(i));
  return lanes;
}

/// As paths use samplers: one for each sample, several dimensions of it.
template <class F>
void registerSampler(SamplerType type) {
  const std::string name = "sampler/" + std::string(nameOf(type)) + "/get2D";
  benchmark::RegisterBenchmark(widthName<F>(name).c_str(), [type](benchmark::State& state) {
    const SamplerSettings settings{.type = type, .samplesPerPixel = 64};
    constexpr std::uint32_t kDimensions = 16;
    measureCalls(state, kInputs, kDimensions * static_cast<std::size_t>(widthOf<F>), [&](std::size_t i) {
      const auto input = static_cast<std::uint32_t>(i);
      const Sampler<F> sampler(settings, UintOf<F>(input / 64), consecutive<F>(input % 64));
      Vec2<F> sum{F(0.0f), F(0.0f)};
      for (std::uint32_t d = 0; d < kDimensions; ++d) {
        const Vec2<F> u = sampler.get2D(UintOf<F>(d));
        sum = {sum.x + u.x, sum.y + u.y};
      }
      return sum;
    });
  });
}

/// `warp` maps a point of the unit square.
template <class F, class Warp>
void registerWarp(const std::string& name, Warp warp) {
  benchmark::RegisterBenchmark(widthName<F>("warp/" + name).c_str(), [warp](benchmark::State& state) {
    const UniformPoints points(0);
    measureCalls(state, kBatches<F>, static_cast<std::size_t>(widthOf<F>),
                 [&](std::size_t i) { return warp(points.at<F>(i)); });
  });
}

template <class F>
void registerWidth() {
  for (const SamplerType type : kSamplerTypes) registerSampler<F>(type);
  registerWarp<F>("uniform-sphere", [](Vec2<F> u) { return UniformSphere<F>::sample(u); });
  registerWarp<F>("uniform-hemisphere", [](Vec2<F> u) { return UniformHemisphere<F>::sample(u); });
  registerWarp<F>("cosine-hemisphere", [](Vec2<F> u) { return CosineHemisphere<F>::sample(u); });
  registerWarp<F>("uniform-cone", [](Vec2<F> u) { return UniformCone<F>{F(0.1f)}.sample(u); });
  registerWarp<F>("uniform-disk", [](Vec2<F> u) { return UniformDisk<F>::sample(u); });
  registerWarp<F>("uniform-triangle", [](Vec2<F> u) { return UniformTriangle<F>::sample(u); });
  registerWarp<F>("exponential-flight", [](Vec2<F> u) { return ExponentialFlight<F>{F(2.0f)}.sample(u.x); });
}

}  // namespace

void registerSamplingBenchmarks() {
  registerWidth<float>();
  registerWidth<Wide>();
}

}  // namespace steradian::bench
