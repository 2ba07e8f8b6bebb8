#include "steradian/integrators/path/mis_weights.h"

#include <gtest/gtest.h>

#include "steradian/core/math/lanes.h"

namespace steradian {
namespace {

TEST(MisWeights, OfBothWaysToFindALightAddUpToOne) {
  for (const float lightSamples : {1.0f, 3.0f}) {
    for (const float lightPdf : {1e-3f, 0.3f, 40.0f}) {
      for (const float scatterPdf : {1e-3f, 0.2f, 70.0f}) {
        const float sum =
            lightSampleWeight(lightSamples, lightPdf, scatterPdf) + emissionWeight(scatterPdf, lightSamples, lightPdf);
        EXPECT_NEAR(sum, 1.0f, 1e-6f) << lightSamples << " " << lightPdf << " " << scatterPdf;
      }
    }
  }
  EXPECT_FLOAT_EQ(lightSampleWeight(2.0f, 0.5f, 0.5f), 0.8f);  // 1 / (1 + (1/2)^2)
  EXPECT_FLOAT_EQ(emissionWeight(0.5f, 2.0f, 0.5f), 0.2f);
}

TEST(MisWeights, OfDiracDistributionsAreZeroAndOne) {
  EXPECT_EQ(lightSampleWeight(1.0f, kDirac, 0.3f), 1.0f);
  EXPECT_EQ(lightSampleWeight(4.0f, 0.3f, kDirac), 0.0f);
  EXPECT_EQ(emissionWeight(kDirac, 4.0f, 0.3f), 1.0f);
}

TEST(MisWeights, WhatLightSamplingCannotFindBelongsToScattering) {
  for (const float scatterPdf : {0.0f, 0.3f, kDirac}) EXPECT_EQ(emissionWeight(scatterPdf, 1.0f, 0.0f), 1.0f);
  EXPECT_EQ(lightSampleWeight(1.0f, 0.3f, 0.0f), 1.0f);
}

TEST(MisWeights, AreTheSameInLanes) {
  using F = Lanes<4>;
  const float scatter[]{0.0f, 0.3f, 2.0f, kDirac}, light[]{0.2f, 0.0f, 0.7f, 0.4f};
  const F scatterPdf = load<F>(scatter), lightPdf = load<F>(light);
  const F emission = emissionWeight(scatterPdf, F(3.0f), lightPdf);
  const F sample = lightSampleWeight(F(3.0f), lightPdf, scatterPdf);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(lane(emission, i), emissionWeight(scatter[i], 3.0f, light[i])) << i;
    if (!(light[i] > 0.0f)) continue;
    EXPECT_EQ(lane(sample, i), lightSampleWeight(3.0f, light[i], scatter[i])) << i;
  }
}

TEST(MisWeights, StrategiesDifferByTheCompetingDensity) {
  EXPECT_EQ(competingDensity(Strategy::Mis, true, 0.3f), 0.3f);
  EXPECT_EQ(competingDensity(Strategy::Mis, true, kDirac), kDirac);
  EXPECT_EQ(competingDensity(Strategy::Light, true, 0.3f), 0.0f);
  EXPECT_EQ(competingDensity(Strategy::Light, true, kDirac), kDirac);
  EXPECT_EQ(competingDensity(Strategy::Light, false, 0.3f), kDirac);
}

}  // namespace
}  // namespace steradian
