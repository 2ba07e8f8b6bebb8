#include "steradian/accel/shapes/primitives/disk.h"

#include <algorithm>
#include <cmath>

#include "steradian/tests/accel/shapes/leaf_test.h"

namespace steradian::test {
namespace {

Truth truthOf(const Disk<float>& disk, const Ray<float>& ray) {
  const Vec3d n = toDouble(disk.normal), d = toDouble(ray.direction), f = toDouble(ray.origin) - toDouble(disk.center);
  Truth truth;
  truth.t = -dot(f, n) / dot(d, n);
  const Vec3d p = f + d * truth.t;
  const double distance = std::sqrt(dot(p, p));
  truth.margin =
      std::min({std::abs(distance - static_cast<double>(disk.radius)), std::abs(truth.t), std::abs(dot(d, n))});
  truth.hit = distance < static_cast<double>(disk.radius) && truth.t > ray.tMin && truth.t < ray.tMax;
  return truth;
}

Disk<float> randomDisk(Random& random) { return {random.point(1.0f), random.direction(), random.uniform(0.2f, 2.0f)}; }

TEST(Disk, AgreesWithDoublePrecisionOnRandomRays) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Disk<float> disk = randomDisk(random);
    const Ray<float> ray = random.rayTowards(disk.center, 1.5f * disk.radius, 3.0f);
    const Truth truth = truthOf(disk, ray);
    ASSERT_NO_FATAL_FAILURE(expectAgrees(intersect(disk, ray), truth, 1e-3, 1e-2));
    ASSERT_NO_FATAL_FAILURE(expectAgrees(intersect(disk, ray), truth, 5e-2, 1e-4));
    hits += truth.hit;
  }
  EXPECT_GT(hits, 4000);
}

TEST(Disk, RaysInOrBesideItsPlaneMiss) {
  const Disk<float> disk{{0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 1.0f};
  for (const Vec3f o : {Vec3f{0.0f, 0.0f, 0.0f}, Vec3f{-2.0f, 0.0f, 0.0f}, Vec3f{-2.0f, 0.5f, 0.0f}}) {
    EXPECT_FALSE(intersect(disk, Ray<float>{o, {1.0f, 0.0f, 0.0f}}).valid);
  }
}

TEST(Disk, TheRimBelongsToItAndBothSidesAreHit) {
  const Disk<float> disk{{0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 1.0f};
  EXPECT_TRUE(intersect(disk, Ray<float>{{1.0f, 2.0f, 0.0f}, {0.0f, -1.0f, 0.0f}}).valid);
  EXPECT_TRUE(intersect(disk, Ray<float>{{0.0f, -2.0f, -1.0f}, {0.0f, 1.0f, 0.0f}}).valid);
  EXPECT_FALSE(intersect(disk, Ray<float>{{1.001f, 2.0f, 0.0f}, {0.0f, -1.0f, 0.0f}}).valid);
}

TEST(Disk, NaNIsNeverHit) {
  const float nan = std::nanf("");
  EXPECT_FALSE(intersect(Disk<float>{{nan, nan, nan}, {nan, nan, nan}, nan}, Ray<float>{{}, {0.0f, 1.0f, 0.0f}}).valid);
}

TEST(Disk, EveryWidthGivesTheSameBits) {
  expectWidthsAgree(2, randomDisk, [](const auto& d) {
    return Disk<Lanes<8>>{gatherVectors(d, &Disk<float>::center), gatherVectors(d, &Disk<float>::normal),
                          gatherLanes(d, [](auto& x) { return x.radius; })};
  });
}

}  // namespace
}  // namespace steradian::test
