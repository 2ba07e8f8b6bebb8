#include "steradian/core/transport/ray_offset.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/core/sampling/warp.h"
#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

/// Signed height of p over the plane through q with normal n, in double.
double height(Vec3f p, Vec3f q, Vec3f error, Vec3f n, double sign) {
  // The true point is the computed one moved by its error, as far as it can be towards or from the ray's side.
  const auto axis = [&](float pi, float qi, float ei, float ni) {
    return (static_cast<double>(pi) -
            (static_cast<double>(qi) + sign * std::copysign(static_cast<double>(ei), static_cast<double>(ni)))) *
           ni;
  };
  return axis(p.x, q.x, error.x, n.x) + axis(p.y, q.y, error.y, n.y) + axis(p.z, q.z, error.z, n.z);
}

TEST(RayOffset, OriginsLeaveTheSurfaceAtEveryScale) {
  const auto a = test::unitNumbers(500), b = test::unitNumbers(500, 1), c = test::unitNumbers(500, 2);
  for (const float scale : {1e-3f, 1.0f, 1e6f}) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Vec3f n = UniformSphere<float>::sample({a[i], b[i]});
      const Vec3f position = UniformSphere<float>::sample({b[i], c[i]}) * scale;
      const Vec3f error = absolute(position) * gammaBound(5);
      const Vec3f direction = UniformSphere<float>::sample({c[i], a[i]});
      const double side = dot(direction, n) < 0.0f ? -1.0 : 1.0;
      const Vec3f origin = offsetOrigin(position, error, n, direction);
      EXPECT_GT(side * height(origin, position, error, n, side), 0.0) << "scale " << scale << " case " << i;
      // And by no more than needed: the error both ways, and two steps of rounding.
      const double reach = dot(absolute(n), error) + 4e-7 * scale;
      EXPECT_LT(side * height(origin, position, error, n, side), 2.0 * reach);
    }
  }
}

TEST(RayOffset, ExactSurfacesAreLeftToo) {
  const Vec3f up{0.0f, 1.0f, 0.0f};
  EXPECT_GT(offsetOrigin(Vec3f{3.0f, 0.0f, 2.0f}, {1e-6f, 0.0f, 1e-6f}, up, up).y, 0.0f);
  EXPECT_LT(offsetOrigin(Vec3f{3.0f, 0.0f, 2.0f}, {1e-6f, 0.0f, 1e-6f}, up, -up).y, 0.0f);
  EXPECT_EQ(offsetOrigin(Vec3f{3.0f, 0.0f, 2.0f}, {1e-6f, 0.0f, 1e-6f}, up, up).x, 3.0f);
}

TEST(RayOffset, FreePointsStay) {
  const ScatterPoint<float> from{{1.0f, 2.0f, 3.0f}, {}, {}, 0.25f};
  const Ray<float> ray = spawnRay(from, {0.0f, 1.0f, 0.0f}, 7.0f);
  EXPECT_EQ(ray.origin.x, 1.0f);
  EXPECT_EQ(ray.origin.y, 2.0f);
  EXPECT_EQ(ray.origin.z, 3.0f);
  EXPECT_EQ(ray.tMax, 7.0f);
  EXPECT_EQ(ray.time, 0.25f);
  EXPECT_EQ(ray.tMin, 0.0f);
}

TEST(RayOffset, LanesAgreeWithScalars) {
  const auto x = test::numbers(128, -5.0f, 5.0f), u = test::unitNumbers(128), v = test::unitNumbers(128, 1);
  const auto moved = [](auto a, auto b, auto c) {
    using F = decltype(a);
    const Vec3<F> n = UniformSphere<F>::sample({b, c});
    return offsetOrigin(Vec3<F>{a, b, c}, Vec3<F>{b, c, b} * F(1e-6f), n, UniformSphere<F>::sample({c, b}));
  };
  EXPECT_TRUE(test::sameInLanes<8>(moved, x, u, v));
}

}  // namespace
}  // namespace steradian
