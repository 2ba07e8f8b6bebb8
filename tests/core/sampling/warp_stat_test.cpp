#include "steradian/core/sampling/warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "steradian/tests/support/proof.h"

namespace steradian {
namespace {

using namespace test;

constexpr Rectangle kAroundDisk{-1.0, 1.0, -1.0, 1.0};

TEST(WarpStatistics, Sphere) { EXPECT_TRUE(prove<UniformSphere>()); }
TEST(WarpStatistics, Hemisphere) { EXPECT_TRUE(prove<UniformHemisphere>()); }
TEST(WarpStatistics, CosineHemisphere) { EXPECT_TRUE(prove<CosineHemisphere>()); }

TEST(WarpStatistics, Cones) {
  for (const double angle : {3.14159265, 1.5707963, 0.5, 1e-2, 1e-5, 1e-10, 1e-18}) {
    const double half = std::sin(0.5 * angle);
    CheckOptions options;
    options.grid.focus = 1.5 * angle;
    EXPECT_TRUE(prove(
        [&](auto f) {
          using F = decltype(f);
          return UniformCone<F>{F(static_cast<float>(2.0 * half * half))};
        },
        options))
        << angle;
  }
}

TEST(WarpStatistics, PowerCosines) {
  for (const float n : {0.0f, 1.0f, 3.0f, 40.0f, 1000.0f}) {
    CheckOptions options;
    if (n > 3.0f) options.grid.focus = 3.0 / std::sqrt(n + 1.0);
    options.inverseTolerance = std::max(2e-6, 1e-7 * static_cast<double>(n));
    EXPECT_TRUE(prove([n](auto f) { return PowerCosineHemisphere<decltype(f)>{decltype(f)(n)}; }, options)) << n;
  }
}

TEST(WarpStatistics, Disks) {
  EXPECT_TRUE(prove<UniformDisk>({.domain = kAroundDisk}));
  EXPECT_TRUE(prove<UniformDiskPolar>({.domain = kAroundDisk}));
}

TEST(WarpStatistics, Triangle) { EXPECT_TRUE(prove<UniformTriangle>()); }

TEST(WarpStatistics, Parallelograms) {
  const auto make = [](Vec2f a, Vec2f b) {
    return [a, b](auto f) {
      using F = decltype(f);
      return UniformParallelogram<F>{{F(a.x), F(a.y)}, {F(b.x), F(b.y)}};
    };
  };
  EXPECT_TRUE(prove(make({1.0f, 0.2f}, {-0.5f, 0.7f}), {.domain = {-0.5, 1.0, 0.0, 0.9}}));
  // Clockwise, and a sliver of a thousandth.
  EXPECT_TRUE(prove(make({-0.5f, 0.7f}, {1.0f, 0.2f}), {.domain = {-0.5, 1.0, 0.0, 0.9}}));
  EXPECT_TRUE(prove(make({1.0f, 0.0f}, {0.3f, 1e-3f}), {.domain = {0.0, 1.3, 0.0, 1e-3}}));
}

TEST(WarpStatistics, Flights) {
  for (const float rate : {1e-6f, 2.5f, 3e4f}) {
    EXPECT_TRUE(prove([rate](auto f) { return ExponentialFlight<decltype(f)>{decltype(f)(rate)}; },
                      {.domain = {0.0, 17.5 / static_cast<double>(rate), 0.0, 1.0}}))
        << rate;
  }
}

}  // namespace
}  // namespace steradian
