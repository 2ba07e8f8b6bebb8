#include "steradian/materials/medium_set.h"

#include <gtest/gtest.h>

#include <cmath>

namespace steradian {
namespace {

TEST(MediumSet, IsTheLawOfBeerAndLambert) {
  MediumDescription fog{.name = "fog", .absorption = {0.1f, 0.0f, 0.5f}, .scattering = {0.2f, 0.0f, 1.5f}};
  const MediumSet media({fog});
  const Medium<float> medium = media.at<float>(0);
  for (const float length : {0.0f, 0.3f, 2.0f, 20.0f}) {
    EXPECT_NEAR(medium.transmittance(length).r, std::exp(-0.3 * length), 1e-6);
    EXPECT_EQ(medium.transmittance(length).g, 1.0f);
    EXPECT_NEAR(medium.transmittance(length).b, std::exp(-2.0 * length), 1e-6);
  }
  EXPECT_EQ(medium.transmittance(kInfinity).r, 0.0f);
  EXPECT_EQ(medium.transmittance(kInfinity).g, 1.0f);
  EXPECT_TRUE(medium.scatters());
  EXPECT_FALSE(medium.emits());
}

TEST(MediumSet, VacuumLetsEverythingThrough) {
  const MediumSet media({{.name = "fog", .scattering = grey(1.0f)}});
  EXPECT_EQ(media.none(), 1u);
  const Medium<float> vacuum = media.at<float>(media.none());
  EXPECT_FALSE(vacuum.scatters());
  EXPECT_FALSE(vacuum.emits());
  for (const float length : {0.0f, 1.0f, kInfinity}) {
    EXPECT_EQ(vacuum.transmittance(length).g, 1.0f);
    EXPECT_EQ(vacuum.emitted(length).g, 0.0f);
  }
}

TEST(MediumSet, EveryLaneHasItsOwn) {
  using F = Lanes<4>;
  const MediumSet media({{.name = "fog", .absorption = {0.1f, 0.0f, 0.5f}, .scattering = {0.2f, 0.0f, 1.5f}},
                         {.name = "fire", .absorption = {0.5f, 1e-6f, 0.0f}, .emission = {2.0f, 3.0f, 4.0f}}});
  UintOf<F> which(0u);
  for (const std::uint32_t i : {1u, 2u}) setLane(which, static_cast<int>(i), i);
  const Medium<F> mixed = media.at<F>(which);
  for (const float way : {0.0f, 0.3f, 2.0f, kInfinity}) {
    for (int i = 0; i < 4; ++i) {
      const Medium<float> one = media.at<float>(lane(which, i));
      const Rgb share = lane(mixed.transmittance(F(way)), i), seen = lane(mixed.emitted(F(way)), i);
      EXPECT_EQ(share.r, one.transmittance(way).r);
      EXPECT_EQ(share.b, one.transmittance(way).b);
      EXPECT_EQ(seen.r, one.emitted(way).r);
      EXPECT_EQ(seen.b, one.emitted(way).b);
    }
  }
}

TEST(MediumSet, EmittedRadianceIsTheIntegralOfWhatIsLeft) {
  MediumDescription fire{.name = "fire", .absorption = {0.5f, 1e-6f, 0.0f}, .emission = {2.0f, 3.0f, 4.0f}};
  const MediumSet media({fire});
  const Medium<float> medium = media.at<float>(0);
  for (const float length : {0.0f, 0.3f, 2.0f}) {
    EXPECT_NEAR(medium.emitted(length).r, 2.0 * (1.0 - std::exp(-0.5 * length)) / 0.5, 1e-5);
    EXPECT_NEAR(medium.emitted(length).g, 3.0 * length, 1e-5);
    EXPECT_NEAR(medium.emitted(length).b, 4.0 * length, 1e-5);
  }
  EXPECT_FLOAT_EQ(medium.emitted(kInfinity).r, 4.0f);
}

}  // namespace
}  // namespace steradian
