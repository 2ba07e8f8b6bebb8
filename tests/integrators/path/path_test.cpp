#include "steradian/integrators/path/path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "steradian/integrators/render/render.h"
#include "steradian/tests/integrators/small_scenes.h"

namespace steradian {
namespace {

using test::settingsOf;

PathSettings with(Strategy strategy) {
  PathSettings settings;
  settings.strategy = strategy;
  settings.rouletteStrength = 0.0f;
  return settings;
}

Film renderFilm(const SceneDescription& description, const PathSettings& settings, std::uint32_t samples = 4) {
  return render(Scene(description), PathIntegrator(settings), settingsOf(6, 6, samples)).film;
}

/// Every pixel is `expected` up to rounding.
void expectEverywhere(const Film& film, double expected, double tolerance = 1e-5) {
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 6; ++x)
      EXPECT_NEAR(film.luminanceEstimate(x, y).mean, expected, tolerance * expected) << x << ' ' << y;
  }
}

TEST(Path, DepthCountsBouncesInTheFurnace) {
  // BSDF samples find the same radiance in every direction, so there is no noise: 0.5 (1 + r + ... + r^d).
  PathSettings settings = with(Strategy::Bsdf);
  double expected = 0.0;
  for (std::uint32_t depth = 0; depth < 6; ++depth) {
    settings.maxDepth = depth;
    expected += 0.5 * std::pow(0.75, depth);
    expectEverywhere(renderFilm(test::furnace(0.75f, 0.5f), settings), expected);
  }
}

TEST(Path, TheScenesDepthHoldsUnlessGiven) {
  SceneDescription scene = test::furnace(0.5f, 1.0f);
  scene.defaults.maxDepth = 1;
  expectEverywhere(renderFilm(scene, with(Strategy::Bsdf)), 1.5);
}

TEST(Path, DepthZeroIsEmissionAloneInEveryStrategy) {
  for (const Strategy strategy : {Strategy::Bsdf, Strategy::Light, Strategy::Mis, Strategy::Mixture}) {
    PathSettings settings = with(strategy);
    settings.maxDepth = 0;
    expectEverywhere(renderFilm(test::furnace(0.5f, 2.0f), settings), 2.0);
  }
}

TEST(Path, LosslessSpheresVanishInAWhiteSky) {
  PathSettings settings = with(Strategy::Bsdf);
  settings.maxDepth = 1000;
  for (const MaterialModel& model :
       {MaterialModel{MetalMaterial{}}, MaterialModel{DielectricMaterial{1.5f, false}},
        MaterialModel{DielectricMaterial{1.5f, true}}, MaterialModel{DielectricMaterial{0.8f, false}}}) {
    SceneDescription scene = test::sphereInSky(model);
    scene.addColour(grey(1.0f));
    if (auto* metal = std::get_if<MetalMaterial>(&scene.materials[0].model)) metal->reflectance = 0;
    for (const Strategy strategy : {Strategy::Bsdf, Strategy::Light, Strategy::Mis, Strategy::Mixture}) {
      settings.strategy = strategy;
      expectEverywhere(renderFilm(scene, settings), 1.0, 1e-4);
    }
  }
}

TEST(Path, RouletteDoesNotTakeRefractionForAbsorption) {
  // Entering glass divides radiance by eta^2 until it is left; a path in lossless glass must survive all the same.
  PathSettings settings = with(Strategy::Bsdf);
  settings.maxDepth = 1000;
  settings.rouletteStart = 0;
  settings.rouletteStrength = 1.0f;
  expectEverywhere(renderFilm(test::sphereInSky(DielectricMaterial{1.5f, false}), settings), 1.0, 1e-4);
}

TEST(Path, RouletteBeginsWithTheBounceThatTheSettingsSay) {
  for (std::uint32_t start = 0; start < 4; ++start) {
    PathSettings settings;
    settings.maxDepth = 5;
    settings.rouletteStart = start;
    settings.rouletteStrength = 1.0f;
    const Scene scene(test::furnace(0.25f, 1.0f));
    const auto result = render(scene, PathIntegrator(settings), settingsOf(6, 6, 4));
    for (std::uint32_t bounces = 0; bounces < start; ++bounces) {
      EXPECT_EQ(result.statistics.paths.pathLengths[bounces], 0u) << start;
    }
    // Three of four paths, or more, end there.
    EXPECT_GT(result.statistics.paths.pathLengths[start], 72u) << start;
  }
}

TEST(Path, DiracLightsAreSampledInEveryStrategy) {
  // The radiance of a white floor is E / pi, with E = I cos / d^2 or the irradiance times the cosine.
  const std::pair<LightModel, double> cases[]{
      {PointLight{{0.0f, 2.0f, 0.0f}, grey(8.0f)}, 2.0},
      {DistantLight{{0.0f, -0.8f, 0.6f}, grey(3.0f)}, 2.4},
      {SpotLight{{0.0f, 1.0f, 0.0f}, {0.0f, -1.0f, 0.0f}, grey(1.0f), 10.0f, 20.0f}, 1.0},
  };
  for (const auto& [light, irradiance] : cases) {
    SceneDescription scene = test::floorPoint();
    scene.addLight("light", light);
    for (const Strategy strategy : {Strategy::Bsdf, Strategy::Light, Strategy::Mis, Strategy::Mixture}) {
      expectEverywhere(renderFilm(scene, with(strategy)), irradiance / 3.14159265358979, 1e-3);
    }
  }
}

TEST(Path, FirstHitsGoToTheFilm) {
  SceneDescription scene = test::floorPoint();
  const Film film = renderFilm(scene, with(Strategy::Mis));
  const Image image = film.image();
  const auto value = [&](const char* channel) { return image.at(2, 3, image.channel(channel)); };
  EXPECT_EQ(value("A"), 1.0f);
  EXPECT_NEAR(value("Albedo.G"), 1.0f, 1e-6);
  EXPECT_NEAR(value("N.Y"), 1.0f, 1e-6);
  EXPECT_NEAR(value("Z"), std::sqrt(14.0f), 1e-3);
}

TEST(Path, UnknownTargetsAreNamedWithSuggestions) {
  PathSettings settings = with(Strategy::Mixture);
  settings.targets = {"lihgts"};
  try {
    renderFilm(test::room(), settings);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    EXPECT_NE(std::string(error.what()).find("lights"), std::string::npos) << error.what();
  }
}

TEST(Path, RefusesSettingsOutOfRange) {
  const auto refused = [](auto change) {
    PathSettings settings;
    change(settings);
    try {
      PathIntegrator integrator(settings);
    } catch (const Error& error) {
      return error.kind() == ErrorKind::Usage;
    }
    return false;
  };
  EXPECT_FALSE(refused([](auto&) {}));
  EXPECT_TRUE(refused([](auto& s) { s.lightSamples = 0; }));
  EXPECT_TRUE(refused([](auto& s) { s.maxDepth = PathSettings::kMaxDepth + 1; }));
  EXPECT_TRUE(refused([](auto& s) { s.targetWeight = std::numeric_limits<float>::quiet_NaN(); }));
  EXPECT_TRUE(refused([](auto& s) { s.rouletteStrength = 1.5f; }));
}

// A point on an emitter is off it by a rounding error, and must not sample that emitter as a huge light in front of it.
TEST(Path, EmittersThatScatterDoNotLightThemselves) {
  SceneDescription scene;
  const Id matte = scene.addMaterial("matte", LambertMaterial{scene.addColour({0.5f, 0.5f, 0.5f})});
  const auto view = [&](ShapeGeometry geometry, bool twoSided, Vec3f lookFrom) {
    SceneDescription one = scene;
    one.setEmission(one.addShape("light", std::move(geometry), matte), {{1.0f, 1.0f, 1.0f}, twoSided});
    one.camera = PerspectiveCamera{.lookFrom = lookFrom, .lookAt = {0.1f, 0.05f, 0.0f}, .verticalFov = 2.0f};
    return one;
  };
  QuadSet quad;
  quad.add({-1.3f, -1.1f, 0.31f}, {2.7f, 0.2f, -0.43f}, {0.11f, 2.3f, 0.37f});
  SphereSet sphere;
  sphere.add({0.1f, 0.05f, 0.0f}, 0.7f);
  BoxSet box;
  box.addRotatedY({0.1f, 0.05f, 0.0f}, {0.6f, 0.5f, 0.7f}, 23.0f);
  const Vec3f front{0.9f, 0.7f, 5.0f}, back{0.9f, 0.7f, -5.0f};
  for (const Strategy strategy : {Strategy::Bsdf, Strategy::Light, Strategy::Mis, Strategy::Mixture}) {
    SCOPED_TRACE(static_cast<int>(strategy));
    expectEverywhere(renderFilm(view(quad, false, back), with(strategy), 16), 0.0);
    expectEverywhere(renderFilm(view(quad, true, front), with(strategy), 16), 1.0);
    expectEverywhere(renderFilm(view(sphere, true, front), with(strategy), 16), 1.0);
    expectEverywhere(renderFilm(view(box, true, front), with(strategy), 16), 1.0);
  }
}

}  // namespace
}  // namespace steradian
