#include "steradian/materials/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace steradian {
namespace {

float cosine(double degrees) { return static_cast<float>(std::cos(degrees * M_PI / 180.0)); }

TEST(Fresnel, KnownAngles) {
  EXPECT_NEAR(fresnelDielectric(1.0f, 1.5f), 0.04f, 1e-7f);
  EXPECT_NEAR(fresnelDielectric(1.0f, 1.0f / 1.5f), 0.04f, 1e-7f);
  EXPECT_NEAR(fresnelDielectric(1.0f, 1.333f), 0.0203724f, 1e-6f);
  // Crown glass at 60 degrees: rs = -0.420404, rp = 0.042446 (Hecht, "Optics", 4.6).
  EXPECT_NEAR(fresnelDielectric(0.5f, 1.5f), 0.0892f, 5e-5f);
  EXPECT_NEAR(fresnelDielectric(0.0f, 1.5f), 1.0f, 1e-7f);
  EXPECT_NEAR(fresnelDielectric(0.3f, 1.0f), 0.0f, 1e-12f);
}

// At Brewster's angle, tan = eta, the parallel part vanishes and the other is ((1 - eta^2) / (1 + eta^2))^2.
TEST(Fresnel, BrewstersAngle) {
  for (const double eta : {1.33, 1.5, 2.4}) {
    const auto c = static_cast<float>(std::cos(std::atan(eta)));
    const double perpendicular = (1.0 - eta * eta) / (1.0 + eta * eta);
    EXPECT_NEAR(fresnelDielectric(c, static_cast<float>(eta)), 0.5 * perpendicular * perpendicular, 1e-6);
  }
}

TEST(Fresnel, TotalReflectionBeyondTheCriticalAngle) {
  const float inside = 1.0f / 1.5f;
  EXPECT_LT(fresnelDielectric(cosine(41.7), inside), 0.9f);
  EXPECT_EQ(fresnelDielectric(cosine(41.82), inside), 1.0f);
  EXPECT_EQ(fresnelSchlick(cosine(41.82), inside), 1.0f);
  EXPECT_LT(fresnelSchlick(cosine(41.7), inside), 0.1f);
}

TEST(Fresnel, SchlickByHand) {
  EXPECT_NEAR(fresnelSchlick(1.0f, 1.5f), 0.04f, 1e-7f);
  EXPECT_NEAR(fresnelSchlick(0.5f, 1.5f), 0.04f + 0.96f / 32.0f, 1e-7f);
  EXPECT_NEAR(fresnelSchlick(0.0f, 1.5f), 1.0f, 1e-7f);
  EXPECT_NEAR(fresnelSchlick(0.8f, 1.0f / 1.5f), 0.04f + 0.96f * 0.00032f, 1e-7f);
}

// The closed form of 1 - diffuseTransmittance for eta > 1 (Walsh 1926).
double walsh(double n) {
  const double n2 = n * n, n4 = n2 * n2;
  return 0.5 + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0) * (n + 1.0)) +
         n2 * (n2 - 1.0) * (n2 - 1.0) / std::pow(n2 + 1.0, 3) * std::log((n - 1.0) / (n + 1.0)) -
         2.0 * n2 * n * (n2 + 2.0 * n - 1.0) / ((n2 + 1.0) * (n4 - 1.0)) +
         8.0 * n4 * (n4 + 1.0) / ((n2 + 1.0) * (n4 - 1.0) * (n4 - 1.0)) * std::log(n);
}

TEST(Fresnel, DiffuseTransmittanceIsWalshs) {
  for (const double eta : {1.2, 1.33, 1.5, 2.0, 2.4}) {
    EXPECT_NEAR(1.0 - diffuseTransmittance(eta), walsh(eta), 1e-6) << eta;
    EXPECT_NEAR(diffuseTransmittance(1.0 / eta) * eta * eta, diffuseTransmittance(eta), 1e-12) << eta;
  }
  EXPECT_NEAR(1.0 - diffuseTransmittance(1.5), 0.0918, 5e-5);  // textbook values for glass
  EXPECT_NEAR(1.0 - diffuseTransmittance(1.0 / 1.5), 0.5963, 1e-4);
  EXPECT_DOUBLE_EQ(diffuseTransmittance(1.0), 1.0);
}

// The internal value follows from reciprocity above; here it is integrated directly.
TEST(Fresnel, InternalReflectanceByQuadrature) {
  double sum = 0.0;
  constexpr int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    const double c = (i + 0.5) / steps;
    sum += (1.0 - static_cast<double>(fresnelDielectric(static_cast<float>(c), 1.0f / 1.5f))) * 2.0 * c / steps;
  }
  EXPECT_NEAR(sum, diffuseTransmittance(1.0 / 1.5), 1e-5);
}

}  // namespace
}  // namespace steradian
