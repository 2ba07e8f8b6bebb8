#include "steradian/lights/skies.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/tests/lights/environment_maps.h"
#include "steradian/tests/lights/light_scenes.h"

namespace steradian {
namespace {

using namespace steradian::test;

SceneDescription pictureAndDusk() {
  SceneDescription scene;
  scene.addLight("", ConstantSky{grey(0.25f)});
  scene.addLight("", ImageSky{.image = sunAt(8, 4, 3, 1, 100.0f)});
  return scene;
}

TEST(Skies, AddUp) {
  const Skies skies(pictureAndDusk(), false, true);
  const Vec3f sun = pixelDirection(*sunAt(8, 4, 3, 1), 3, 1);
  EXPECT_NEAR(skies.radiance(sun).g, 100.25f, 1e-3f);
  EXPECT_FLOAT_EQ(skies.radiance(-sun).g, 0.25f);
  const EnvironmentMap picture({.image = sunAt(8, 4, 3, 1, 100.0f)}, false);
  EXPECT_NEAR(skies.power(2.0f).g, (picture.total().g + 0.25f * kFourPi) * kPi * 4.0f, 1e-2f);
  EXPECT_NEAR(skies.sampledPower(2.0f).g, picture.total().g * kPi * 4.0f, 1e-2f);
}

TEST(Skies, SampleWhatTheyAreToldTo) {
  const Vec3f up{0, 1, 0}, away = -pixelDirection(*sunAt(8, 4, 3, 1), 3, 1);
  const auto pdf = [&](bool smooth, bool pictures) { return Skies(pictureAndDusk(), smooth, pictures).pdf(up, away); };
  EXPECT_EQ(pdf(false, false), 0.0f);
  EXPECT_EQ(pdf(false, true), 0.0f);
  EXPECT_FLOAT_EQ(pdf(true, false), skyPdf(up, away));
  EXPECT_GT(pdf(true, true), 0.0f);
  EXPECT_LT(pdf(true, true), 0.5f * skyPdf(up, away));
  EXPECT_EQ(Skies(pictureAndDusk(), false, false).sample(up, Vec2f{0.5f, 0.5f}).pdf, 0.0f);
  EXPECT_TRUE(Skies(SceneDescription{}, true, true).empty());
  EXPECT_EQ(Skies(SceneDescription{}, true, true).sample(up, Vec2f{0.5f, 0.5f}).pdf, 0.0f);
}

TEST(Skies, ASampleCarriesTheLightOfAll) {
  for (const bool smooth : {false, true}) {
    const Skies skies(pictureAndDusk(), smooth, true);
    for (std::uint32_t i = 0; i < 500; ++i) {
      const LightSample<float> s = skies.sample(Vec3f{0, 1, 0}, lightRandom(i).position);
      const float radiance = skies.radiance(s.wi).g;
      EXPECT_NEAR(s.weight.g * s.pdf, radiance, 2e-4f * radiance + 1e-2f);
    }
  }
}

TEST(LightSet, SamplesPicturesUnlessToldOtherwise) {
  const SceneDescription scene = pictureAndDusk();
  const Ray<float> toSun{{}, pixelDirection(*sunAt(8, 4, 3, 1), 3, 1)}, down{{}, {0, -1, 0}};
  const ScatterPoint<float> from = pointAt({0, 0, 0});
  const LightSet usual(scene, kBounds), none(scene, kBounds, {.sampleImageSkies = false});
  EXPECT_EQ(usual.size(), 1u);
  EXPECT_FALSE(usual.empty());
  EXPECT_TRUE(none.empty());
  EXPECT_TRUE(none.hasSky());
  EXPECT_GT(usual.emission(from, toSun, {}).pdf, 0.0f);
  EXPECT_EQ(usual.emission(from, down, {}).pdf, 0.0f);
  EXPECT_EQ(none.emission(from, toSun, {}).pdf, 0.0f);
  for (const LightSet* lights : {&usual, &none}) {
    EXPECT_NEAR(lights->emission(from, toSun, {}).radiance.r, 100.25f, 1e-3f);
    EXPECT_NEAR(lights->radiance(toSun, {}).r, 100.25f, 1e-3f);
  }
  // Of two skies the sampled one alone counts against other lights.
  SceneDescription more = scene;
  const Rgb power = Skies(scene, false, true).sampledPower(std::sqrt(3.0f));
  more.addLight("", PointLight{{0, 1, 0}, power * kInvFourPi});
  const LightSet two(more, kBounds);
  EXPECT_NEAR(two.info()[1].probability, 0.5f, 1e-5f);
}

TEST(Skies, LanesAgreeWithScalars) {
  using F = Lanes<8>;
  SceneDescription scene = pictureAndDusk();
  scene.addLight("", ImageSky{.image = randomSky(9, 5), .rotation = 20.0f});
  const Skies skies(scene, true, true);
  for (std::uint32_t round = 0; round < 200; ++round) {
    Vec3<F> normal;
    Vec2<F> u;
    for (int i = 0; i < 8; ++i) {
      setLane(u, i, lightRandom(8 * round + static_cast<std::uint32_t>(i)).position);
      setLane(normal, i, i == 5 ? Vec3f{} : Vec3f{0.6f, 0.8f, 0.0f});
    }
    const LightSample<F> wide = skies.sample(normal, u);
    const F pdf = skies.pdf(normal, wide.wi);
    const Spectrum<F> radiance = skies.radiance(wide.wi);
    for (int i = 0; i < 8; ++i) {
      const LightSample<float> one = skies.sample(lane(normal, i), lane(u, i));
      ASSERT_EQ(wide.pdf[i], one.pdf);
      ASSERT_EQ(wide.weight.b[i], one.weight.b);
      ASSERT_EQ(wide.wi.z[i], one.wi.z);
      ASSERT_EQ(pdf[i], skies.pdf(lane(normal, i), one.wi));
      ASSERT_EQ(radiance.r[i], skies.radiance(one.wi).r);
    }
  }
}

}  // namespace
}  // namespace steradian
