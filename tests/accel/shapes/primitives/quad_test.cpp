#include "steradian/accel/shapes/primitives/quad.h"

#include <algorithm>
#include <cmath>

#include "steradian/tests/accel/shapes/leaf_test.h"

namespace steradian::test {
namespace {

struct QuadTruth : Truth {
  double u = 0.0, v = 0.0;
};

QuadTruth truthOf(const Quad<float>& quad, const Ray<float>& ray) {
  const Vec3d u = toDouble(quad.u), v = toDouble(quad.v), d = toDouble(ray.direction);
  const Vec3d n = cross(u, v), f = toDouble(quad.corner) - toDouble(ray.origin);
  QuadTruth truth;
  truth.t = dot(f, n) / dot(d, n);
  const Vec3d p = d * truth.t - f;
  truth.u = dot(cross(p, v), n) / dot(n, n);
  truth.v = dot(cross(u, p), n) / dot(n, n);
  const auto inside = [](double x) { return std::min(x, 1.0 - x); };
  truth.margin = std::min({std::abs(inside(truth.u)), std::abs(inside(truth.v)), std::abs(truth.t),
                           std::abs(dot(d, n)) / std::sqrt(dot(n, n))});
  truth.hit = inside(truth.u) > 0.0 && inside(truth.v) > 0.0 && truth.t > ray.tMin && truth.t < ray.tMax;
  return truth;
}

Quad<float> randomQuad(Random& random) {
  for (;;) {
    const Vec3f u = random.direction(), v = random.direction();
    if (length(cross(u, v)) > 0.2f) {
      return {random.point(1.0f), u * random.uniform(0.2f, 2.0f), v * random.uniform(0.2f, 2.0f)};
    }
  }
}

TEST(Quad, AgreesWithDoublePrecisionOnRandomRays) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Quad<float> quad = randomQuad(random);
    const Ray<float> ray = random.rayTowards(quad.corner + quad.u * 0.5f + quad.v * 0.5f, 1.0f, 3.0f);
    const QuadTruth truth = truthOf(quad, ray);
    const ShapeHit<float> hit = intersect(quad, ray);
    ASSERT_NO_FATAL_FAILURE(expectAgrees(hit, truth, 1e-3, 2e-3));
    ASSERT_NO_FATAL_FAILURE(expectAgrees(hit, truth, 5e-2, 5e-5));
    if (truth.hit && truth.margin > 5e-2) {
      ASSERT_NEAR(hit.u, truth.u, 1e-4);
      ASSERT_NEAR(hit.v, truth.v, 1e-4);
    }
    hits += truth.hit;
  }
  EXPECT_GT(hits, 2000);
}

TEST(Quad, NeighboursLeaveNoCrack) {
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const Quad<float> left = randomQuad(random);
    const Quad<float> right{left.corner + left.u, left.u, left.v};
    const Vec3f target = right.corner + right.v * random.uniform(0.01f, 0.99f);
    const Vec3f n = normalize(cross(left.u, left.v));
    const Vec3f origin = target + normalize(n + random.direction() * 0.7f) * random.uniform(0.5f, 3.0f);
    const Ray<float> ray{origin, normalize(target - origin)};
    ASSERT_TRUE(intersect(left, ray).valid || intersect(right, ray).valid);
  }
}

TEST(Quad, EdgesBelongToIt) {
  const Quad<float> quad{{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
  for (const float x : {0.0f, 0.5f, 1.0f}) {
    for (const float y : {0.0f, 0.5f, 1.0f}) {
      EXPECT_TRUE(intersect(quad, Ray<float>{{x, y, 2.0f}, {0.0f, 0.0f, -1.0f}}).valid);
      EXPECT_TRUE(intersect(quad, Ray<float>{{x, y, -2.0f}, {0.0f, 0.0f, 1.0f}}).valid);
    }
  }
  EXPECT_FALSE(intersect(quad, Ray<float>{{1.001f, 0.5f, 2.0f}, {0.0f, 0.0f, -1.0f}}).valid);
  EXPECT_FALSE(intersect(quad, Ray<float>{{0.5f, -0.001f, 2.0f}, {0.0f, 0.0f, -1.0f}}).valid);
}

TEST(Quad, RaysInOrBesideItsPlaneMiss) {
  const Quad<float> quad{{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
  for (const float z : {0.0f, 1.0f}) {
    for (const Vec3f d : {Vec3f{1.0f, 0.0f, 0.0f}, Vec3f{0.0f, -1.0f, 0.0f}, Vec3f{0.6f, 0.8f, 0.0f}}) {
      for (const Vec3f o : {Vec3f{0.5f, 0.5f, z}, Vec3f{0.0f, 0.0f, z}, Vec3f{-1.0f, 0.0f, z}}) {
        EXPECT_FALSE(intersect(quad, Ray<float>{o, d}).valid);
      }
    }
  }
}

TEST(Quad, TMinAndTMaxAreExcluded) {
  const Quad<float> quad{{-1.0f, -1.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}};
  Ray<float> ray{{0.0f, 0.0f, 2.0f}, {0.0f, 0.0f, -1.0f}};
  ray.tMax = 2.0f;
  EXPECT_FALSE(intersect(quad, ray).valid);
  ray.tMax = std::nextafter(2.0f, 3.0f);
  EXPECT_TRUE(intersect(quad, ray).valid);
  ray.tMin = 2.0f;
  EXPECT_FALSE(intersect(quad, ray).valid);
}

TEST(Quad, NaNIsNeverHit) {
  const float nan = std::nanf("");
  const Vec3f all{nan, nan, nan};
  EXPECT_FALSE(intersect(Quad<float>{all, all, all}, Ray<float>{{}, {0.0f, 0.0f, 1.0f}}).valid);
}

TEST(Quad, EveryWidthGivesTheSameBits) {
  expectWidthsAgree(3, randomQuad, [](const auto& q) {
    return Quad<Lanes<8>>{gatherVectors(q, &Quad<float>::corner), gatherVectors(q, &Quad<float>::u),
                          gatherVectors(q, &Quad<float>::v)};
  });
}

}  // namespace
}  // namespace steradian::test
