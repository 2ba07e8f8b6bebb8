#include "steradian/accel/shapes/primitives/moving_sphere.h"

#include <gtest/gtest.h>

#include "steradian/accel/shapes/primitives/shape_at.h"
#include "steradian/tests/accel/shapes/leaf_test.h"

namespace steradian::test {
namespace {

MovingSphere<float> randomSphere(Random& random) {
  return {random.point(1.5f), random.point(1.0f), random.uniform(0.1f, 0.5f)};
}

TEST(MovingSphere, IsASphereAtEachTime) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const MovingSphere<float> sphere = randomSphere(random);
    Ray<float> ray = random.rayTowards(sphere.center, 1.0f, 4.0f);
    ray.time = random.uniform(0.0f, kOneMinusEpsilon);
    const Vec3f there = sphere.center + sphere.move * ray.time;
    const ShapeHit<float> expected = intersect(Sphere<float>{there, sphere.radius}, ray), hit = intersect(sphere, ray);
    ASSERT_NO_FATAL_FAILURE(expectLane(hit, 0, expected));
    hits += hit.valid ? 1 : 0;
  }
  EXPECT_GT(hits, 1500);
}

TEST(MovingSphere, WidthsAgree) {
  expectWidthsAgree(2, randomSphere, [](const MovingSphere<float>(&s)[8]) {
    return MovingSphere<Lanes<8>>{gatherVectors(s, &MovingSphere<float>::center),
                                  gatherVectors(s, &MovingSphere<float>::move),
                                  gatherLanes(s, [](const auto& sphere) { return sphere.radius; })};
  });
}

TEST(MovingSphere, BoundsHoldAllTimes) {
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const MovingSphere<float> sphere = randomSphere(random);
    const Bounds3 bounds = boundsOf(sphere);
    for (const float time : {0.0f, random.uniform(0.0f, 1.0f), kOneMinusEpsilon}) {
      Bounds3 both = bounds;
      both.include(boundsOf(sphere.at(time)));
      ASSERT_EQ(length(both.low - bounds.low), 0.0f);
      ASSERT_EQ(length(both.high - bounds.high), 0.0f);
    }
  }
}

TEST(MovingSphere, SetsMayMixBothKinds) {
  SphereSet set;
  set.add({1.0f, 2.0f, 3.0f}, 0.5f);
  EXPECT_FALSE(areMoving(set));
  set.addMoving({0.0f, 1.0f, 0.0f}, {0.0f, 1.5f, 0.0f}, 0.2f);
  set.add({4.0f, 5.0f, 6.0f}, 0.5f);
  EXPECT_TRUE(areMoving(set));
  EXPECT_EQ(movingSphereAt(set, 0).move.y, 0.0f);
  EXPECT_EQ(movingSphereAt(set, 1).at(0.5f).center.y, 1.25f);
  EXPECT_EQ(movingSphereAt(set, 2).at(0.5f).center.y, 5.0f);
  SphereSet resting;
  resting.addMoving({1.0f, 2.0f, 3.0f}, {1.0f, 2.0f, 3.0f}, 0.5f);
  EXPECT_FALSE(areMoving(resting));
}

}  // namespace
}  // namespace steradian::test
