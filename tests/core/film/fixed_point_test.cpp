#include "steradian/core/film/fixed_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <vector>

#include "steradian/core/samplers/rng.h"

namespace steradian {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// A fixed permutation, the same with every standard library.
template <class T>
void shuffle(std::vector<T>& values, RandomStream& random) {
  for (std::size_t i = values.size(); i > 1; --i) {
    std::swap(values[i - 1], values[static_cast<std::size_t>(random.next() * static_cast<float>(i))]);
  }
}

/// A float of random sign, mantissa and power of two in [2^lowest, 2^(highest + 1)).
float randomFloat(RandomStream& random, int lowest, int highest) {
  const float mantissa = 1.0f + random.next();
  const int exponent = lowest + static_cast<int>(random.next() * static_cast<float>(highest - lowest + 1));
  return std::ldexp(random.next() < 0.5f ? -mantissa : mantissa, exponent);
}

TEST(FixedPoint, HoldsFloatsExactly) {
  RandomStream random(1, 2, 3, 4);
  for (int i = 0; i < 20000; ++i) {
    const float wide = randomFloat(random, -41, 62), narrow = randomFloat(random, -9, 30);
    EXPECT_EQ(FixedPoint128::from(wide).toDouble(), static_cast<double>(wide));
    EXPECT_EQ(FixedPoint64::from(narrow).toDouble(), static_cast<double>(narrow));
  }
  EXPECT_EQ(FixedPoint128::from(0.0), FixedPoint128());
  EXPECT_EQ(FixedPoint128::from(-0.0), FixedPoint128());
  EXPECT_TRUE(FixedPoint128::from(-1.0).steps() == -FixedPoint128::from(1.0).steps());
}

TEST(FixedPoint, RoundsToTheNearestStepTiesToEven) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(FixedPoint128::from(sign * 0x1p-65).toDouble(), 0.0);
    EXPECT_EQ(FixedPoint128::from(sign * 0x1.1p-65).toDouble(), sign * 0x1p-64);
    EXPECT_EQ(FixedPoint128::from(sign * 0x1.8p-64).toDouble(), sign * 0x1p-63);
    EXPECT_EQ(FixedPoint128::from(sign * 0x1.4p-63).toDouble(), sign * 0x1p-63);
    EXPECT_EQ(FixedPoint64::from(sign * 0x1p-33).toDouble(), 0.0);
    EXPECT_EQ(FixedPoint64::from(sign * 0x1.8p-32).toDouble(), sign * 0x1p-31);
    EXPECT_EQ(FixedPoint64::from(sign * (1.0 + 0x1.1p-33)).toDouble(), sign * (1.0 + 0x1p-32));
  }
}

TEST(FixedPoint, AddsWhatADoubleCannot) {
  // 2^60 and 2^-60 are 120 bits apart.
  FixedPoint128 sum = FixedPoint128::from(0x1p60);
  sum += FixedPoint128::from(0x1p-60);
  sum += FixedPoint128::from(-0x1p60);
  EXPECT_EQ(sum.toDouble(), 0x1p-60);
}

template <class Fixed>
void expectSameSumInAnyOrder(int lowest, int highest) {
  RandomStream random(9, 2, 3, 4);
  std::vector<float> values;
  values.reserve(1000);
  for (int i = 0; i < 1000; ++i) values.push_back(randomFloat(random, lowest, highest));
  Fixed reference;
  for (const float v : values) reference += Fixed::from(v);
  for (int round = 0; round < 50; ++round) {
    shuffle(values, random);
    // Partial sums of random sizes, then their sum.
    Fixed total, part;
    for (const float v : values) {
      part += Fixed::from(v);
      if (random.next() < 0.1f) {
        total += part;
        part = {};
      }
    }
    total += part;
    EXPECT_EQ(total, reference);
  }
}

TEST(FixedPoint, SumsAreTheSameInAnyOrderAndGrouping) {
  expectSameSumInAnyOrder<FixedPoint128>(-60, 50);
  expectSameSumInAnyOrder<FixedPoint64>(-30, 18);
}

template <class Fixed>
void expectSaturation(double limit) {
  for (const double sign : {1.0, -1.0}) {
    for (const double beyond : {limit, 2.0 * limit, kInf}) {
      const Fixed f = Fixed::from(sign * beyond);
      EXPECT_TRUE(f.saturated());
      EXPECT_EQ(f.toDouble(), sign * limit);
    }
    Fixed sum = Fixed::from(sign * 0.75 * limit);
    EXPECT_FALSE(sum.saturated());
    sum += Fixed::from(sign * 0.75 * limit);
    EXPECT_TRUE(sum.saturated());
    sum += Fixed::from(-sign * 0.75 * limit);  // stays saturated
    EXPECT_EQ(sum.toDouble(), sign * limit);
    Fixed other = Fixed::from(-sign * 1.0);
    other += sum;
    EXPECT_EQ(other, sum);
    EXPECT_EQ(Fixed::fromSteps(sum.steps()), sum);
  }
  // The lowest integer has no positive counterpart.
  Fixed lowest = Fixed::from(-0.5 * limit);
  lowest += Fixed::from(-0.5 * limit);
  EXPECT_TRUE(lowest.saturated());
}

TEST(FixedPoint, SaturatesAndStaysSo) {
  expectSaturation<FixedPoint128>(0x1p63);
  expectSaturation<FixedPoint64>(0x1p31);
}

TEST(FixedPoint, ShortWaysAgreeWithTheLongOnes) {
  RandomStream random(7, 7, 7, 7);
  std::vector<double> values{0.0, -0.0, 0x1p-65, 0x1.8p-64, -0x1.8p-64, 0x1.4p-63, 0x1p-21, 0x1.8p-21, -0x1.8p-21};
  for (int i = 0; i < 20000; ++i) values.push_back(randomFloat(random, -70, 30));
  for (const double v : values) {
    ShortSum128 sum;
    sum.add(v);
    EXPECT_EQ(sum.total(), FixedPoint128::from(v)) << v;
    const double narrow = std::fmod(v, 0x1p18);
    EXPECT_EQ(FixedPoint64::fromSteps(steps64(narrow)), FixedPoint64::from(narrow)) << narrow;
  }
  // The longest sum of the largest numbers.
  for (const float largest : {0x1.fffffep30f, -0x1.fffffep30f}) {
    ShortSum128 sum;
    FixedPoint128 reference;
    for (int i = 0; i < ShortSum128::kMaxCount; ++i) {
      sum.add(largest);
      reference += FixedPoint128::from(largest);
    }
    EXPECT_EQ(sum.total(), reference);
  }
}

}  // namespace
}  // namespace steradian
