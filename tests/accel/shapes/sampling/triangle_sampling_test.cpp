#include "steradian/accel/shapes/sampling/triangle_sampling.h"

#include "steradian/tests/accel/shapes/target_check.h"

namespace steradian::test {
namespace {

const Triangle<float> kTriangle{{-1.0f, -1.0f, 1.0f}, {1.0f, -1.0f, 1.5f}, {-1.0f, 2.0f, 1.0f}};
const Triangle<float> kSliver{{-1.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 1.0f}, {1.0f, 0.002f, 1.0f}};

Vec3f middleOf(const Triangle<float>& t) { return t.a * 0.3f + t.b * 0.3f + t.c * 0.4f; }

TEST(TriangleSampling, PositionsLieOnTheTriangle) {
  EXPECT_FLOAT_EQ(area(Triangle<float>{{}, {2.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 3.0f}}), 3.0f);
  for (const Vec2f u : unitPoints(100)) {
    const PositionSample<float> p = samplePosition(kTriangle, u);
    const Vec3f n = normalAt(kTriangle, p.position);
    EXPECT_NEAR(dot(p.position - kTriangle.a, n), 0.0, 1e-6);
    EXPECT_GE(dot(cross(kTriangle.b - kTriangle.a, p.position - kTriangle.a), n), -1e-6f);
    EXPECT_GE(dot(cross(kTriangle.c - kTriangle.b, p.position - kTriangle.b), n), -1e-6f);
    EXPECT_GE(dot(cross(kTriangle.a - kTriangle.c, p.position - kTriangle.c), n), -1e-6f);
    EXPECT_FLOAT_EQ(p.pdf * area(kTriangle), 1.0f);
    EXPECT_FLOAT_EQ(p.pdf, pdfPosition(kTriangle));
    EXPECT_NEAR(dot(p.normal, n), 1.0, 1e-6);
  }
}

TEST(TriangleSampling, SamplesAreSound) {
  for (const Triangle<float>& t : {kTriangle, kSliver, Triangle<float>{kTriangle.a, kTriangle.c, kTriangle.b}}) {
    const Vec3f n = normalAt(t, {});
    const bool thin = area(t) < 0.01f;
    for (const float side : {1.0f, -1.0f}) {
      for (const float height : {20000.0f, 100.0f, 3.0f, 1.0f, 0.1f, 0.01f, 0.001f}) {
        // At 1e4 times its width, the sliver's is that of the rounding of a direction.
        const double edges = height > 10.0f ? (thin ? 1.0 : 0.01) : (thin ? 0.01 : 0.002);
        expectSoundTarget(t, middleOf(t) + n * (side * height), {.pdfTolerance = 2e-3, .edgeShare = edges});
      }
    }
    expectSoundTarget(t, t.a + (t.a - t.b) * 0.3f + n * 0.05f, {.pdfTolerance = 0.01, .edgeShare = 0.01});
  }
}

TEST(TriangleSampling, NothingIsSeenFromItsPlane) {
  const Triangle<float> t{{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}};
  for (const Vec3f from : {Vec3f{2.0f, 0.0f, 0.0f}, Vec3f{0.2f, 0.3f, 0.0f}, t.a, t.c}) {
    expectSoundTarget(t, from, {.noSample = -1.0});
    EXPECT_EQ(sampleDirection(t, from, {0.3f, 0.6f}).pdf, 0.0f);
    EXPECT_EQ(pdfDirection(t, from, {-1.0f, 0.0f, 0.0f}), 0.0f);
    EXPECT_EQ(pdfDirection(t, from, {0.0f, 0.0f, 1.0f}), 0.0f);
  }
}

TEST(TriangleSampling, DegenerateTrianglesGiveNoSample) {
  const Vec3f a{0.0f, 0.0f, 1.0f}, b{1.0f, 0.0f, 1.0f}, c{2.0f, 0.0f, 1.0f};
  for (const Triangle<float>& t : {Triangle<float>{a, a, a}, Triangle<float>{a, b, b}, Triangle<float>{a, b, c}}) {
    expectSoundTarget(t, {}, {.noSample = -1.0});
    EXPECT_EQ(sampleDirection(t, {}, {0.5f, 0.5f}).pdf, 0.0f);
    EXPECT_EQ(samplePosition(t, {0.5f, 0.5f}).pdf, 0.0f);
    EXPECT_EQ(pdfPosition(t), 0.0f);
  }
}

TEST(TriangleSampling, LargeTrianglesAreUniformInSolidAngle) {
  const Vec3f n = normalAt(kTriangle, {});
  for (const Vec3f from : {Vec3f{}, Vec3f{0.5f, 3.0f, 0.2f}, middleOf(kTriangle) - n * 0.01f, kTriangle.b + n * 0.1f}) {
    const double expected = solidAngleOfTriangle(kTriangle, from);
    EXPECT_GT(expected, 0.1);
    for (const Vec2f u : unitPoints(10)) {
      EXPECT_NEAR(sampleDirection(kTriangle, from, u).pdf * expected, 1.0, 2e-5);
    }
  }
}

// The part of the triangle before the line from b through the sampled point has the share u.x of the solid angle.
TEST(TriangleSampling, TheFirstNumberIsTheShareOfAPart) {
  const Vec3f n = normalAt(kTriangle, {});
  for (const Vec3f from : {Vec3f{}, Vec3f{0.5f, 3.0f, 0.2f}, middleOf(kTriangle) - n * 0.01f}) {
    const double whole = solidAngleOfTriangle(kTriangle, from);
    for (std::uint32_t i = 0; i < 50; ++i) {
      const Vec2f u{randomFloat(i, 1), 0.1f + 0.9f * randomFloat(i, 2)};
      const DirectionSample<float> s = sampleDirection(kTriangle, from, u);
      const ShapeHit<float> hit = intersect(kTriangle, Ray<float>{from, s.wi});
      // The end of that line on the edge from a to c: the weight of b is dropped.
      const Vec3f c = kTriangle.a + (kTriangle.c - kTriangle.a) * (hit.v / (1.0f - hit.u));
      EXPECT_NEAR(solidAngleOfTriangle({kTriangle.a, kTriangle.b, c}, from) / whole, u.x, 5e-4);
    }
  }
}

TEST(TriangleSampling, TheThreeVerticesAreReached) {
  const auto near = [](Vec3f wi, Vec3f vertex) { return length(wi - normalize(vertex)) < 2e-3f; };
  EXPECT_TRUE(near(sampleDirection(kTriangle, {}, {0.3f, 0.0f}).wi, kTriangle.b));
  EXPECT_TRUE(near(sampleDirection(kTriangle, {}, {0.0f, kOneMinusEpsilon}).wi, kTriangle.a));
  EXPECT_TRUE(near(sampleDirection(kTriangle, {}, {kOneMinusEpsilon, kOneMinusEpsilon}).wi, kTriangle.c));
}

TEST(TriangleSampling, SmallTrianglesAreUniformByArea) {
  const Triangle<float> t{{-0.1f, -0.1f, 2.0f}, {0.2f, 0.0f, 2.0f}, {0.0f, 0.2f, 2.0f}};
  EXPECT_FLOAT_EQ(pdfDirection(t, {}, {0.0f, 0.0f, 1.0f}), 4.0f / area(t));
}

TEST(TriangleSampling, IntegratesAsItsSolidAngle) {
  // By solid angle, by area, and a sliver whose ends are seen in opposite directions.
  EXPECT_NEAR(integrateTarget(kTriangle, {}, [](Vec3f) { return 1.0f; }), solidAngleOfTriangle(kTriangle, {}), 1e-4);
  const Vec3f far{0.0f, 0.0f, -8.0f};
  EXPECT_NEAR(integrateTarget(kTriangle, far, [](Vec3f) { return 1.0f; }), solidAngleOfTriangle(kTriangle, far), 1e-5);
  const Vec3f close{0.0f, 0.0005f, 0.999f};
  const double omega = solidAngleOfTriangle(kSliver, close);
  EXPECT_GT(omega, 0.5);
  EXPECT_NEAR(integrateTarget(kSliver, close, [](Vec3f) { return 1.0f; }), omega, 1e-3 * omega);
}

TEST(TriangleSampling, IrradianceOfAUnitSquare) {
  const Vec3f a{-0.5f, 1.0f, -0.5f}, b{0.5f, 1.0f, -0.5f}, c{0.5f, 1.0f, 0.5f}, d{-0.5f, 1.0f, 0.5f};
  const Vec3f up{0.0f, 1.0f, 0.0f};
  EXPECT_NEAR(irradiance(Triangle<float>{a, b, c}, {}, up) + irradiance(Triangle<float>{a, c, d}, {}, up), 0.752275,
              1e-5);
}

TEST(TriangleSampling, SameAtAllWidths) {
  expectSameAtAllWidths<Triangle>([](std::uint32_t i) {
    const Vec3f a = randomVector(i, 1) * 10.0f;
    const float size = 5.0f * randomFloat(i, 20);
    return Triangle<float>{a, a + randomVector(i, 2) * size, a + randomVector(i, 3) * size};
  });
}

}  // namespace
}  // namespace steradian::test
