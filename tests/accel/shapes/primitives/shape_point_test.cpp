#include "steradian/accel/shapes/primitives/shape_point.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/core/samplers/rng.h"

namespace steradian {
namespace {

float number(std::uint32_t index, std::uint32_t key, float low, float high) {
  return low + (high - low) * toUnitFloat<float>(randomWords<std::uint32_t>(index, key, 3u, 4u)[0]);
}

/// Upright boxes of edge 2 around places up to 10^6 from the origin, hit from above: the true height of the point is
/// that of the face, and the error that comes with it covers the difference.
TEST(ShapePoint, TheErrorOfFarBoxesCoversTheirPlace) {
  double largest = 0.0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const float reach = number(i, 1, 10.0f, 1e6f);
    const Vec3f half{1.0f, number(i, 2, 0.3f, 1.0f), 1.0f};
    const Vec3f center{number(i, 3, -reach, reach), number(i, 4, -reach, reach), number(i, 5, -reach, reach)};
    const Box<float> box{center, half, {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}}};
    const Ray<float> ray{center + Vec3f{0.0f, 100.0f, 0.0f}, {0.0f, -1.0f, 0.0f}};
    const ShapeHit<float> hit = intersect(box, ray);
    if (!hit.valid) continue;
    const ShapePoint<float> point = shapePoint(box, ray, hit);
    EXPECT_EQ(point.normal.y, 1.0f);
    const double truth = static_cast<double>(center.y) + static_cast<double>(half.y);
    const double error = std::abs(static_cast<double>(point.position.y) - truth);
    EXPECT_LE(error, static_cast<double>(point.error.y)) << i;
    largest = std::max(largest, error);
  }
  EXPECT_GT(largest, 1e-3);  // else the boxes were not far enough for the test to mean anything
}

/// The point of a sphere lies on it, however far the ray came from.
TEST(ShapePoint, SpheresPutThePointBack) {
  for (std::uint32_t i = 0; i < 500; ++i) {
    const Sphere<float> sphere{{0.0f, 0.0f, 0.0f}, number(i, 1, 0.5f, 2.0f)};
    const Vec3f from{number(i, 2, 900.0f, 1000.0f), number(i, 3, -100.0f, 100.0f), number(i, 4, -100.0f, 100.0f)};
    const Ray<float> ray{from, normalize(-from)};
    const ShapeHit<float> hit = intersect(sphere, ray);
    ASSERT_TRUE(hit.valid);
    EXPECT_NEAR(length(shapePoint(sphere, ray, hit).position), sphere.radius, 3e-7f * sphere.radius);
  }
}

}  // namespace
}  // namespace steradian
