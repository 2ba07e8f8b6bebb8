#include "steradian/lights/environment_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/core/scene/camera.h"
#include "steradian/tests/lights/environment_maps.h"
#include "steradian/tests/support/lanes_check.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using namespace steradian::test;

TEST(EnvironmentMap, IsWhatASphericalCameraSees) {
  const auto image = randomSky(16, 8);
  const EnvironmentMap sky({.image = image}, false);
  const Camera camera(SphericalCamera{}, 16, 8);  // along -z
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      const Vec2f film{static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f};
      const Vec3f direction = camera.ray(CameraSample<float>{film, {}, 0.0f}).direction;
      EXPECT_NEAR(sky.radiance(direction).r, image->at(x, y, 0), 1e-5f) << x << ' ' << y;
      EXPECT_NEAR(sky.radiance(direction).b, image->at(x, y, 2), 1e-5f) << x << ' ' << y;
    }
  }
}

TEST(EnvironmentMap, HasMinusZInItsMiddleAndXToTheRight) {
  const auto red = [](int column, Vec3f direction) {
    return EnvironmentMap({.image = sunAt(8, 4, column, 1)}, false).radiance(direction).r;
  };
  // The middle lies between columns 3 and 4, and the horizon between rows 1 and 2.
  EXPECT_NEAR(red(3, {0, 0, -1}), 0.25f, 1e-5f);
  EXPECT_NEAR(red(4, {0, 0, -1}), 0.25f, 1e-5f);
  EXPECT_NEAR(red(5, {1, 0, 0}), 0.25f, 1e-5f);
  EXPECT_NEAR(red(6, {1, 0, 0}), 0.25f, 1e-5f);
  EXPECT_NEAR(red(1, {-1, 0, 0}), 0.25f, 1e-5f);
  EXPECT_NEAR(red(0, {0, 0, 1}), 0.25f, 1e-5f);  // around the seam
  EXPECT_NEAR(red(7, {0, 0, 1}), 0.25f, 1e-5f);
}

// Counter-clockwise seen from above: what was at -z goes to -x.
TEST(EnvironmentMap, TurnsAboutTheVertical) {
  const auto image = randomSky(16, 8);
  const EnvironmentMap straight({.image = image}, false);
  for (const float degrees : {90.0f, -270.0f, 450.0f}) {
    const EnvironmentMap turned({.image = image, .rotation = degrees}, false);
    for (std::uint32_t i = 0; i < 100; ++i) {
      const auto w = randomWords<std::uint32_t>(i, 1u, 1u, 1u);
      const Vec3f d = UniformSphere<float>::sample({toUnitFloat<float>(w[0]), toUnitFloat<float>(w[1])});
      // About +y by a right angle: z goes to x, x to -z.
      EXPECT_NEAR(turned.radiance(Vec3f{d.z, d.y, -d.x}).g, straight.radiance(d).g, 2e-5f);
    }
  }
}

TEST(EnvironmentMap, ScalesAndTakesNothingNegative) {
  Image image(1, 1, {"R", "G", "B"});
  image.at(0, 0, 0) = 0.5f, image.at(0, 0, 1) = -3.0f, image.at(0, 0, 2) = 1.0f;
  const EnvironmentMap sky({.image = std::make_shared<const Image>(image), .scale = {2.0f, 3.0f, 0.5f}}, true);
  const Rgb c = sky.radiance(Vec3f{0.6f, 0.0f, 0.8f});
  EXPECT_EQ(c.r, 1.0f);
  EXPECT_EQ(c.g, 0.0f);
  EXPECT_EQ(c.b, 0.5f);
  EXPECT_NEAR(sky.total().r, kFourPi, 1e-5f);
  EXPECT_NEAR(sky.pdf(Vec3f{0, 1, 0}), kInvFourPi * 2.0f / kPi / 1e-6f, 10.0f);  // at the pole: see perSteradian
}

TEST(EnvironmentMap, TotalIsTheIntegralOfRadiance) {
  for (const auto& image : {randomSky(8, 4), randomSky(5, 1), randomSky(1, 3), sunAt(8, 4, 2, 0), sunAt(8, 4, 7, 2)}) {
    const EnvironmentMap sky({.image = image, .rotation = 30.0f}, false);
    const auto radiance = [&](Vec3f d) { return static_cast<double>(sky.radiance(d).g); };
    const double expected = integrateSphere(radiance, {.axis = {0, 1, 0}});
    EXPECT_NEAR(sky.total().g, expected, 2e-4 * expected);
  }
}

TEST(EnvironmentMap, DensityIsPositiveWhereverThereIsLight) {
  for (const int row : {0, 3, 7}) {
    const EnvironmentMap sky({.image = sunAt(16, 8, 5, row)}, true);
    int lit = 0;
    for (std::uint32_t i = 0; i < 20000; ++i) {
      const auto w = randomWords<std::uint32_t>(i, 2u, 1u, 1u);
      const Vec3f d = UniformSphere<float>::sample({toUnitFloat<float>(w[0]), toUnitFloat<float>(w[1])});
      const float radiance = sky.radiance(d).r, pdf = sky.pdf(d);
      if (radiance > 1e-4f) {
        ++lit;
        EXPECT_GT(pdf, 0.0f);
        // The bound of the header; the sine of a row is at most pi/2 times its mean.
        EXPECT_LT(radiance / pdf, 16.0f * kPiOver2 * 1.01f * sky.total().r);
      }
    }
    EXPECT_GT(lit, 20);
  }
}

TEST(EnvironmentMap, ASampleIsWhatRadianceAndPdfSay) {
  for (const auto& image : {randomSky(16, 8), sunAt(64, 32, 11, 9)}) {
    const EnvironmentMap sky({.image = image, .rotation = 77.0f}, true);
    int different = 0;
    for (std::uint32_t i = 0; i < 2000; ++i) {
      const auto w = randomWords<std::uint32_t>(i, 3u, 1u, 1u);
      const auto s = sky.sample(Vec2f{toUnitFloat<float>(w[0]), toUnitFloat<float>(w[1])});
      EXPECT_NEAR(length(s.direction.wi), 1.0f, 1e-6f);
      EXPECT_EQ(s.direction.distance, kInfinity);
      EXPECT_NEAR(s.radiance.g, sky.radiance(s.direction.wi).g, 1e-4f);
      // On the border of two pixels rounding may choose the other.
      different += std::abs(sky.pdf(s.direction.wi) / s.direction.pdf - 1.0f) > 1e-4f ? 1 : 0;
    }
    EXPECT_LE(different, 2);
  }
}

TEST(EnvironmentMap, WithoutATableOrLightThereIsNothingToSample) {
  for (const EnvironmentMap& sky :
       {EnvironmentMap({.image = sunAt(4, 2, 1, 1)}, false), EnvironmentMap({.image = sunAt(4, 2, 1, 1, 0.0f)}, true),
        EnvironmentMap({.image = sunAt(4, 2, 1, 1), .scale = {}}, true)}) {
    EXPECT_EQ(sky.sample(Vec2f{0.3f, 0.6f}).direction.pdf, 0.0f);
    EXPECT_EQ(sky.pdf(Vec3f{0, 0, 1}), 0.0f);
  }
}

TEST(EnvironmentMap, LanesAgreeWithScalars) {
  const EnvironmentMap sky({.image = randomSky(13, 7), .rotation = -33.0f}, true);
  const auto us = unitNumbers(800), vs = unitNumbers(800, 1);
  EXPECT_TRUE(sameInLanes<8>([&](auto u, auto v) { return sky.sample(Vec2{u, v}).direction.wi; }, us, vs));
  EXPECT_TRUE(sameInLanes<8>([&](auto u, auto v) { return sky.sample(Vec2{u, v}).direction.pdf; }, us, vs));
  EXPECT_TRUE(sameInLanes<8>([&](auto u, auto v) { return sky.sample(Vec2{u, v}).radiance.g; }, us, vs));
  const auto direction = [](auto u, auto v) { return UniformSphere<decltype(u)>::sample({u, v}); };
  EXPECT_TRUE(sameInLanes<16>([&](auto u, auto v) { return sky.pdf(direction(u, v)); }, us, vs));
  EXPECT_TRUE(sameInLanes<16>([&](auto u, auto v) { return sky.radiance(direction(u, v)).b; }, us, vs));
}

}  // namespace
}  // namespace steradian
