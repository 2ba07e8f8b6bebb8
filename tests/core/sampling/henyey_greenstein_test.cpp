#include "steradian/core/sampling/henyey_greenstein.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

constexpr double kPiDouble = 3.14159265358979324;

/// In double, with h = 1 - cos about the axis.
double exactPdf(double g, double h) {
  return (1.0 - g * g) / (4.0 * kPiDouble * std::pow(sqr(1.0 - g) + 2.0 * g * h, 1.5));
}

TEST(HenyeyGreenstein, ValuesAreTheFormula) {
  for (const float g : {-0.999f, -0.5f, -1e-7f, 0.0f, 1e-4f, 0.3f, 0.99f}) {
    for (const Vec3f w : {Vec3f{0.0f, 0.0f, 1.0f}, Vec3f{0.6f, 0.0f, 0.8f}, Vec3f{1.0f, 0.0f, 0.0f},
                          Vec3f{0.6f, 0.0f, -0.8f}, Vec3f{0.0f, 0.0f, -1.0f}}) {
      const double expected = exactPdf(static_cast<double>(g), 1.0 - static_cast<double>(w.z));
      EXPECT_NEAR(HenyeyGreenstein<float>{g}.pdf(w) / expected, 1.0, 3e-6) << g << ' ' << w.z;
    }
  }
}

TEST(HenyeyGreenstein, NoAsymmetryIsTheUniformSphere) {
  for (const float u : test::unitNumbers(100)) {
    const Vec3f w = HenyeyGreenstein<float>{0.0f}.sample({u, 0.3f}), uniform = UniformSphere<float>::sample({u, 0.3f});
    EXPECT_LT(length(w - uniform), 3e-7f);
  }
  // Next to 0 the textbook's quotient is noise.
  for (const float g : {1e-7f, -1e-7f, 1e-20f, -1e-38f}) {
    const Vec3f w = HenyeyGreenstein<float>{g}.sample({0.25f, 0.3f});
    EXPECT_NEAR(w.z, g < 0.0f ? -0.5f : 0.5f, 1e-6f) << g;
  }
}

TEST(HenyeyGreenstein, NarrowLobesKeepTheirShape) {
  // Against the textbook's inverse in double; forwards and backwards.
  for (const double beyond : {1e-3, 1e-5, 0x1p-20}) {
    for (const float side : {1.0f, -1.0f}) {
      const HenyeyGreenstein<float> phase{side * static_cast<float>(1.0 - beyond)};
      const double exact = 1.0 - std::abs(static_cast<double>(phase.g));
      const Vec3f w = phase.sample({0.5f, 0.0f});
      const auto angle = [&](double u) {
        const double g = 1.0 - exact, s = (1.0 - g * g) / (1.0 + g - 2.0 * g * u);
        return (s * s - exact * exact) / (2.0 * g);
      };
      const double h = angle(0.5);
      EXPECT_NEAR(w.x / std::sqrt(h * (2.0 - h)), 1.0, 2e-6);
      EXPECT_EQ(w.z < 0.0f, side < 0.0f);
      EXPECT_NEAR(phase.pdf(w) / exactPdf(1.0 - exact, h), 1.0, 1e-5);
      EXPECT_TRUE(isFinite(phase.pdf({0.0f, 0.0f, side})));
      EXPECT_NEAR(side * phase.sample({kOneMinusEpsilon, 0.2f}).z, 1.0 - angle(kOneMinusEpsilon), 1e-6);
    }
  }
}

}  // namespace
}  // namespace steradian
