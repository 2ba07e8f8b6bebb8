#include "steradian/accel/shapes/sampling/sphere_sampling.h"

#include <cmath>

#include "steradian/tests/accel/shapes/target_check.h"

namespace steradian::test {
namespace {

const Sphere<float> kSphere{{1.0f, 2.0f, 3.0f}, 0.5f};

TEST(SphereSampling, PositionsLieOnTheSphere) {
  EXPECT_FLOAT_EQ(area(kSphere), 3.14159265f);
  EXPECT_FLOAT_EQ(pdfPosition(kSphere), 1.0f / 3.14159265f);
  for (const Vec2f u : unitPoints(100)) {
    const PositionSample<float> p = samplePosition(kSphere, u);
    EXPECT_NEAR(length(p.position - kSphere.center), 0.5, 1e-6);
    EXPECT_NEAR(dot(p.normal, normalAt(kSphere, p.position)), 1.0, 1e-6);
    EXPECT_EQ(p.pdf, pdfPosition(kSphere));
  }
}

TEST(SphereSampling, SamplesAreSound) {
  for (const float distance : {5000.0f, 50.0f, 2.0f, 0.6f, 0.5001f, 0.500001f}) {
    // At 1e4 radii, the rounding of a direction is a thousandth of the cone; near the surface, that of tangents moves
    // hits.
    const bool hard = distance > 1000.0f || distance < 0.505f;
    expectSoundTarget(kSphere, kSphere.center + normalize(Vec3f{0.3f, -0.5f, 0.2f}) * distance,
                      {.edgeShare = hard ? 0.02 : 0.002});
  }
  for (const float distance : {0.0f, 0.1f, 0.4999f}) {
    expectSoundTarget(kSphere, kSphere.center + Vec3f{0.0f, distance, 0.0f});
  }
  // On the surface, the directions that leave the sphere do not hit it.
  expectSoundTarget(kSphere, kSphere.center + Vec3f{0.0f, 0.5f, 0.0f}, {.noSample = 0.5});
}

TEST(SphereSampling, FromOutsideUniformInTheCone) {
  for (const double distance : {0.50001, 0.51, 1.0, 10.0, 1e3, 1e6}) {
    const double sine = 0.5 / distance;
    const double solidAngle = 2.0 * 3.14159265358979 * sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));
    const Sphere<float> sphere{{0.0f, static_cast<float>(distance), 0.0f}, 0.5f};
    const float pdf = sampleDirection(sphere, {0.0f, 0.0f, 0.0f}, {0.3f, 0.7f}).pdf;
    EXPECT_NEAR(pdf * solidAngle, 1.0, distance < 0.505 ? 1e-3 : 1e-6) << distance;
    EXPECT_EQ(pdf, pdfDirection(sphere, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}));
    EXPECT_EQ(pdfDirection(sphere, {0.0f, 0.0f, 0.0f}, {0.0f, -1.0f, 0.0f}), 0.0f);
  }
}

TEST(SphereSampling, TheConeEndsAtTheSilhouette) {
  const Sphere<float> sphere{{0.0f, 0.0f, 2.0f}, 0.5f};
  const float sine = 0.25f;
  for (const float factor : {0.9999f, 1.0001f}) {
    const float s = sine * factor;
    const float pdf = pdfDirection(sphere, {0.0f, 0.0f, 0.0f}, {s, 0.0f, std::sqrt(1.0f - s * s)});
    EXPECT_EQ(pdf > 0.0f, factor < 1.0f);
  }
}

TEST(SphereSampling, FromInsideUniformOverAllDirections) {
  for (const Vec2f u : unitPoints(100)) {
    const DirectionSample<float> s = sampleDirection(kSphere, {1.1f, 2.2f, 3.3f}, u);
    EXPECT_EQ(s.pdf, kInvFourPi);
    EXPECT_NEAR(length(Vec3f{1.1f, 2.2f, 3.3f} + s.wi * s.distance - kSphere.center), 0.5, 1e-6);
  }
}

TEST(SphereSampling, IrradianceOfASphere) {
  const Sphere<float> sphere{{0.0f, 2.0f, 0.0f}, 0.5f};
  EXPECT_NEAR(irradiance(sphere, {0.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}), 0.196350, 2e-6);
  EXPECT_NEAR(irradiance(sphere, {0.0f, 0.0f, 0.0f}, {0.6f, 0.8f, 0.0f}), 0.8 * 0.196350, 2e-6);
  EXPECT_NEAR(irradiance(Sphere<float>{{}, 1.0f}, {0.2f, 0.0f, 0.3f}, {0.0f, 1.0f, 0.0f}), 3.1415927, 1e-3);
}

TEST(SphereSampling, SameAtAllWidths) {
  expectSameAtAllWidths<Sphere>([](std::uint32_t i) {
    return Sphere<float>{randomVector(i, 1) * 10.0f, 0.01f + 10.0f * randomFloat(i, 20) * randomFloat(i, 21)};
  });
}

}  // namespace
}  // namespace steradian::test
