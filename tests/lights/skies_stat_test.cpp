#include "steradian/lights/skies.h"

#include <gtest/gtest.h>

#include "steradian/tests/lights/environment_maps.h"
#include "steradian/tests/lights/light_scenes.h"
#include "steradian/tests/support/proof.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using namespace steradian::test;

const Vec3f kNormal = normalize(Vec3f{0.2f, 1.0f, -0.4f});

/// The skies at a point, as something with sample() and pdf().
struct SkiesAt {
  const Skies& skies;
  Vec3f normal;
  float wrong = 1.0f;

  template <class F>
  DirectionSample<F> sample(Vec2<F> u) const {
    const LightSample<F> s = skies.sample(broadcast<F>(normal), u);
    return {s.wi, s.pdf * F(wrong), s.distance};
  }
  template <class F>
  F pdf(Vec3<F> wi) const {
    return skies.pdf(broadcast<F>(normal), wi) * F(wrong);
  }
};

Skies skiesOf(std::initializer_list<LightModel> models, bool smooth = true, bool pictures = true) {
  SceneDescription scene;
  for (const LightModel& model : models) scene.addLight("", model);
  return Skies(scene, smooth, pictures);
}

/// Densities jump at the borders of pixels, where quadrature is not exact.
CheckOptions options(SphereGrid grid = {.axis = {0, 1, 0}, .rings = 12, .sectors = 16}) {
  return {.normalisationTolerance = 3e-3, .pdfTolerance = 2e-3, .edgeShare = 2e-4, .grid = grid, .inverse = false};
}

TEST(SkiesStat, APicture) {
  EXPECT_TRUE(prove(SkiesAt{skiesOf({ImageSky{.image = randomSky(8, 4)}}), kNormal}, options()));
  EXPECT_TRUE(prove(SkiesAt{skiesOf({ImageSky{.image = randomSky(9, 5), .rotation = 100.0f}}), kNormal}, options()));
}

TEST(SkiesStat, ASunOfOnePixel) {
  const auto low = sunAt(64, 32, 40, 9, 5000.0f), pole = sunAt(64, 32, 40, 0, 5000.0f);
  const SphereGrid about{.axis = pixelDirection(*low, 40, 9), .focus = 0.3f};
  EXPECT_TRUE(prove(SkiesAt{skiesOf({ImageSky{.image = low}}), kNormal}, options(about)));
  const SphereGrid aligned{.axis = {0, 1, 0}, .focus = 0.3f, .sectors = 64};
  EXPECT_TRUE(prove(SkiesAt{skiesOf({ImageSky{.image = pole}}), kNormal}, options(aligned)));
}

TEST(SkiesStat, PicturesAndASmoothSkyTogether) {
  const Skies skies = skiesOf({ImageSky{.image = randomSky(8, 4)}, GradientSky{grey(0.1f), grey(0.4f)},
                               ImageSky{.image = sunAt(16, 8, 3, 2, 20.0f), .rotation = 40.0f}});
  EXPECT_TRUE(prove(SkiesAt{skies, kNormal}, options()));
  EXPECT_TRUE(prove(SkiesAt{skies, {}}, options()));  // a free point
}

TEST(SkiesStat, ADensityTwoPercentOffIsRejected) {
  const Skies skies = skiesOf({ImageSky{.image = randomSky(8, 4)}});
  EXPECT_FALSE(prove(SkiesAt{skies, kNormal, 1.02f}, options()));
}

double radianceAt(const Skies& skies, Vec3f d) { return static_cast<double>(skies.radiance(d).g); }

/// Irradiance at a surface with kNormal by samples of the light, which may be falsified.
double irradianceTest(const SceneDescription& scene, const Skies& skies, LightSetSettings settings,
                      double factor = 1.0) {
  const double expected =
      integrateHemisphere([&](Vec3f d) { return radianceAt(skies, d) * dot(d, kNormal); }, kNormal, 1e-6);
  const LightSet lights(scene, kBounds, settings);
  ScatterPoint<float> from = pointAt({0, 0, 0});
  from.geometricNormal = kNormal;
  RunningMean mean;
  for (std::uint32_t i = 0; i < 200000; ++i) {
    const LightSample<float> s = lights.sample(from, lightRandom(i));
    mean.add(s.pdf > 0.0f ? factor * static_cast<double>(s.weight.g * maximum(dot(s.wi, kNormal), 0.0f)) : 0.0);
  }
  return zTestPValue(mean.mean(), mean.standardError(), expected, 1e-4 * expected);
}

TEST(SkiesStat, IrradianceIsTheIntegral) {
  SceneDescription picture, both;
  picture.addLight("", ImageSky{.image = randomSky(8, 4), .scale = {1.0f, 2.0f, 3.0f}, .rotation = 30.0f});
  both = picture;
  both.addLight("", GradientSky{grey(0.1f), grey(0.4f)});
  const Skies one(picture, true, true), two(both, true, true);
  const LightSetSettings all{.sampleSkies = true};
  EXPECT_GT(irradianceTest(picture, one, {}), suiteLevel());
  EXPECT_GT(irradianceTest(picture, one, all), suiteLevel());
  EXPECT_GT(irradianceTest(both, two, all), suiteLevel());
  EXPECT_LT(irradianceTest(picture, one, {}, 1.02), suiteLevel()) << "2 % too much is found";
  EXPECT_LT(irradianceTest(both, two, all, 1.02), suiteLevel()) << "2 % too much is found";
}

}  // namespace
}  // namespace steradian
