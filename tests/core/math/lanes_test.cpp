#include "steradian/core/math/lanes.h"

#include <gtest/gtest.h>

#include <limits>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using test::numbers;
using test::sameInLanes;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

template <class F>
class LanesOfWidth : public testing::Test {};
using Widths = testing::Types<Lanes<4>, Lanes<8>, Lanes<16>>;
TYPED_TEST_SUITE(LanesOfWidth, Widths);

TYPED_TEST(LanesOfWidth, ArithmeticRoundsAsScalarsDo) {
  constexpr int n = widthOf<TypeParam>;
  const auto a = numbers(256, -3.0f, 5.0f), b = numbers(256, -2.0f, 2.0f, 1);
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return x + y; }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return x - y; }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return x * y; }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return x / y; }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x) { return -x; }, a));
  EXPECT_TRUE(sameInLanes<n>([](auto x) { return squareRoot(x); }, a));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return minimum(x, y); }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return maximum(x, y); }, a, b));
  EXPECT_TRUE(sameInLanes<n>(
      [](auto x, auto y) {
        x += y;
        x -= y;
        x *= y;
        x /= y;
        return x;
      },
      a, b));
}

TYPED_TEST(LanesOfWidth, ComparisonsAndSelectAgreeWithScalars) {
  constexpr int n = widthOf<TypeParam>;
  auto a = numbers(256, -3.0f, 5.0f), b = numbers(256, -2.0f, 2.0f, 1);
  a[20] = kNan;
  b[33] = kNan;
  a[40] = b[40];
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return x < y; }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return x <= y; }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return x > y; }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return x >= y; }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return x == y; }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return x != y; }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return select(x < y, x, y); }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return (x < y) & !(x > 0.0f); }, a, b));
  EXPECT_TRUE(sameInLanes<n>([](auto x, auto y) { return (x < y) | (x > 1.0f); }, a, b));
  // A NaN compares false, so that the second argument stays; so do minimum and maximum.
  EXPECT_EQ(minimum(kNan, 2.0f), 2.0f);
  EXPECT_EQ(maximum(kNan, 2.0f), 2.0f);
  EXPECT_EQ(lane(minimum(TypeParam(kNan), TypeParam(2.0f)), 1), 2.0f);
  // The value that is not selected may be NaN.
  EXPECT_EQ(lane(select(MaskOf<TypeParam>(true), TypeParam(1.0f), TypeParam(kNan)), 0), 1.0f);
}

TYPED_TEST(LanesOfWidth, BitsAndConversionsAgreeWithScalars) {
  constexpr int n = widthOf<TypeParam>;
  const auto a = numbers(256, -30000.0f, 5.0e8f);
  EXPECT_TRUE(sameInLanes<n>([](auto x) { return bitsOf(x); }, a));
  EXPECT_TRUE(sameInLanes<n>([](auto x) { return floatOf(bitsOf(x)); }, a));
  EXPECT_TRUE(sameInLanes<n>([](auto x) { return toFloat(toInt(x)); }, a));
  EXPECT_TRUE(sameInLanes<n>([](auto x) { return toUnsigned(toInt(x)); }, a));
  EXPECT_TRUE(sameInLanes<n>([](auto x) { return toFloat(toSigned(bitsOf(x))); }, a));
  EXPECT_TRUE(sameInLanes<n>(
      [](auto x) {
        using U = decltype(bitsOf(x));
        U bits = bitsOf(x);
        return ((bits >> 3) ^ (bits << 7)) * U(2654435761u) + (~bits & U(0xff00ffu)) - (bits | U(5u));
      },
      a));
}

TYPED_TEST(LanesOfWidth, AnyAndAllSeeEachLane) {
  using M = MaskOf<TypeParam>;
  EXPECT_FALSE(any(M(false)));
  EXPECT_TRUE(all(M(true)));
  for (int i = 0; i < widthOf<TypeParam>; ++i) {
    M one(false);
    setLane(one, i, true);
    EXPECT_TRUE(any(one));
    EXPECT_FALSE(all(one));
    EXPECT_TRUE(lane(one, i));
    EXPECT_FALSE(any(one & !one));
    EXPECT_TRUE(all(one | !one));
    EXPECT_FALSE(any(one ^ one));
    EXPECT_TRUE(lane(select(one, M(true), M(false)), i));
  }
}

TYPED_TEST(LanesOfWidth, MemoryRoundTripsAndGathers) {
  constexpr int n = widthOf<TypeParam>;
  const auto values = numbers(n + 1, 0.0f, 1.0f);
  // One off: no alignment is needed.
  const TypeParam loaded = load<TypeParam>(values.data() + 1);
  std::vector<float> stored(n + 1, 7.0f);
  store(stored.data() + 1, loaded);
  EXPECT_EQ(stored[0], 7.0f);
  std::vector<std::uint32_t> table;
  UintOf<TypeParam> index(0u);
  for (int i = 0; i < n; ++i) {
    EXPECT_EQ(stored[static_cast<std::size_t>(i) + 1], values[static_cast<std::size_t>(i) + 1]);
    table.push_back(static_cast<std::uint32_t>(100 + i));
    setLane(index, i, static_cast<std::uint32_t>(n - 1 - i));
  }
  for (int i = 0; i < n; ++i) {
    EXPECT_EQ(lane(gather(values.data(), index), i), values[static_cast<std::size_t>(n - 1 - i)]);
    EXPECT_EQ(lane(gather(table.data(), index), i), static_cast<std::uint32_t>(100 + n - 1 - i));
  }
}

TYPED_TEST(LanesOfWidth, RecordsAreGatheredAsByOneGatherForEachPlace) {
  constexpr int n = widthOf<TypeParam>;
  const auto table = numbers(256, -3.0f, 5.0f);
  const std::vector<float> floats(table.begin(), table.end());
  std::vector<std::uint32_t> integers;
  integers.reserve(floats.size());
  for (const float x : floats) integers.push_back(bitsOf(x));
  for (std::uint32_t round = 0; round < 20; ++round) {
    UintOf<TypeParam> index;
    for (int i = 0; i < n; ++i) index.set(i, (static_cast<std::uint32_t>(i) * 37u + round * 11u) % 253u);
    const auto rows = gather4(floats.data(), index);
    const auto words = gather4(integers.data(), index);
    for (std::uint32_t k = 0; k < 4; ++k) {
      for (int i = 0; i < n; ++i) {
        ASSERT_EQ(rows[k][i], floats[index[i] + k]);
        ASSERT_EQ(words[k][i], integers[index[i] + k]);
      }
    }
  }
}

TYPED_TEST(LanesOfWidth, BitsAreReversedAsScalarsAre) {
  constexpr int n = widthOf<TypeParam>;
  std::uint32_t x = 1;
  for (int round = 0; round < 100; ++round) {
    UintOf<TypeParam> all;
    for (int i = 0; i < n; ++i) all.set(i, x = x * 1664525u + 1013904223u);
    const auto reversed = reverseBits(all);
    for (int i = 0; i < n; ++i) {
      ASSERT_EQ(reversed[i], reverseBits(all[i]));
      ASSERT_EQ((reversed[i] >> 31) & 1u, all[i] & 1u);
      ASSERT_EQ((reversed[i] >> 5) & 1u, (all[i] >> 26) & 1u);
    }
  }
}

TYPED_TEST(LanesOfWidth, DividesAsScalarsDo) {
  for (const std::uint32_t divisor : {1u, 3u, 64u, 0xffffffffu}) {
    UintOf<TypeParam> dividend(0u), remainder(0u);
    for (int i = 0; i < widthOf<TypeParam>; ++i) setLane(dividend, i, mixBits(static_cast<std::uint32_t>(i)));
    const auto quotient = divide(dividend, divisor, remainder);
    for (int i = 0; i < widthOf<TypeParam>; ++i) {
      std::uint32_t rest = 0;
      EXPECT_EQ(lane(quotient, i), divide(lane(dividend, i), divisor, rest));
      EXPECT_EQ(lane(remainder, i), rest);
      EXPECT_EQ(lane(quotient, i) * divisor + rest, lane(dividend, i));
    }
  }
}

TEST(Lanes, WidthOneIsPlainFloats) {
  EXPECT_EQ(widthOf<float>, 1);
  const float x = load<float>(std::array{2.5f}.data());
  EXPECT_EQ(lane(x, 0), 2.5f);
  EXPECT_TRUE(any(true));
  EXPECT_FALSE(all(false));
  float y = 0.0f;
  setLane(y, 0, 3.0f);
  EXPECT_EQ(y, 3.0f);
}

template <int N>
void expectBits(std::uint32_t pattern) {
  Mask<N> mask;
  for (int i = 0; i < N; ++i) mask.set(i, (pattern >> i & 1u) != 0);
  const std::uint32_t low = pattern & ((1u << N) - 1u);
  EXPECT_EQ(laneBits(mask), low);
  EXPECT_EQ(any(mask), low != 0);
  EXPECT_EQ(all(mask), low == (1u << N) - 1u);
}

TEST(Lanes, BitsAreTheLanesInOrder) {
  for (const std::uint32_t pattern : {0u, 1u, 0x8000u, 0xa5c3u, 0xffffu, 0x0080u}) {
    expectBits<4>(pattern);
    expectBits<8>(pattern);
    expectBits<16>(pattern);
  }
}

}  // namespace
}  // namespace steradian
