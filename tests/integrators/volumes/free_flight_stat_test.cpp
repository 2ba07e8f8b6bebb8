/// Media against closed forms, and the strategies against one another.
#include <gtest/gtest.h>

#include <cmath>

#include "steradian/tests/integrators/small_scenes.h"
#include "steradian/tests/integrators/strategies.h"

namespace steradian {
namespace {

using test::agree;
using test::expectRadiance;
using test::expectStrategiesAgree;
using test::meanOf;
using test::with;

Interior filled(SceneDescription& scene, MediumDescription medium) {
  medium.name = "medium";
  return Interior{scene.addMedium(std::move(medium))};
}

/// A square of radiance 1 behind a slab from z = 0 to z = 2, seen along z.
SceneDescription slab(MediumDescription medium) {
  SceneDescription scene;
  const Id box = test::addBox(scene, {0, 0, 1}, {5, 5, 1}, 0.0f, scene.addMaterial("air", InterfaceMaterial{}));
  scene.shapes[box].interior = filled(scene, std::move(medium));
  scene.setEmission(test::addQuad(scene, {-1, -1, 3}, {0, 2, 0}, {2, 0, 0}, test::addAbsorber(scene)),
                    {grey(1.0f), false});
  scene.camera = OrthographicCamera{.lookFrom = {0, 0, -2}, .lookAt = {0, 0, 0}, .height = 0.1f};
  return scene;
}

TEST(Media, AbsorbAsBeerAndLambertSay) { expectRadiance(slab({.absorption = grey(0.7f)}), std::exp(-1.4)); }

// Embree's own triangles: each is passed once.
TEST(Media, FillMeshes) {
  SceneDescription scene = slab({.absorption = grey(0.7f)});
  TriangleMesh box;
  for (const float z : {0.0f, 2.0f}) {
    for (const float y : {-5.0f, 5.0f}) {
      for (const float x : {-5.0f, 5.0f}) box.positions.push_back({x, y, z});
    }
  }
  box.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  scene.shapes[0].geometry = std::move(box);
  const Scene built(scene,
                    {.geometry = {.accel = {.maxClustersWithoutTree = 0, .maxClusteredTriangles = 0}}, .lights = {}});
  const RenderResult result = render(built, PathIntegrator(with(Strategy::Mis)), test::settingsOf(8, 8, 4));
  for (int i = 0; i < 64; ++i) EXPECT_NEAR(result.film.radiance(i % 8, i / 8).g, std::exp(-1.4), 1e-5);
}

TEST(Media, EmitWhatTheyDoNotAbsorb) {
  SceneDescription scene = slab({.absorption = grey(0.7f), .emission = grey(2.0f)});
  scene.emissions[0].radiance = {};
  expectRadiance(scene, 2.0 * (1.0 - std::exp(-1.4)) / 0.7);
}

TEST(Media, EmissionIsWeakenedByMediaBefore) {
  for (const MediumDescription& haze : {MediumDescription{.absorption = grey(0.4f)},
                                        MediumDescription{.absorption = grey(0.1f), .scattering = grey(0.3f)}}) {
    SceneDescription scene = slab({.absorption = grey(0.7f), .emission = grey(2.0f)});
    scene.emissions[0].radiance = {};
    const Id before = test::addBox(scene, {0, 0, -1}, {5, 5, 0.5f}, 0.0f, scene.shapes[0].material);
    scene.shapes[before].interior = filled(scene, haze);
    scene.defaults.maxDepth = 0;
    expectRadiance(scene, std::exp(-0.4) * 2.0 * (1.0 - std::exp(-1.4)) / 0.7);
  }
}

TEST(Media, WhatIsNotScatteredArrives) {
  SceneDescription scene = slab({.absorption = grey(0.1f), .scattering = grey(0.6f)});
  scene.defaults.maxDepth = 0;
  expectRadiance(scene, std::exp(-1.4));
}

// One optical depth is drawn for all of the way.
TEST(Media, ScatterOverSeveralSegments) {
  SceneDescription scene = slab({.scattering = grey(0.6f)});
  const Id before = test::addBox(scene, {0, 0, -1}, {5, 5, 0.5f}, 0.0f, scene.shapes[0].material);
  scene.shapes[before].interior = filled(scene, {.scattering = grey(0.8f)});
  scene.defaults.maxDepth = 0;
  expectRadiance(scene, std::exp(-2.0));
}

// Channels of different density: the flight is drawn for one of them, all are weighed.
TEST(Media, EveryChannelHasItsOwnLaw) {
  SceneDescription scene = slab({.absorption = {0.0f, 0.2f, 0.0f}, .scattering = {0.1f, 0.5f, 2.0f}});
  scene.defaults.maxDepth = 0;
  expectRadiance(scene, 0.2126 * std::exp(-0.2) + 0.7152 * std::exp(-1.4) + 0.0722 * std::exp(-4.0));
}

/// Single scattering of a distant light in a slab, seen straight on: light comes along the view, from behind the
/// camera, and goes back: sigma_s p(-1) (1 - exp(-2 sigma_t d)) / (2 sigma_t).
TEST(Media, ScatterOnceAsTheIntegralSays) {
  for (const float g : {0.0f, 0.5f, -0.3f}) {
    SceneDescription scene = slab({.absorption = grey(0.1f), .scattering = grey(0.6f), .anisotropy = g});
    scene.emissions[0].radiance = {};
    scene.addLight("sun", DistantLight{{0.0f, 0.0f, 1.0f}, grey(1.0f)});
    scene.defaults.maxDepth = 1;
    const double back = (1.0 - g) / (4.0 * M_PI * (1.0 + g) * (1.0 + g));
    expectRadiance(scene, 0.6 * back * (1.0 - std::exp(-2.8)) / 1.4);
  }
}

// A white medium changes nothing under a white sky, however it scatters and whatever is around it.
TEST(Media, FurnaceOfWhiteMedia) {
  for (const float g : {0.0f, 0.8f, -0.5f}) {
    SceneDescription scene = test::sphereInSky(InterfaceMaterial{});
    scene.shapes[0].interior = filled(scene, {.scattering = {0.3f, 1.0f, 5.0f}, .anisotropy = g});
    scene.defaults.maxDepth = 1000;
    expectRadiance(scene, 1.0);
    scene.materials[0].model = DielectricMaterial{.eta = 1.4f};
    expectRadiance(scene, 1.0);
    scene.shapes[0].interior->priority = 3;
    expectRadiance(scene, 1.0);
  }
}

TEST(Media, OfAllSpaceAreFilledUpToTheWalls) {
  SceneDescription scene = test::furnace(0.6f, 0.5f);
  scene.outside = scene.addMedium({.name = "fog", .scattering = grey(0.4f)});
  scene.materials[0].model = LambertMaterial{scene.addColour(grey(0.0f))};
  scene.defaults.maxDepth = 1000;
  expectRadiance(scene, 0.5);
}

SceneDescription smokyRoom() {
  SceneDescription scene = test::room();
  const Id air = scene.addMaterial("air", InterfaceMaterial{});
  scene.shapes[test::addBox(scene, {-0.3f, -0.4f, 0.1f}, {0.4f, 0.5f, 0.4f}, 20.0f, air)].interior =
      filled(scene, {.absorption = {0.5f, 1.0f, 0.2f}, .scattering = {2.0f, 1.0f, 4.0f}, .anisotropy = 0.4f});
  const Id glass = scene.addMaterial("glass", DielectricMaterial{.eta = 1.3f});
  scene.shapes[test::addSphere(scene, {0.4f, -0.5f, 0.2f}, 0.4f, glass)].interior =
      filled(scene, {.absorption = grey(0.1f), .scattering = grey(2.0f)});
  return scene;
}

TEST(Media, StrategiesAgreeInSmoke) { expectStrategiesAgree(smokyRoom(), 256, 16); }

TEST(Media, StrategiesAgreeThroughABoundaryThatIsATarget) {
  SceneDescription scene = smokyRoom();
  const Id window =
      test::addQuad(scene, {-0.5f, 0.5f, -0.5f}, {1, 0, 0}, {0, 0, 1}, scene.addMaterial("air", InterfaceMaterial{}));
  scene.shapes[window].target = true;
  expectStrategiesAgree(scene, 256, 16);
}

// Fog that lies on the floor: whichever of the two rounding puts first.
TEST(Media, StandOnTheFloorWithoutALeak) {
  for (const MediumDescription& fog :
       {MediumDescription{.scattering = grey(2.5f)}, MediumDescription{.absorption = grey(0.5f)}}) {
    const auto fogAt = [&](float height) {
      SceneDescription scene = test::room();
      const Id box = test::addBox(scene, {0.0f, height - 0.4f, 0.1f}, {0.5f, 0.6f, 0.5f}, 20.0f,
                                  scene.addMaterial("air", InterfaceMaterial{}));
      scene.shapes[box].interior = filled(scene, fog);
      return scene;
    };
    const Scene above(fogAt(1e-3f));
    const PathIntegrator path(with(Strategy::Mis));
    const auto expected = meanOf(above, path, 24, 512, 2);
    for (const float height : {0.0f, 2e-7f, -2e-7f}) {
      const Scene standing(fogAt(height));
      EXPECT_TRUE(agree(meanOf(standing, path, 24, 512, 1), expected)) << height;
    }
  }
}

// A fault that the tests above must notice.
TEST(Media, TwoPercentMoreScatteringAreFound) {
  SceneDescription scene = slab({.absorption = grey(0.1f), .scattering = grey(0.6f * 1.02f)});
  scene.defaults.maxDepth = 0;
  const Scene built(scene);
  EXPECT_FALSE(agree(meanOf(built, PathIntegrator(with(Strategy::Mis)), 16, 1024), std::exp(-1.4)));
}

/// Mean difference of two pictures that ought to be the same but for rounding.
double difference(const SceneDescription& a, const SceneDescription& b) {
  const auto picture = [](const SceneDescription& s) {
    return render(Scene(s), PathIntegrator(with(Strategy::Mis)), test::settingsOf(24, 24, 16)).film.image();
  };
  const Image one = picture(a), other = picture(b);
  double sum = 0.0, total = 0.0;
  for (std::size_t i = 0; i < one.values().size(); ++i) {
    sum += std::abs(static_cast<double>(one.values()[i]) - static_cast<double>(other.values()[i]));
    total += std::abs(static_cast<double>(one.values()[i]));
  }
  return sum / total;
}

// Priorities replace what one had to model by hand: relative indices at every contact, and cut-outs.
TEST(NestedDielectrics, AreWhatRelativeIndicesSay) {
  const auto spheres = [](float inner, float outer) {
    SceneDescription scene = test::room();
    test::addSphere(scene, {0, 0, 0}, 0.7f, scene.addMaterial("outer", DielectricMaterial{.eta = outer}));
    test::addSphere(scene, {0, 0.1f, 0}, 0.4f, scene.addMaterial("inner", DielectricMaterial{.eta = inner}));
    return scene;
  };
  SceneDescription byHand = spheres(1.33f / 1.5f, 1.5f), nested = spheres(1.33f, 1.5f);
  const std::size_t outer = nested.shapes.size() - 2, inner = nested.shapes.size() - 1;
  nested.shapes[outer].interior = Interior{.priority = 1};
  nested.shapes[inner].interior = Interior{.priority = 2};
  EXPECT_LT(difference(byHand, nested), 1e-4);
  // An inner body of lower priority is not there at all.
  nested.shapes[inner].interior = Interior{};
  nested.shapes[inner].interior->priority = 1;
  nested.shapes[outer].interior->priority = 2;
  byHand.shapes.pop_back();
  EXPECT_LT(difference(byHand, nested), 1e-4);
}

}  // namespace
}  // namespace steradian
