#include "steradian/accel/shapes/primitives/aligned_quad.h"

#include "steradian/tests/accel/shapes/leaf_test.h"

namespace steradian::test {
namespace {

/// Along two of the axes, in either order and direction.
Quad<float> randomAlignedQuad(Random& random) {
  const std::array<Vec3f, 3> axes{Vec3f{1, 0, 0}, Vec3f{0, 1, 0}, Vec3f{0, 0, 1}};
  const auto first = static_cast<std::size_t>(random.uniform(0.0f, 2.99f));
  const std::size_t second = (first + (random.uniform(0.0f, 1.0f) < 0.5f ? 1u : 2u)) % 3;
  const auto edge = [&] { return random.uniform(0.2f, 2.0f) * (random.uniform(0.0f, 1.0f) < 0.5f ? -1.0f : 1.0f); };
  const float u = edge(), v = edge();
  return {random.point(1.0f), axes[first] * u, axes[second] * v};
}

TEST(AlignedQuad, IsWhatHasEdgesAlongTwoAxes) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Quad<float> quad = randomAlignedQuad(random);
    const auto aligned = AlignedQuad::of(quad);
    ASSERT_TRUE(aligned);
    const Quad<float> again = aligned->quad();
    for (const auto& [a, b] : {std::pair{again.corner, quad.corner}, {again.u, quad.u}, {again.v, quad.v}}) {
      ASSERT_TRUE(a.x == b.x && a.y == b.y && a.z == b.z);
    }
  }
  const Vec3f corner{1, 2, 3};
  EXPECT_FALSE(AlignedQuad::of({corner, {1, 0, 0}, {0, 1, 1e-6f}}));
  EXPECT_FALSE(AlignedQuad::of({corner, {1, 0, 0}, {2, 0, 0}}));
  EXPECT_FALSE(AlignedQuad::of({corner, {1, 0, 0}, {0, 0, 0}}));
  EXPECT_FALSE(AlignedQuad::of({corner, {1e-40f, 0, 0}, {0, 1, 0}}));
}

TEST(AlignedQuad, IsHitWhereAnyQuadIs) {
  Random random(2);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Quad<float> quad = randomAlignedQuad(random);
    const Ray<float> ray = random.rayTowards(quad.corner + quad.u * 0.5f + quad.v * 0.5f, 1.0f, 3.0f);
    const ShapeHit<float> hit = intersect(*AlignedQuad::of(quad), ray), expected = intersect(quad, ray);
    const float toEdge = minimum(minimum(expected.u, 1.0f - expected.u), minimum(expected.v, 1.0f - expected.v));
    if (!(absolute(toEdge) > 1e-4f) || !(absolute(dot(ray.direction, normalize(cross(quad.u, quad.v)))) > 1e-2f))
      continue;
    ASSERT_EQ(hit.valid, expected.valid);
    if (!hit.valid) continue;
    ++hits;
    ASSERT_NEAR(hit.t, expected.t, 1e-4f);
    ASSERT_NEAR(hit.u, expected.u, 1e-4f);
    ASSERT_NEAR(hit.v, expected.v, 1e-4f);
  }
  EXPECT_GT(hits, 2000);
}

TEST(AlignedQuad, RaysInItsPlaneAndParallelToItMiss) {
  const AlignedQuad quad = *AlignedQuad::of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  for (const float z : {-0.5f, -1e-12f, 0.0f, 1e-12f, 0.5f}) {
    EXPECT_FALSE(intersect(quad, Ray<float>{{-1.0f, 0.5f, z}, {1.0f, 0.0f, 0.0f}}).valid);
    EXPECT_FALSE(intersect(quad, Ray<float>{{0.5f, 0.5f, z}, {0.0f, -1.0f, -0.0f}}).valid);
  }
}

TEST(AlignedQuad, NeighboursLeaveNoCrack) {
  Random random(3);
  for (int i = 0; i < 20000; ++i) {
    const float edge = random.uniform(0.1f, 0.9f);
    const AlignedQuad left = *AlignedQuad::of({{0, 0, 0}, {edge, 0, 0}, {0, 1, 0}});
    const AlignedQuad right = *AlignedQuad::of({{edge, 0, 0}, {1.0f - edge, 0, 0}, {0, 1, 0}});
    const Vec3f target{edge, random.uniform(0.1f, 0.9f), 0.0f};
    const Vec3f origin = target + Vec3f{random.uniform(-1.0f, 1.0f), random.uniform(-1.0f, 1.0f), 2.0f};
    const Ray<float> ray{origin, normalize(target - origin)};
    ASSERT_TRUE(intersect(left, ray).valid || intersect(right, ray).valid);
  }
}

TEST(AlignedQuad, OneQuadInLanesOfRaysGivesTheSameBits) {
  using F = Lanes<8>;
  Random random(4);
  for (int round = 0; round < 1000; ++round) {
    const AlignedQuad quad = *AlignedQuad::of(randomAlignedQuad(random));
    Ray<F> rays;
    for (int i = 0; i < 8; ++i) setLane(rays, i, random.rayTowards(quad.quad().corner, 1.5f, 3.0f));
    const ShapeHit<F> hits = intersect(quad, RayByAxis<F>(rays), rays.tMin, rays.tMax);
    for (int i = 0; i < 8; ++i) ASSERT_NO_FATAL_FAILURE(expectLane(hits, i, intersect(quad, lane(rays, i))));
  }
}

}  // namespace
}  // namespace steradian::test
