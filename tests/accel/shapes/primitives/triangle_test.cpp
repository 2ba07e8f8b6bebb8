#include "steradian/accel/shapes/primitives/triangle.h"

#include <algorithm>
#include <cmath>

#include "steradian/tests/accel/shapes/leaf_test.h"

namespace steradian::test {
namespace {

struct TriangleTruth : Truth {
  double u = 0.0, v = 0.0;
};

TriangleTruth truthOf(const Triangle<float>& triangle, const Ray<float>& ray) {
  const Vec3d a = toDouble(triangle.a), ab = toDouble(triangle.b) - a, ac = toDouble(triangle.c) - a;
  const Vec3d d = toDouble(ray.direction), n = cross(ab, ac), f = a - toDouble(ray.origin);
  TriangleTruth truth;
  truth.t = dot(f, n) / dot(d, n);
  const Vec3d p = d * truth.t - f;
  truth.u = dot(cross(p, ac), n) / dot(n, n);
  truth.v = dot(cross(ab, p), n) / dot(n, n);
  const double inside = std::min({truth.u, truth.v, 1.0 - truth.u - truth.v});
  truth.margin = std::min({std::abs(inside), std::abs(truth.t), std::abs(dot(d, n)) / std::sqrt(dot(n, n))});
  truth.hit = inside > 0.0 && truth.t > ray.tMin && truth.t < ray.tMax;
  return truth;
}

Triangle<float> randomTriangle(Random& random) {
  for (;;) {
    const Triangle<float> t{random.point(1.5f), random.point(1.5f), random.point(1.5f)};
    if (length(cross(t.b - t.a, t.c - t.a)) > 0.5f) return t;
  }
}

TEST(Triangle, AgreesWithDoublePrecisionOnRandomRays) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Triangle<float> triangle = randomTriangle(random);
    const Vec3f middle = (triangle.a + triangle.b + triangle.c) * (1.0f / 3.0f);
    const Ray<float> ray = random.rayTowards(middle, 1.0f, 3.0f);
    const TriangleTruth truth = truthOf(triangle, ray);
    const ShapeHit<float> hit = intersect(triangle, ray);
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

TEST(Triangle, AClosedSurfaceDoesNotLeak) {
  // An octahedron, and rays from inside towards points of its edges.
  const Vec3f corner[6] = {{1.0f, 0.1f, 0.0f},  {-1.0f, 0.0f, 0.2f}, {0.0f, 1.0f, 0.1f},
                           {0.1f, -1.0f, 0.0f}, {0.0f, 0.1f, 1.0f},  {0.0f, 0.0f, -1.0f}};
  Random random(2);
  for (int i = 0; i < 20000; ++i) {
    const int a = static_cast<int>(random.uniform(0.0f, 6.0f)) % 6;
    const int b = (a / 2 * 2 + 2 + static_cast<int>(random.uniform(0.0f, 4.0f)) % 4) % 6;
    const Vec3f target = corner[a] + (corner[b] - corner[a]) * random.uniform(0.001f, 0.999f);
    const Vec3f origin = random.point(0.2f);
    const Ray<float> ray{origin, normalize(target - origin)};
    bool hit = false;
    for (int face = 0; face < 8; ++face) {
      const Vec3f x = corner[face & 1], y = corner[2 + (face >> 1 & 1)], z = corner[4 + (face >> 2)];
      hit = hit || intersect(Triangle<float>{x, y, z}, ray).valid;
    }
    ASSERT_TRUE(hit) << i;
  }
}

TEST(Triangle, RaysInOrBesideItsPlaneMissAndNaNIsNeverHit) {
  const Triangle<float> triangle{{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
  for (const float z : {0.0f, 1.0f}) {
    EXPECT_FALSE(intersect(triangle, Ray<float>{{-1.0f, 0.2f, z}, {1.0f, 0.0f, 0.0f}}).valid);
    EXPECT_FALSE(intersect(triangle, Ray<float>{{-1.0f, 0.0f, z}, {1.0f, 0.0f, 0.0f}}).valid);
  }
  const float nan = std::nanf("");
  const Vec3f all{nan, nan, nan};
  EXPECT_FALSE(intersect(Triangle<float>{all, all, all}, Ray<float>{{}, {0.0f, 0.0f, 1.0f}}).valid);
}

TEST(Triangle, EveryWidthGivesTheSameBits) {
  expectWidthsAgree(3, randomTriangle, [](const auto& t) {
    return Triangle<Lanes<8>>{gatherVectors(t, &Triangle<float>::a), gatherVectors(t, &Triangle<float>::b),
                              gatherVectors(t, &Triangle<float>::c)};
  });
}

}  // namespace
}  // namespace steradian::test
