#include "steradian/materials/perlin_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "steradian/core/statistics/running_mean.h"
#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

Vec3f place(std::uint32_t i, float extent = 20.0f) {
  const auto words = randomWords<std::uint32_t>(i, 0, 0, 77);
  const auto within = [&](std::size_t k) { return extent * (2.0f * toUnitFloat<float>(words[k]) - 1.0f); };
  return {within(0), within(1), within(2)};
}

TEST(PerlinNoise, IsZeroAtLatticePoints) {
  const PerlinNoise noise(0);
  for (const float x : {-3.0f, 0.0f, 5.0f, 1e6f, -8388608.0f, 1e20f}) {
    EXPECT_EQ(noise.noise(Vec3f{x, 2.0f, -7.0f}), 0.0f);
    EXPECT_EQ(noise.noise(Vec3f{2.0f, x, x}), 0.0f);
  }
}

TEST(PerlinNoise, StaysBetweenMinusOneAndOneAndHasNoBias) {
  const PerlinNoise noise(3);
  RunningMean mean, square;
  float low = 0.0f, high = 0.0f;
  for (std::uint32_t i = 0; i < 100000; ++i) {
    const float x = noise.noise(place(i, 500.0f));
    low = std::min(low, x), high = std::max(high, x);
    mean.add(x);
    square.add(x * x);
  }
  EXPECT_GT(low, -1.0f);
  EXPECT_LT(high, 1.0f);
  EXPECT_LT(low, -0.5f);
  EXPECT_GT(high, 0.5f);
  EXPECT_NEAR(mean.mean(), 0.0, 5.0 * mean.standardError());
  // The mean square, in closed form: vectors are independent, with E[(g . d)^2] = |d|^2 / 3.  Per axis the blends w of
  // the two ends give A = the integral of w^2, both ends, and B = that of w^2 d^2; the sum is 3 A^2 B / 3.
  const double a = 26.0 / 35.0, b = 2.0 * 19.0 / 630.0;
  EXPECT_NEAR(square.mean(), a * a * b, 6.0 * square.standardError());
}

// Values and slopes are continuous between cells.
TEST(PerlinNoise, IsSmooth) {
  const PerlinNoise noise(1);
  const float h = 1e-3f;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    Vec3f p = place(i);
    if (i % 2 == 0) p.x = std::round(p.x);  // on the border of cells
    if (i % 4 == 0) p.z = std::round(p.z);
    const float before = noise.noise(p - Vec3f{h, h, h}), at = noise.noise(p), after = noise.noise(p + Vec3f{h, h, h});
    EXPECT_NEAR(at, before, 6.0f * h);
    EXPECT_NEAR(after - at, at - before, 60.0f * h * h + 2e-6f) << i;
  }
}

// A hash, not a table of 256: nothing repeats.
TEST(PerlinNoise, DoesNotRepeat) {
  const PerlinNoise noise(1), other(2);
  int equal = 0, equalSeeds = 0;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Vec3f p = place(i);
    const float x = noise.noise(p);
    for (const float period : {256.0f, 512.0f, 65536.0f}) {
      equal += std::abs(x - noise.noise(p + Vec3f{period, 0, 0})) < 1e-3f ? 1 : 0;
      equal += std::abs(x - noise.noise(p + Vec3f{0, 0, period})) < 1e-3f ? 1 : 0;
    }
    equal += std::abs(x - noise.noise(Vec3f{p.y, p.x, p.z})) < 1e-3f ? 1 : 0;
    equalSeeds += std::abs(x - other.noise(p)) < 1e-3f ? 1 : 0;
  }
  EXPECT_LT(equal, 70);
  EXPECT_LT(equalSeeds, 15);
}

TEST(PerlinNoise, TurbulenceIsTheBooksSum) {
  const PerlinNoise noise(5);
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Vec3f p = place(i);
    double sum = 0.0, weight = 1.0;
    for (int octave = 0; octave < 7; ++octave) {
      sum += weight * noise.noise(p * std::exp2(static_cast<float>(octave)));
      weight *= 0.5;
    }
    EXPECT_NEAR(noise.turbulence(p, 7), std::abs(sum), 1e-6);
    EXPECT_EQ(noise.turbulence(p, 1), std::abs(noise.noise(p)));
  }
}

TEST(NoisePattern, FollowsTheBooksFormulas) {
  const PerlinNoise noise(9);
  const Rgb colour{0.5f, 1.0f, 0.25f};
  const auto pattern = [&](NoiseTexture::Pattern p) {
    return NoisePattern({.pattern = p, .colour = colour, .scale = 4.0f, .octaves = 7, .seed = 9});
  };
  const NoisePattern plain = pattern(NoiseTexture::Pattern::Noise),
                     turbulent = pattern(NoiseTexture::Pattern::Turbulence),
                     marble = pattern(NoiseTexture::Pattern::Marble);
  for (std::uint32_t i = 0; i < 500; ++i) {
    const Vec3f p = place(i);
    EXPECT_NEAR(plain.value(p).g, 0.5f * (1.0f + noise.noise(p * 4.0f)), 1e-6f);
    EXPECT_NEAR(turbulent.value(p).g, std::min(noise.turbulence(p * 4.0f, 7), 1.0f), 1e-6f);
    const double phase = 4.0 * p.z + 10.0 * noise.turbulence(p, 7);
    EXPECT_NEAR(marble.value(p).g, 0.5 * (1.0 + std::sin(phase)), 3e-5);
    EXPECT_FLOAT_EQ(marble.value(p).r, 0.5f * marble.value(p).g);
    EXPECT_FLOAT_EQ(marble.value(p).b, 0.25f * marble.value(p).g);
  }
}

TEST(NoisePattern, TakesPlacesFarAway) {
  for (const auto pattern :
       {NoiseTexture::Pattern::Noise, NoiseTexture::Pattern::Turbulence, NoiseTexture::Pattern::Marble}) {
    const NoisePattern noise({.pattern = pattern, .scale = 1e6f});
    for (const float x : {1e5f, -1e12f, 1e38f}) {
      const float value = noise.value(Vec3f{x, 0.5f, x}).g;
      EXPECT_GE(value, 0.0f);
      EXPECT_LE(value, 1.0f);
    }
  }
}

TEST(NoisePattern, LanesAgreeWithScalars) {
  for (const auto pattern :
       {NoiseTexture::Pattern::Noise, NoiseTexture::Pattern::Turbulence, NoiseTexture::Pattern::Marble}) {
    const NoisePattern noise({.pattern = pattern, .colour = {0.3f, 0.6f, 0.9f}, .scale = 3.0f});
    const auto value = [&](auto x, auto y, auto z) {
      using F = decltype(x);
      return noise.value(Vec3<F>{x * F(40.0f) - F(20.0f), y * F(9.0f), z * F(-30.0f)}).b;
    };
    const auto xs = test::unitNumbers(400), ys = test::unitNumbers(400, 1), zs = test::unitNumbers(400, 2);
    EXPECT_TRUE(test::sameInLanes<4>(value, xs, ys, zs));
    EXPECT_TRUE(test::sameInLanes<8>(value, xs, ys, zs));
    EXPECT_TRUE(test::sameInLanes<16>(value, xs, ys, zs));
  }
}

}  // namespace
}  // namespace steradian
