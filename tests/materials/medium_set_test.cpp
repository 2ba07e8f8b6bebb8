#include "steradian/materials/medium_set.h"

#include <gtest/gtest.h>

#include <cmath>

namespace steradian {
namespace {

TEST(MediumSet, IsTheLawOfBeerAndLambert) {
  MediumDescription fog{.name = "fog", .absorption = {0.1f, 0.0f, 0.5f}, .scattering = {0.2f, 0.0f, 1.5f}};
  const MediumSet media({fog});
  const Medium& medium = *media.find(0);
  for (const float length : {0.0f, 0.3f, 2.0f, 20.0f}) {
    EXPECT_NEAR(medium.transmittance(length).r, std::exp(-0.3 * length), 1e-6);
    EXPECT_EQ(medium.transmittance(length).g, 1.0f);
    EXPECT_NEAR(medium.transmittance(length).b, std::exp(-2.0 * length), 1e-6);
  }
  EXPECT_EQ(medium.transmittance(kInfinity).r, 0.0f);
  EXPECT_EQ(medium.transmittance(kInfinity).g, 1.0f);
  EXPECT_EQ(media.find(kNone), nullptr);
  EXPECT_EQ(media.find(1), nullptr);
}

TEST(MediumSet, EmittedRadianceIsTheIntegralOfWhatIsLeft) {
  MediumDescription fire{.name = "fire", .absorption = {0.5f, 1e-6f, 0.0f}, .emission = {2.0f, 3.0f, 4.0f}};
  const MediumSet media({fire});
  const Medium& medium = *media.find(0);
  for (const float length : {0.0f, 0.3f, 2.0f}) {
    EXPECT_NEAR(medium.emitted(length).r, 2.0 * (1.0 - std::exp(-0.5 * length)) / 0.5, 1e-5);
    EXPECT_NEAR(medium.emitted(length).g, 3.0 * length, 1e-5);
    EXPECT_NEAR(medium.emitted(length).b, 4.0 * length, 1e-5);
  }
  EXPECT_FLOAT_EQ(medium.emitted(kInfinity).r, 4.0f);
}

}  // namespace
}  // namespace steradian
