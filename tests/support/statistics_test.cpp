#include "steradian/tests/support/statistics.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace steradian::test {
namespace {

constexpr double kPiDouble = 3.14159265358979324;

TEST(Statistics, IncompleteGammaAgreesWithClosedForms) {
  for (const double x : {0.01, 0.5, 1.0, 3.0, 10.0, 40.0}) {
    EXPECT_NEAR(upperIncompleteGamma(1.0, x), std::exp(-x), 1e-14) << x;
    EXPECT_NEAR(upperIncompleteGamma(0.5, x), std::erfc(std::sqrt(x)), 1e-13) << x;
    EXPECT_NEAR(upperIncompleteGamma(3.0, x), std::exp(-x) * (1.0 + x + 0.5 * x * x), 1e-13) << x;
  }
  EXPECT_EQ(upperIncompleteGamma(2.0, 0.0), 1.0);
  EXPECT_EQ(upperIncompleteGamma(2.0, std::numeric_limits<double>::infinity()), 0.0);
}

TEST(Statistics, PValuesAgreeWithTables) {
  EXPECT_NEAR(normalPValue(1.959963985), 0.05, 1e-9);
  EXPECT_NEAR(normalPValue(-3.290526731), 0.001, 1e-11);
  EXPECT_NEAR(studentPValue(12.706204736, 1), 0.05, 1e-9);
  EXPECT_NEAR(studentPValue(4.302652730, 2), 0.05, 1e-9);
  EXPECT_NEAR(studentPValue(3.182446305, 3), 0.05, 1e-9);
  EXPECT_NEAR(studentPValue(-2.364624252, 7), 0.05, 1e-9);
  EXPECT_NEAR(studentPValue(2.306004135, 8), 0.05, 1e-9);
  EXPECT_NEAR(sidakLevel(0.01, 1), 0.01, 1e-15);
  EXPECT_NEAR(1.0 - std::pow(1.0 - sidakLevel(0.01, 100), 100), 0.01, 1e-12);
}

TEST(Statistics, ChiSquareIsPearsons) {
  // The critical value of 3 degrees of freedom at 5 % is 7.8147.
  const std::array<double, 4> expected{100.0, 100.0, 100.0, 100.0};
  const double d = std::sqrt(7.814727903 * 100.0 / 4.0);
  const ChiSquare result = chiSquareTest(std::array{100.0 + d, 100.0 - d, 100.0 + d, 100.0 - d}, expected);
  EXPECT_EQ(result.degreesOfFreedom, 3);
  EXPECT_NEAR(result.pValue, 0.05, 1e-8);
  EXPECT_EQ(chiSquareUniform(std::array{7.0, 7.0, 7.0}).pValue, 1.0);
}

TEST(Statistics, ChiSquarePoolsSmallCellsButNotImpossibleOnes) {
  const std::array<double, 5> expected{2.0, 2.0, 2.0, 100.0, 0.0};
  const ChiSquare pooled = chiSquareTest(std::array{6.0, 0.0, 0.0, 100.0, 0.0}, expected);
  EXPECT_EQ(pooled.degreesOfFreedom, 1);
  EXPECT_EQ(pooled.pValue, 1.0);
  EXPECT_EQ(chiSquareTest(std::array{2.0, 2.0, 2.0, 99.0, 1.0}, expected).pValue, 0.0);
  // A pool of 1: P(X >= 3) = 1 - 5/(2e), twice.
  const std::array<double, 4> sparse{0.5, 0.5, 100.0, 100.0};
  EXPECT_NEAR(chiSquareTest(std::array{2.0, 1.0, 99.0, 99.0}, sparse).pValue, 2.0 * (1.0 - 2.5 * std::exp(-1.0)), 1e-9);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(chiSquareTest(std::array{1.0, 1.0}, std::array{nan, 1.0}).pValue, 0.0);
}

TEST(Statistics, ZTestHasARoundoffFloor) {
  EXPECT_EQ(zTestPValue(1.001, 0.0, 1.0, 0.002), 1.0);
  EXPECT_EQ(zTestPValue(1.003, 0.0, 1.0, 0.002), 0.0);
  EXPECT_NEAR(zTestPValue(1.202, 0.1, 1.0, 0.002), normalPValue(2.0), 1e-9);
  EXPECT_EQ(zTestPValue(std::numeric_limits<double>::quiet_NaN(), 0.1, 1.0, 0.002), 0.0);
}

TEST(Statistics, UniformityAcceptsAnEvenGridAndRejectsASquare) {
  std::vector<double> even, square;
  for (int i = 0; i < 1000; ++i) {
    const double x = (i + 0.5) / 1000.0;
    even.push_back(x);
    square.push_back(x * x);
  }
  EXPECT_GT(uniformityPValue(even), 0.99);
  EXPECT_LT(uniformityPValue(square), 1e-6);
}

TEST(Quadrature, IntegratesSmoothAndDiscontinuousFunctions) {
  EXPECT_NEAR(integrate([](double x, double y) { return x * x * y; }, {0.0, 3.0, 1.0, 2.0}), 13.5, 1e-12);
  EXPECT_NEAR(integrate([](double x, double y) { return std::exp(-x * x - y * y); }, {-6.0, 6.0, -6.0, 6.0}), kPiDouble,
              1e-6);
  const auto disk = [](double x, double y) { return x * x + y * y < 1.0 ? 1.0 : 0.0; };
  EXPECT_NEAR(integrate(disk, {-1.0, 1.0, -1.0, 1.0}), kPiDouble, 1e-3);
}

TEST(Quadrature, IntegratesOverDirections) {
  const Vec3f axis = normalize(Vec3f{0.3f, -0.5f, 0.8f});
  SphereGrid grid;
  grid.axis = axis;
  EXPECT_NEAR(integrateSphere([](Vec3f) { return 1.0; }, grid), 4.0 * kPiDouble, 1e-9);
  EXPECT_NEAR(integrateSphere([](Vec3f w) { return static_cast<double>(w.x * w.x); }, grid), 4.0 * kPiDouble / 3.0,
              1e-6);
  EXPECT_NEAR(integrateHemisphere([&](Vec3f w) { return static_cast<double>(dot(w, axis)); }, axis), kPiDouble, 1e-6);
  // The solid angle of a cone of 1 mrad, found by focusing on it.
  grid.focus = 1.5e-3;
  const double cosine = std::cos(1e-3);
  const double solidAngle = 2.0 * kPiDouble * (1.0 - cosine);
  const auto cone = [&](Vec3f w) { return dot(w - axis, w - axis) < 1e-6f ? 1.0 / solidAngle : 0.0; };
  EXPECT_NEAR(integrateSphere(cone, grid), 1.0, 1e-3);
}

TEST(Quadrature, GridCellsHoldWhatTheyIntegrate) {
  // Rings of equal solid angle by default.
  for (const double cell : integrateCells([](Vec3f) { return 1.0; }, {})) {
    EXPECT_NEAR(cell, 4.0 * kPiDouble / (12.0 * 16.0), 1e-9);
  }
}

}  // namespace
}  // namespace steradian::test
