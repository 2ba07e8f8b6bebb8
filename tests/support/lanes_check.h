#pragma once
/// Width 1 = width N, exactly: a generic function applied to values one by one and N at a time.
///
///     EXPECT_TRUE(sameInLanes<8>([](auto x, auto y) { return arcTan2(y, x); }, xs, ys));
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "steradian/core/math/vec.h"
#include "steradian/core/samplers/rng.h"

namespace steradian::test {

/// Equal bits, or both NaN.
inline bool sameBits(float a, float b) { return bitsOf(a) == bitsOf(b) || (std::isnan(a) && std::isnan(b)); }
inline bool sameBits(bool a, bool b) { return a == b; }
inline bool sameBits(std::uint32_t a, std::uint32_t b) { return a == b; }
inline bool sameBits(Vec2f a, Vec2f b) { return sameBits(a.x, b.x) && sameBits(a.y, b.y); }
inline bool sameBits(Vec3f a, Vec3f b) { return sameBits(a.x, b.x) && sameBits(a.y, b.y) && sameBits(a.z, b.z); }

template <class F>
F loadCyclic(std::span<const float> values, std::size_t start) {
  F r(0.0f);
  for (int i = 0; i < widthOf<F>; ++i) setLane(r, i, values[(start + static_cast<std::size_t>(i)) % values.size()]);
  return r;
}

/// f takes floats or Lanes<N>, one per list of inputs (of equal length), and returns any type that lane() supports.
template <int N, class Function, class... Inputs>
testing::AssertionResult sameInLanes(Function f, const Inputs&... inputs) {
  const std::size_t count = std::get<0>(std::tuple(std::span<const float>(inputs)...)).size();
  for (std::size_t start = 0; start < count; start += N) {
    const auto wide = f(loadCyclic<Lanes<N>>(inputs, start)...);
    for (int i = 0; i < N; ++i) {
      const std::size_t at = (start + static_cast<std::size_t>(i)) % count;
      if (sameBits(lane(wide, i), f(inputs[at]...))) continue;
      auto failure = testing::AssertionFailure() << "width " << N << " differs from width 1 for";
      ((failure << ' ' << inputs[at]), ...);
      return failure;
    }
  }
  return testing::AssertionSuccess();
}

/// Fixed random numbers in [0, 1), the first of them 0, the largest below 1, 1/2 and 1/4; lists of different `key`
/// have them in different order.
inline std::vector<float> unitNumbers(int count, std::uint32_t key = 0) {
  std::vector<float> values;
  for (int i = 0; i < count; ++i) {
    const auto words = randomWords<std::uint32_t>(static_cast<std::uint32_t>(i), key, 1u, 2u);
    constexpr std::array<float, 4> special{0.0f, kOneMinusEpsilon, 0.5f, 0.25f};
    const bool first = i < 16;
    const int digit = key % 2 == 0 ? i % 4 : i / 4;
    values.push_back(first ? special[static_cast<std::size_t>(digit)] : toUnitFloat<float>(words[0]));
  }
  return values;
}
/// The same in [low, high].
inline std::vector<float> numbers(int count, float low, float high, std::uint32_t key = 0) {
  std::vector<float> values = unitNumbers(count, key);
  for (float& v : values) v = low + (high - low) * v;
  return values;
}

}  // namespace steradian::test
