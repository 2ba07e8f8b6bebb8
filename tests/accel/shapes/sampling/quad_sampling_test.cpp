#include "steradian/accel/shapes/sampling/quad_sampling.h"

#include <cmath>

#include "steradian/tests/accel/shapes/target_check.h"

namespace steradian::test {
namespace {

const Quad<float> kRectangle{{-1.0f, -1.0f, 1.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 3.0f, 0.0f}};
const Quad<float> kSkew{{-1.0f, -1.0f, 1.0f}, {2.0f, 0.5f, 0.0f}, {0.3f, 3.0f, 0.2f}};
const Quad<float> kSliver{{-1.0f, -1.0f, 1.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 0.002f, 0.0f}};

TEST(QuadSampling, PositionsLieOnTheQuad) {
  EXPECT_FLOAT_EQ(area(kRectangle), 6.0f);
  for (const Vec2f u : unitPoints(100)) {
    const PositionSample<float> p = samplePosition(kSkew, u);
    const Vec3f expected = kSkew.corner + kSkew.u * u.x + kSkew.v * u.y;
    EXPECT_NEAR(length(p.position - expected), 0.0, 1e-6);
    EXPECT_FLOAT_EQ(p.pdf * area(kSkew), 1.0f);
    EXPECT_EQ(p.pdf, pdfPosition(kSkew));
    EXPECT_NEAR(dot(p.normal, normalize(cross(kSkew.u, kSkew.v))), 1.0, 1e-6);
    EXPECT_NEAR(dot(p.normal, normalAt(kSkew, p.position)), 1.0, 1e-6);
  }
}

TEST(QuadSampling, SamplesAreSound) {
  for (const Quad<float>& quad : {kRectangle, kSkew, kSliver}) {
    const Vec3f n = normalAt(quad, {}), middle = quad.corner + quad.u * 0.5f + quad.v * 0.5f;
    for (const float side : {1.0f, -1.0f}) {
      for (const float height : {20000.0f, 100.0f, 3.0f, 1.0f, 0.1f, 0.01f}) {
        // At 1e4 times its width, the sliver's is that of the rounding of a direction.
        const bool tooThin = height > 50.0f && length(quad.v) < 0.1f;
        expectSoundTarget(quad, middle + n * (side * height),
                          {.pdfTolerance = 1e-3, .edgeShare = tooThin ? 1.0 : 0.002});
      }
    }
    const Vec3f beside = quad.corner - quad.u * 0.3f + quad.v * 0.5f;
    expectSoundTarget(quad, beside + n * 0.05f, {.pdfTolerance = 0.01});
  }
}

TEST(QuadSampling, TouchingRectangleFillsTheHemisphere) {
  for (const float height : {1e-3f, 1e-5f}) {
    const Vec3f from{0.3f, 0.5f, 1.0f - height};
    expectSoundTarget(kRectangle, from);
    EXPECT_NEAR(sampleDirection(kRectangle, from, {0.4f, 0.6f}).pdf, kInvTwoPi, 1e-3 * kInvTwoPi);
  }
}

TEST(QuadSampling, NothingIsSeenFromItsPlane) {
  for (const Vec3f from : {Vec3f{5.0f, 0.0f, 1.0f}, Vec3f{0.0f, 0.0f, 1.0f}, kRectangle.corner}) {
    EXPECT_EQ(sampleDirection(kRectangle, from, {0.3f, 0.6f}).pdf, 0.0f);
    EXPECT_EQ(pdfDirection(kRectangle, from, {-1.0f, 0.0f, 0.0f}), 0.0f);
    EXPECT_EQ(pdfDirection(kRectangle, from, {0.0f, 0.0f, 1.0f}), 0.0f);
    expectSoundTarget(kRectangle, from, {.noSample = -1.0});
  }
}

TEST(QuadSampling, DegenerateQuadsGiveNoSample) {
  const Vec3f zero{};
  const Vec3f edge{1.0f, 0.0f, 0.0f};
  for (const Quad<float>& quad :
       {Quad<float>{{0.0f, 0.0f, 1.0f}, zero, edge}, Quad<float>{{0.0f, 0.0f, 1.0f}, edge, zero},
        Quad<float>{{0.0f, 0.0f, 1.0f}, edge, edge}, Quad<float>{{0.0f, 0.0f, 1.0f}, zero, zero}}) {
    expectSoundTarget(quad, {}, {.noSample = -1.0});
    EXPECT_EQ(sampleDirection(quad, {}, {0.5f, 0.5f}).pdf, 0.0f);
    EXPECT_EQ(samplePosition(quad, {0.5f, 0.5f}).pdf, 0.0f);
    EXPECT_EQ(pdfPosition(quad), 0.0f);
  }
}

TEST(QuadSampling, LargeRectanglesAreUniformInSolidAngle) {
  for (const Vec3f from : {Vec3f{0.0f, 0.0f, 0.0f}, Vec3f{3.0f, 0.5f, 0.3f}, Vec3f{0.3f, 0.5f, 1.3f},
                           Vec3f{-1.5f, 0.5f, 1.05f}, Vec3f{0.0f, 0.0f, -5.0f}}) {
    const double expected = solidAngleOfQuad(kRectangle, from);
    EXPECT_GT(expected, 0.1);
    for (const Vec2f u : unitPoints(10)) {
      EXPECT_NEAR(sampleDirection(kRectangle, from, u).pdf * expected, 1.0, 2e-5);
    }
  }
}

// The strip of the rectangle left of the sampled point has the share u.x of the solid angle.
TEST(QuadSampling, TheFirstNumberIsTheShareOfAStrip) {
  for (const Vec3f from : {Vec3f{0.0f, 0.0f, 0.0f}, Vec3f{3.0f, 0.5f, 0.3f}, Vec3f{0.3f, 0.5f, 1.001f},
                           Vec3f{-0.9f, 1.9f, 1.01f}, Vec3f{-1.5f, 0.5f, 1.05f}}) {
    const double whole = solidAngleOfQuad(kRectangle, from);
    for (const Vec2f u : unitPoints(50)) {
      const DirectionSample<float> s = sampleDirection(kRectangle, from, u);
      const float x = (from + s.wi * s.distance).x;
      const Quad<float> strip{kRectangle.corner, {x - kRectangle.corner.x, 0.0f, 0.0f}, kRectangle.v};
      EXPECT_NEAR(solidAngleOfQuad(strip, from) / whole, u.x, 1e-4) << u.x << " of " << whole;
    }
  }
}

TEST(QuadSampling, SliversKeepTheirDigits) {
  for (const float offset : {0.0f, 0.5f, -0.8f}) {
    const Vec3f from{offset, -0.999f, 0.999f};
    EXPECT_NEAR(sampleDirection(kSliver, from, {0.5f, 0.5f}).pdf * solidAngleOfQuad(kSliver, from), 1.0, 1e-5);
    // Seen from a distance as small as its width, it fills a wedge of 90 degrees.
    const double z = integrateTarget(kSliver, from, [](Vec3f wi) { return wi.z; });
    EXPECT_NEAR(z, 2.0 * std::sqrt(0.5) * 3.14159265 / 2.0, 0.01);
  }
}

TEST(QuadSampling, SmallAndSkewQuadsAreUniformByArea) {
  const Vec3f wi{0.0f, 0.0f, 1.0f};
  EXPECT_FLOAT_EQ(pdfDirection(kRectangle, {0.0f, 0.0f, -19.0f}, wi), 400.0f / 6.0f);
  const Vec3f n = normalAt(kSkew, {});
  const float t = dot(kSkew.corner, n) / n.z;
  EXPECT_FLOAT_EQ(pdfDirection(kSkew, {}, wi), t * t / (area(kSkew) * n.z));
}

TEST(QuadSampling, TurnedRectanglesAreRectangles) {
  // Corners as a transform leaves them, with their rounding.
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Frame<float> axes = Frame<float>::fromZ(normalize(randomVector(i, 1)));
    const Quad<float> quad{axes.z * 2.0f + axes.x * -1.0f + axes.y * -0.5f, axes.x * 2.0f, axes.y * 1.5f};
    EXPECT_NEAR(sampleDirection(quad, {}, {0.2f, 0.8f}).pdf * solidAngleOfQuad(quad, {}), 1.0, 2e-5);
  }
}

TEST(QuadSampling, IrradianceOfAUnitSquare) {
  for (const float width : {1.0f, -1.0f}) {
    const Quad<float> quad{{-0.5f * width, 1.0f, -0.5f}, {width, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    EXPECT_NEAR(irradiance(quad, {}, {0.0f, 1.0f, 0.0f}), 0.752275, 5e-6);
  }
}

TEST(QuadSampling, SolidAngleOfASkewQuad) {
  const double omega = integrateTarget(kSkew, {}, [](Vec3f) { return 1.0f; });
  EXPECT_NEAR(omega, solidAngleOfQuad(kSkew, {}), 1e-4);
}

TEST(QuadSampling, SameAtAllWidths) {
  expectSameAtAllWidths<Quad>([](std::uint32_t i) {
    const Vec3f u = randomVector(i, 2) * 5.0f;
    const Vec3f skew = randomVector(i, 3) * 5.0f;
    const Vec3f across = normalize(cross(u, skew)) * (10.0f * randomFloat(i, 20));
    return Quad<float>{randomVector(i, 1) * 10.0f, u, i % 3 == 0 ? skew : across};
  });
}

}  // namespace
}  // namespace steradian::test
