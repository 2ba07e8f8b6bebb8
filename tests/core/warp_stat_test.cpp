#include <gtest/gtest.h>

#include <cmath>

#include "steradian/core/warp.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using namespace test;

/// The check for a warp of directions.
template <class Warp>
testing::AssertionResult check(const Warp& warp, double focus = 1.5707963) {
  CheckOptions options;
  options.grid.focus = focus;
  return checkDirectionSampler(
      [&](float, Vec2f u) {
        const Vec3f w = warp.sample(u);
        return DirectionSample<float>{w, warp.pdf(w)};
      },
      [&](Vec3f w) { return warp.pdf(w); }, options);
}

template <class Warp>
testing::AssertionResult checkPlane(const Warp& warp, const Rectangle& domain) {
  CheckOptions options;
  options.domain = domain;
  return checkPlaneSampler(
      [&](float, Vec2f u) {
        const Vec2f p = warp.sample(u);
        return PlaneSample{p, warp.pdf(p)};
      },
      [&](Vec2f p) { return warp.pdf(p); }, options);
}

TEST(WarpStatistics, Sphere) { EXPECT_TRUE(check(UniformSphere<float>{})); }
TEST(WarpStatistics, Hemisphere) { EXPECT_TRUE(check(UniformHemisphere<float>{})); }
TEST(WarpStatistics, CosineHemisphere) { EXPECT_TRUE(check(CosineHemisphere<float>{})); }

TEST(WarpStatistics, Cones) {
  for (const double angle : {3.1, 1.5707963, 0.5, 1e-2, 1e-5, 1e-10}) {
    const double half = std::sin(0.5 * angle);
    EXPECT_TRUE(check(UniformCone<float>{static_cast<float>(2.0 * half * half)}, 1.5 * angle)) << angle;
  }
}

TEST(WarpStatistics, Disk) { EXPECT_TRUE(checkPlane(UniformDisk<float>{}, {-1.0, 1.0, -1.0, 1.0})); }
TEST(WarpStatistics, Triangle) { EXPECT_TRUE(checkPlane(UniformTriangle<float>{}, {0.0, 1.0, 0.0, 1.0})); }

TEST(WarpStatistics, Flight) {
  const ExponentialFlight<float> flight{2.5f};
  CheckOptions options;
  options.domain = {0.0, 7.0, 0.0, 1.0};
  options.columns = 40;
  options.rows = 1;
  EXPECT_TRUE(checkPlaneSampler(
      [&](float, Vec2f u) {
        const float t = flight.sample(u.x);
        return PlaneSample{{t, u.y}, flight.pdf(t)};
      },
      [&](Vec2f p) { return flight.pdf(p.x); }, options));
}

}  // namespace
}  // namespace steradian
