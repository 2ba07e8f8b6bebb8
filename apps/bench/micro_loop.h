#pragma once
/// The loop that all micro-benchmarks share.
#include <benchmark/benchmark.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "steradian/core/base/float_mode.h"
#include "steradian/core/samplers/rng.h"

namespace steradian::bench {

/// Names of the counters, from which the report derives the unit.
inline constexpr const char* kRayCounter = "rays";
inline constexpr const char* kCallCounter = "call";

/// Times call(0), ..., call(count - 1) over and over; returns the number of calls.
template <class Call>
double repeat(benchmark::State& state, std::size_t count, Call&& call) {
  const FlushDenormals floatMode;
  for (auto iteration : state) {
    static_cast<void>(iteration);
    for (std::size_t i = 0; i < count; ++i) benchmark::DoNotOptimize(call(i));
  }
  return static_cast<double>(state.iterations()) * static_cast<double>(count);
}

/// Each call traces one ray; reported in rays per second.
template <class Call>
void measureRays(benchmark::State& state, std::size_t count, Call&& call) {
  const double rays = repeat(state, count, std::forward<Call>(call));
  state.counters[kRayCounter] = benchmark::Counter(rays, benchmark::Counter::kIsRate);
}

/// Each call gives `each` results; reported in seconds per result.
template <class Call>
void measureCalls(benchmark::State& state, std::size_t count, std::size_t each, Call&& call) {
  const double results = repeat(state, count, std::forward<Call>(call)) * static_cast<double>(each);
  state.counters[kCallCounter] = benchmark::Counter(results, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// Too many for branch predictors to learn, few enough for the L1 cache.
inline constexpr std::size_t kInputs = 1024;

/// Numbers in [0, 1), the same in every run.
inline std::vector<float> uniformNumbers(std::size_t count, std::uint32_t stream) {
  std::vector<float> numbers(count);
  RandomStream random(0, 0, stream, 0x62656e63);
  for (float& x : numbers) x = random.next();
  return numbers;
}

/// kInputs points of the unit square, as lanes read them: all x, all y.
struct UniformPoints {
  std::vector<float> x, y;
  explicit UniformPoints(std::uint32_t stream)
      : x(uniformNumbers(kInputs, 2 * stream)), y(uniformNumbers(kInputs, 2 * stream + 1)) {}
  /// Lanes that begin at input i x width.
  template <class F>
  Vec2<F> at(std::size_t i) const {
    const std::size_t first = i * static_cast<std::size_t>(widthOf<F>);
    return {load<F>(x.data() + first), load<F>(y.data() + first)};
  }
};

template <class F>
inline constexpr std::size_t kBatches = kInputs / static_cast<std::size_t>(widthOf<F>);

/// "warp/cosine-hemisphere" at width 1, "warp/cosine-hemisphere/8" in lanes.
template <class F>
std::string widthName(const std::string& name) {
  return widthOf<F> == 1 ? name : name + "/" + std::to_string(widthOf<F>);
}

}  // namespace steradian::bench
