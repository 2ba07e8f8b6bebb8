#include "steradian/accel/shapes/sampling/box_sampling.h"

#include <cmath>

#include "steradian/tests/accel/shapes/target_check.h"

namespace steradian::test {
namespace {

const Frame<float> kAxes = Frame<float>::fromZ({0.6f, 0.0f, 0.8f});
const Box<float> kBox{{1.0f, 2.0f, 3.0f}, {0.5f, 1.0f, 2.0f}, kAxes};

// In units of the half edges, from the centre: 1 is on a face.
Vec3f placeAt(const Box<float>& box, Vec3f units) { return box.center + box.axes.toWorld(units * box.half); }

// The solid angle of the faces that are seen, in double.
double solidAngleOfBox(const Box<float>& box, Vec3f from) {
  const std::array<Vec3f, 3> edges{box.axes.x * (2.0f * box.half.x), box.axes.y * (2.0f * box.half.y),
                                   box.axes.z * (2.0f * box.half.z)};
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3f u = edges[(k + 1) % 3], v = edges[(k + 2) % 3], n = edges[k];
    for (const float side : {-1.0f, 1.0f}) {
      const Vec3f middle = box.center + n * (0.5f * side);
      if (dot(from - middle, n) * side <= 0.0f) continue;
      sum += solidAngleOfQuad(Quad<float>{middle - u * 0.5f - v * 0.5f, u, v}, from);
    }
  }
  return sum;
}

TEST(BoxSampling, PositionsLieOnTheFaces) {
  EXPECT_FLOAT_EQ(area(kBox), 28.0f);
  EXPECT_FLOAT_EQ(pdfPosition(kBox), 1.0f / 28.0f);
  for (const Vec2f u : unitPoints(200)) {
    const PositionSample<float> p = samplePosition(kBox, u);
    const Vec3f local = kBox.axes.toLocal(p.position - kBox.center);
    const Vec3f out = absolute(local) - kBox.half;
    EXPECT_NEAR(maxComponent(out), 0.0, 1e-6);
    EXPECT_NEAR(length(p.normal), 1.0, 1e-6);
    EXPECT_GT(dot(p.normal, p.position - kBox.center), 0.0f);
    EXPECT_EQ(p.pdf, pdfPosition(kBox));
  }
}

TEST(BoxSampling, NormalsOfTheFaces) {
  EXPECT_NEAR(dot(normalAt(kBox, placeAt(kBox, {1.0f, 0.2f, 0.9f})), kAxes.x), 1.0, 1e-6);
  EXPECT_NEAR(dot(normalAt(kBox, placeAt(kBox, {0.1f, -1.0f, 0.9f})), kAxes.y), -1.0, 1e-6);
  EXPECT_NEAR(dot(normalAt(kBox, placeAt(kBox, {0.1f, 0.3f, -1.0f})), kAxes.z), -1.0, 1e-6);
}

TEST(BoxSampling, SamplesAreSound) {
  // One, two and three faces, near and far, beside an edge and a corner, mirrored.
  for (const Vec3f units : {Vec3f{1.02f, 0.2f, -0.3f}, Vec3f{3.0f, 0.2f, 0.1f}, Vec3f{1.02f, 1.01f, 0.3f},
                            Vec3f{1.02f, 1.01f, 1.01f}, Vec3f{2.0f, -3.0f, 1.5f}, Vec3f{-10.0f, 20.0f, -30.0f},
                            Vec3f{0.3f, -1.0001f, 0.2f}, Vec3f{1.0001f, 1.0001f, 1.0001f}}) {
    expectSoundTarget(kBox, placeAt(kBox, units), {.pdfTolerance = 2e-3, .edgeShare = 0.005});
  }
  expectSoundTarget(kBox, placeAt(kBox, {5000.0f, 7000.0f, 3000.0f}), {.pdfTolerance = 2e-3, .edgeShare = 0.02});
}

TEST(BoxSampling, UniformOverTheVisibleFaces) {
  for (const Vec3f units : {Vec3f{1.1f, 0.2f, -0.3f}, Vec3f{2.0f, -3.0f, 0.5f}, Vec3f{-2.0f, 2.0f, 1.5f}}) {
    const Vec3f from = placeAt(kBox, units);
    const double omega = solidAngleOfBox(kBox, from);
    int uniform = 0;
    for (const Vec2f u : unitPoints(100)) {
      uniform += std::abs(sampleDirection(kBox, from, u).pdf * omega - 1.0) < 3e-5 ? 1 : 0;
    }
    EXPECT_GT(uniform, 100);
    EXPECT_NEAR(integrateTarget(kBox, from, [](Vec3f) { return 1.0f; }), omega, 1e-3 * omega);
  }
  const Vec3f far = placeAt(kBox, {20.0f, 30.0f, 25.0f});
  EXPECT_NEAR(integrateTarget(kBox, far, [](Vec3f) { return 1.0f; }) / solidAngleOfBox(kBox, far), 1.0, 1e-3);
}

TEST(BoxSampling, FromInsideUniformOverAllDirections) {
  const Vec3f from = placeAt(kBox, {0.3f, -0.9f, 0.2f});
  expectSoundTarget(kBox, from);
  for (const Vec2f u : unitPoints(100)) {
    const DirectionSample<float> s = sampleDirection(kBox, from, u);
    EXPECT_EQ(s.pdf, kInvFourPi);
    EXPECT_NEAR(maxComponent(absolute(kBox.axes.toLocal(from + s.wi * s.distance - kBox.center)) - kBox.half), 0.0,
                1e-5);
  }
}

TEST(BoxSampling, MissesAreZero) {
  const Vec3f from = placeAt(kBox, {3.0f, 0.0f, 0.0f});
  EXPECT_GT(pdfDirection(kBox, from, -kAxes.x), 0.0f);
  EXPECT_EQ(pdfDirection(kBox, from, kAxes.x), 0.0f);
  EXPECT_EQ(pdfDirection(kBox, from, normalize(-kAxes.x + kAxes.y * 1.1f)), 0.0f);
}

TEST(BoxSampling, SameAtAllWidths) {
  expectSameAtAllWidths<Box>([](std::uint32_t i) {
    const Vec3f half = absolute(randomVector(i, 2)) * 4.0f + Vec3f{0.01f, 0.01f, 0.01f};
    return Box<float>{randomVector(i, 1) * 8.0f, half, Frame<float>::fromZ(normalize(randomVector(i, 3)))};
  });
}

}  // namespace
}  // namespace steradian::test
