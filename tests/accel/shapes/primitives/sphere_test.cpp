#include "steradian/accel/shapes/primitives/sphere.h"

#include <algorithm>
#include <cmath>

#include "steradian/tests/accel/shapes/leaf_test.h"

namespace steradian::test {
namespace {

Truth truthOf(const Sphere<float>& sphere, const Ray<float>& ray) {
  const Vec3d d = toDouble(ray.direction), f = toDouble(ray.origin) - toDouble(sphere.center);
  const double r = sphere.radius, a = dot(d, d), b = -dot(f, d) / a;
  const Vec3d perpendicular = f + d * b;
  const double distance = std::sqrt(dot(perpendicular, perpendicular));
  Truth truth;
  truth.margin = std::min(std::abs(distance - r), std::abs(std::sqrt(dot(f, f)) - r));
  if (distance > r) return truth;
  const double half = std::sqrt((r * r - distance * distance) / a);
  truth.t = b - half > ray.tMin ? b - half : b + half;
  truth.hit = truth.t > ray.tMin && truth.t < ray.tMax;
  return truth;
}

Sphere<float> randomSphere(Random& random) { return {random.point(1.0f), random.uniform(0.1f, 1.5f)}; }

TEST(Sphere, AgreesWithDoublePrecisionOnRandomRays) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Sphere<float> sphere = randomSphere(random);
    const Ray<float> ray = random.rayTowards(sphere.center, 1.5f * sphere.radius, 3.0f);
    const Truth truth = truthOf(sphere, ray);
    hits += truth.hit;
    // Near grazing rays the distance changes as the square root of the margin.
    ASSERT_NO_FATAL_FAILURE(expectAgrees(intersect(sphere, ray), truth, 1e-5, 1e-3));
    ASSERT_NO_FATAL_FAILURE(expectAgrees(intersect(sphere, ray), truth, 1e-2, 1e-5));
  }
  EXPECT_GT(hits, 5000);
}

TEST(Sphere, DirectionsNeedNotBeUnitLength) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const Sphere<float> sphere = randomSphere(random);
    Ray<float> ray = random.rayTowards(sphere.center, 1.5f * sphere.radius, 3.0f);
    const float scale = random.uniform(0.01f, 100.0f);
    ray.direction *= scale;
    ASSERT_NO_FATAL_FAILURE(expectAgrees(intersect(sphere, ray), truthOf(sphere, ray), 1e-2, 1e-5 / scale));
  }
}

TEST(Sphere, GroundOfRadiusThousandIsExactToItsCoordinates) {
  const Sphere<float> ground{{0.0f, -1000.0f, 0.0f}, 1000.0f};
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const Vec3f origin{random.uniform(-10.0f, 10.0f), random.uniform(0.5f, 5.0f), random.uniform(-10.0f, 10.0f)};
    Vec3f direction = random.direction();
    direction.y = -std::abs(direction.y) - 0.2f;
    const Ray<float> ray{origin, normalize(direction)};
    // One ulp of 1000 is 6e-5; the ray hits the ground at a sine of about 0.2 or more.
    ASSERT_NO_FATAL_FAILURE(expectAgrees(intersect(ground, ray), truthOf(ground, ray), 1e-3, 2e-3));
  }
}

TEST(Sphere, SmallOnesFarAwayAreHitInTheMiddleAndMissedBeside) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const Vec3f axis = random.direction();
    const Sphere<float> sphere{axis * 1000.0f, 0.01f};
    const Ray<float> at{{0.0f, 0.0f, 0.0f}, normalize(sphere.center)};
    ASSERT_TRUE(intersect(sphere, at).valid);
    ASSERT_NEAR(intersect(sphere, at).t, 1000.0f - 0.01f, 3e-4f);
    const Vec3f beside = normalize(cross(axis, random.direction())) * 0.02f;
    ASSERT_FALSE(intersect(sphere, Ray<float>{{0.0f, 0.0f, 0.0f}, normalize(sphere.center + beside)}).valid);
  }
}

TEST(Sphere, TMinAndTMaxChooseTheRoot) {
  const Sphere<float> sphere{{0.0f, 0.0f, 0.0f}, 1.0f};
  Ray<float> ray{{0.0f, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}};
  EXPECT_FLOAT_EQ(intersect(sphere, ray).t, 2.0f);
  ray.tMin = 2.5f;
  EXPECT_FLOAT_EQ(intersect(sphere, ray).t, 4.0f);
  ray.tMax = 4.0f;
  EXPECT_FALSE(intersect(sphere, ray).valid);
  ray = {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}};
  EXPECT_FLOAT_EQ(intersect(sphere, ray).t, 1.0f);
  ray = {{0.0f, 0.0f, 3.0f}, {0.0f, 0.0f, 1.0f}};
  EXPECT_FALSE(intersect(sphere, ray).valid);
}

TEST(Sphere, NaNIsNeverHit) {
  const float nan = std::nanf("");
  EXPECT_FALSE(intersect(Sphere<float>{{nan, nan, nan}, nan}, Ray<float>{{}, {0.0f, 0.0f, 1.0f}}).valid);
}

TEST(Sphere, EveryWidthGivesTheSameBits) {
  expectWidthsAgree(5, randomSphere, [](const auto& s) {
    return Sphere<Lanes<8>>{gatherVectors(s, &Sphere<float>::center), gatherLanes(s, [](auto& x) { return x.radius; })};
  });
}

}  // namespace
}  // namespace steradian::test
