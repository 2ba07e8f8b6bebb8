#include "steradian/core/sampling/warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using test::unitNumbers;

TEST(Warp, PolesAndRims) {
  EXPECT_EQ(UniformSphere<float>::sample({0.0f, 0.3f}).z, 1.0f);
  EXPECT_NEAR(UniformSphere<float>::sample({kOneMinusEpsilon, 0.3f}).z, -1.0f, 2e-7f);
  EXPECT_EQ(UniformHemisphere<float>::sample({0.0f, 0.3f}).z, 1.0f);
  EXPECT_GT(UniformHemisphere<float>::sample({kOneMinusEpsilon, 0.3f}).z, 0.0f);
  EXPECT_EQ(UniformHemisphere<float>::pdf({0.0f, 0.6f, -0.8f}), 0.0f);
  EXPECT_EQ(CosineHemisphere<float>::pdf({0.0f, 0.6f, -0.8f}), 0.0f);
  EXPECT_EQ(CosineHemisphere<float>::sample({0.5f, 0.5f}).z, 1.0f);
  for (const float edge : {0.0f, kOneMinusEpsilon}) {
    const Vec3f w = CosineHemisphere<float>::sample({edge, 0.3f});
    EXPECT_GE(w.z, 3e-4f);
    EXPECT_NEAR(length(w), 1.0f, 2e-7f);
  }
  EXPECT_EQ(UniformDisk<float>::pdf({0.8f, 0.7f}), 0.0f);
  EXPECT_EQ(UniformTriangle<float>::pdf({0.6f, 0.5f}), 0.0f);
  EXPECT_EQ(UniformTriangle<float>::pdf({-0.1f, 0.5f}), 0.0f);
}

TEST(Warp, DiskKeepsTheLengthOfItsPoints) {
  const auto us = unitNumbers(500), vs = unitNumbers(500, 1);
  for (std::size_t i = 0; i < us.size(); ++i) {
    const auto p = UniformDisk<float>::concentric({us[i], vs[i]});
    EXPECT_NEAR(std::hypot(p.point.x, p.point.y), std::abs(p.radius), 2e-7f);
    EXPECT_EQ(std::abs(p.radius), std::max(std::abs(2.0f * us[i] - 1.0f), std::abs(2.0f * vs[i] - 1.0f)));
  }
}

TEST(Warp, ConesAreStableWhenTiny) {
  for (const float angle : {1e-2f, 1e-4f, 1e-6f, 1e-12f}) {
    const double exact = 2.0 * std::pow(std::sin(0.5 * static_cast<double>(angle)), 2);
    const UniformCone<float> cone{static_cast<float>(exact)};
    EXPECT_NEAR(cone.pdfInside() * 2.0 * 3.14159265358979 * exact, 1.0, 1e-6);
    const Vec3f rim = cone.sample({kOneMinusEpsilon, 0.125f});
    EXPECT_NEAR(std::hypot(rim.x, rim.y) / std::sin(static_cast<double>(angle)), 1.0, 1e-6);
    EXPECT_EQ(cone.pdf(normalize(Vec3f{1.01f * angle, 0.0f, 1.0f})), 0.0f);
    EXPECT_GT(cone.pdf(normalize(Vec3f{0.99f * angle, 0.0f, 1.0f})), 0.0f);
    EXPECT_EQ(cone.pdf({0.0f, 0.0f, -1.0f}), 0.0f);
  }
}

TEST(Warp, SamplesOnTheRimOfAConeAreInside) {
  for (const float h : test::numbers(200, 1e-9f, 2.0f)) {
    const UniformCone<float> cone{h};
    for (const float turn : unitNumbers(100)) {
      EXPECT_GT(cone.pdf(cone.sample({kOneMinusEpsilon, turn})), 0.0f) << h << ' ' << turn;
    }
  }
}

TEST(Warp, FlightsAreFinite) {
  for (const float rate : {1e-6f, 1.0f, 3e4f}) {
    const ExponentialFlight<float> flight{rate};
    for (const float u : unitNumbers(500)) {
      const float t = flight.sample(u);
      EXPECT_TRUE(t >= 0.0f && t <= 16.7f / rate) << u;
      EXPECT_NEAR(flight.invert(t), u, 2e-7f);
      EXPECT_NEAR(flight.pdf(t) / rate, 1.0f - u, 2e-7f);
    }
    EXPECT_EQ(flight.sample(0.0f), 0.0f);
    EXPECT_FALSE(std::signbit(flight.sample(0.0f)));
    EXPECT_EQ(flight.pdf(-1.0f), 0.0f);
  }
}

TEST(Warp, DirectionsHaveUnitLength) {
  const auto us = unitNumbers(2000), vs = unitNumbers(2000, 1);
  for (std::size_t i = 0; i < us.size(); ++i) {
    const Vec2f u{us[i], vs[i]};
    EXPECT_NEAR(length(UniformSphere<float>::sample(u)), 1.0f, 2e-7f);
    EXPECT_NEAR(length(UniformHemisphere<float>::sample(u)), 1.0f, 2e-7f);
    EXPECT_NEAR(length(CosineHemisphere<float>::sample(u)), 1.0f, 2e-7f);
    EXPECT_NEAR(length(UniformCone<float>{1e-7f}.sample(u)), 1.0f, 2e-7f);
    EXPECT_NEAR(length(PowerCosineHemisphere<float>{7.0f}.sample(u)), 1.0f, 2e-7f);
  }
}

TEST(Warp, PolarAndConcentricDisksAgreeAboutDensity) {
  EXPECT_EQ(UniformDiskPolar<float>::pdf({0.8f, 0.7f}), 0.0f);
  EXPECT_EQ(UniformDiskPolar<float>::pdf({0.3f, 0.4f}), kInvPi);
  const Vec2f p = UniformDiskPolar<float>::sample({0.25f, 0.25f});
  EXPECT_NEAR(p.x, 0.0f, 1e-7f);
  EXPECT_FLOAT_EQ(p.y, 0.5f);
}

TEST(Warp, ParallelogramsEndAtTheirEdges) {
  const UniformParallelogram<float> p{{2.0f, 0.0f}, {1.0f, 3.0f}};
  EXPECT_FLOAT_EQ(p.pdf({1.5f, 1.5f}), 1.0f / 6.0f);
  EXPECT_FLOAT_EQ(p.sample({0.25f, 0.5f}).x, 1.0f);
  EXPECT_FLOAT_EQ(p.sample({0.25f, 0.5f}).y, 1.5f);
  for (const Vec2f outside : {Vec2f{2.1f, 0.0f}, Vec2f{0.0f, 0.1f}, Vec2f{1.0f, 3.1f}, Vec2f{-0.1f, 0.0f}}) {
    EXPECT_EQ(p.pdf(outside), 0.0f) << outside.x << ' ' << outside.y;
  }
}

TEST(Warp, PowerCosinesAreTheFormula) {
  EXPECT_FLOAT_EQ(PowerCosineHemisphere<float>{0.0f}.pdf({0.6f, 0.0f, 0.8f}), kInvTwoPi);
  EXPECT_NEAR(PowerCosineHemisphere<float>{1.0f}.pdf({0.6f, 0.0f, 0.8f}), 0.8f * kInvPi, 1e-6f);
  EXPECT_NEAR(PowerCosineHemisphere<float>{3.0f}.pdf({0.6f, 0.0f, 0.8f}), 4.0f * kInvTwoPi * 0.512f, 1e-6f);
  EXPECT_EQ(PowerCosineHemisphere<float>{3.0f}.pdf({0.6f, 0.0f, -0.8f}), 0.0f);
  EXPECT_EQ(PowerCosineHemisphere<float>{3.0f}.sample({0.0f, 0.3f}).z, 1.0f);
  EXPECT_GT(PowerCosineHemisphere<float>{1e4f}.sample({kOneMinusEpsilon, 0.3f}).z, 0.0f);
  // Near the axis: cos = (1 - u)^(1/(n+1)), sin^2 = 2 u / (n + 1).
  const Vec3f w = PowerCosineHemisphere<float>{999.0f}.sample({0x1p-24f, 0.0f});
  EXPECT_NEAR(w.x / std::sqrt(2.0 * 0x1p-24 / 1000.0), 1.0, 1e-6);
}

}  // namespace
}  // namespace steradian
