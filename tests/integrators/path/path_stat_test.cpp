/// The strategies and proposals of the path integrator estimate the same picture, and wrong densities are detected.
#include <gtest/gtest.h>

#include <cmath>

#include "steradian/integrators/path/path_context.h"
#include "steradian/integrators/path/path_loop.h"
#include "steradian/tests/integrators/small_scenes.h"
#include "steradian/tests/integrators/strategies.h"

namespace steradian {
namespace {

using test::agree;
using test::Estimate;
using test::expectRadiance;
using test::expectStrategiesAgree;
using test::kStrategies;
using test::meanOf;
using test::with;

// --- Known radiance ---------------------------------------------------------------------------------------------

TEST(DirectLight, OfASphereIsItsFormFactor) {
  SceneDescription scene = test::floorPoint();
  scene.setEmission(test::addSphere(scene, {0, 2, 0}, 0.5f, test::addAbsorber(scene)), {grey(1.0f), false});
  expectRadiance(scene, 0.1963495408 / 3.14159265359);
}

TEST(DirectLight, OfADiskIsItsFormFactor) {
  SceneDescription scene = test::floorPoint();
  const Id disk = scene.addShape("disk", DiskSet{{0}, {2}, {0}, {0}, {-1}, {0}, {0.5f}}, test::addAbsorber(scene));
  scene.setEmission(disk, {grey(1.0f), false});
  expectRadiance(scene, 0.1847995679 / 3.14159265359);
}

TEST(DirectLight, OfASquareIsItsFormFactor) {
  SceneDescription scene = test::floorPoint();
  const Id square = test::addQuad(scene, {-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1}, test::addAbsorber(scene));
  scene.setEmission(square, {grey(1.0f), false});
  expectRadiance(scene, 0.7522750 / 3.14159265359);
}

TEST(DirectLight, OfASkyIsItsRadiance) {
  SceneDescription scene = test::floorPoint();
  scene.addLight("sky", ConstantSky{grey(0.3f)});
  expectRadiance(scene, 0.3);
}

TEST(DirectLight, OfAGradientSky) {
  // E = integral of (a + b y) y over the hemisphere = pi a + 2 pi b / 3 with a = 0.5, b = 0.25.
  SceneDescription scene = test::floorPoint();
  scene.addLight("sky", GradientSky{grey(0.25f), grey(0.75f)});
  expectRadiance(scene, 0.5 + 2.0 * 0.25 / 3.0);
}

TEST(Furnace, EveryStrategyIsTheGeometricSeries) {
  SceneDescription scene = test::furnace(0.6f, 0.5f);
  scene.defaults.maxDepth = 4;
  expectRadiance(scene, 0.5 * (1.0 - std::pow(0.6, 5)) / 0.4);
}

TEST(Furnace, WhiteSphereInAWhiteSky) {
  SceneDescription scene = test::sphereInSky(LambertMaterial{});
  std::get<LambertMaterial>(scene.materials[0].model).reflectance = scene.addColour(grey(1.0f));
  expectRadiance(scene, 1.0);
  scene.materials[0].model = MetalMaterial{0, 1.0f};
  expectStrategiesAgree(scene, 256, 16);
}

// --- Agreement --------------------------------------------------------------------------------------------------

TEST(Strategies, AgreeInARoomWithSeveralLights) {
  SceneDescription scene = test::room();
  const Id lamp = test::addSphere(scene, {0.5f, -0.3f, 0.3f}, 0.2f, test::addAbsorber(scene));
  scene.setEmission(lamp, {{2.0f, 1.0f, 0.5f}, false});
  test::addBox(scene, {-0.4f, -0.6f, 0.0f}, {0.3f, 0.4f, 0.3f}, 25.0f, test::addLambert(scene, {0.7f, 0.7f, 0.1f}));
  scene.addLight("sky", GradientSky{grey(0.1f), grey(0.4f)});
  scene.addLight("bulb", PointLight{{-0.5f, 0.3f, 0.6f}, grey(0.2f)});
  expectStrategiesAgree(scene, 128);
}

TEST(Strategies, AgreeWithALightBehindAGlassTarget) {
  SceneDescription scene = test::room();
  const Id glass = scene.addMaterial("glass", DielectricMaterial{1.5f, false});
  const Id ball = test::addSphere(scene, {0.0f, 0.3f, 0.0f}, 0.45f, glass);
  scene.shapes[ball].target = true;
  expectStrategiesAgree(scene, 256);
}

TEST(Strategies, AgreeOnACoatedBox) {
  SceneDescription scene = test::room();
  const Id base = scene.addColour({0.6f, 0.3f, 0.1f});
  const Id coat = scene.addMaterial("coat", CoatedMaterial{base, 1.5f});
  const Id box = test::addBox(scene, {0.1f, -0.5f, 0.0f}, {0.4f, 0.5f, 0.3f}, 20.0f, coat);
  scene.shapes[box].target = true;
  expectStrategiesAgree(scene, 128);
}

TEST(Strategies, AgreeOnFuzzyMetal) {
  SceneDescription scene = test::room();
  const Id colour = scene.addColour({0.8f, 0.8f, 0.6f});
  test::addSphere(scene, {-0.4f, -0.5f, 0.0f}, 0.45f, scene.addMaterial("rough", MetalMaterial{colour, 1.0f}));
  test::addSphere(scene, {0.5f, -0.5f, 0.2f}, 0.35f, scene.addMaterial("satin", MetalMaterial{colour, 0.3f}));
  expectStrategiesAgree(scene, 128);
}

TEST(Strategies, AgreeWithOverlappingAndOccludedTargets) {
  SceneDescription scene = test::room();
  const Id glass = scene.addMaterial("glass", DielectricMaterial{1.5f, false});
  const Id grey5 = test::addLambert(scene, grey(0.5f));
  const Id ball = test::addSphere(scene, {0.3f, -0.3f, 0.2f}, 0.35f, glass);
  const Id box = test::addBox(scene, {0.3f, -0.3f, 0.2f}, {0.15f, 0.15f, 0.15f}, 30.0f, grey5);  // inside the ball
  const Id hidden = test::addBox(scene, {-0.6f, -0.8f, -0.5f}, {0.1f, 0.1f, 0.1f}, 0.0f, grey5);
  test::addBox(scene, {-0.6f, -0.6f, -0.2f}, {0.3f, 0.4f, 0.1f}, 0.0f, grey5);  // in front of it
  for (const Id target : {ball, box, hidden}) scene.shapes[target].target = true;
  for (ShapeDescription& shape : scene.shapes) shape.target = shape.target || shape.emission != kNone;
  expectStrategiesAgree(scene, 256);
}

TEST(Strategies, AgreeUnderAPictureOfASky) {
  SceneDescription scene = test::underAnEnvironmentMap();
  expectStrategiesAgree(scene, 256);
  scene.addLight("dusk", GradientSky{grey(0.3f), {0.1f, 0.2f, 0.4f}});  // and with another behind it
  scene.addLight("bulb", PointLight{{-0.5f, 2.0f, 1.6f}, grey(0.5f)});
  expectStrategiesAgree(scene, 256);
}

TEST(ScatterPdf, EveryProposalAgrees) {
  SceneDescription description = test::room();
  const Id base = description.addColour({0.6f, 0.3f, 0.1f});
  test::addSphere(description, {-0.4f, -0.5f, 0.0f}, 0.45f,
                  description.addMaterial("coat", CoatedMaterial{base, 1.5f}));
  test::addSphere(description, {0.5f, -0.6f, 0.2f}, 0.35f, description.addMaterial("rough", MetalMaterial{base, 1.0f}));
  const Scene scene(description);
  const Estimate expected = meanOf(scene, PathIntegrator(with(Strategy::Mis)), 24, 256, 100);
  std::uint32_t seed = 0;
  for (const ScatterPdf pdf : {ScatterPdf::Cosine, ScatterPdf::Hemisphere, ScatterPdf::Sphere}) {
    for (const Strategy strategy : kStrategies) {
      EXPECT_TRUE(agree(meanOf(scene, PathIntegrator(with(strategy, pdf)), 24, 128, ++seed), expected)) << seed;
    }
  }
}

TEST(LightSamples, EveryNumberAgrees) {
  const Scene scene(test::room());
  const Estimate expected = meanOf(scene, PathIntegrator(with(Strategy::Mis)), 24, 128, 100);
  for (const Strategy strategy : {Strategy::Mis, Strategy::Light}) {
    for (const std::uint32_t count : {2u, 5u}) {
      PathSettings settings = with(strategy);
      settings.lightSamples = count;
      EXPECT_TRUE(agree(meanOf(scene, PathIntegrator(settings), 24, 64, count), expected)) << count;
    }
  }
}

TEST(Roulette, DoesNotChangeTheMean) {
  const Scene scene(test::room());
  PathSettings settings = with(Strategy::Mis);
  settings.rouletteStrength = 0.0f;
  const Estimate expected = meanOf(scene, PathIntegrator(settings), 24, 128, 100);
  settings.rouletteStart = 0;
  for (const float strength : {0.5f, 1.0f}) {
    settings.rouletteStrength = strength;
    EXPECT_TRUE(agree(meanOf(scene, PathIntegrator(settings), 24, 128, 7), expected)) << strength;
  }
}

// For a light that BSDF sampling finds about as often as light sampling, each technique's weights must account for all
// samples of the other. Irradiance below the centre of a square of half edge 2 at height 1: 4 a atan(a), a = 2 /
// sqrt(5).
TEST(LightSamples, OfAWideLightAreWeightedWithScattering) {
  SceneDescription description = test::floorPoint();
  const Id square = test::addQuad(description, {-2, 1, -2}, {4, 0, 0}, {0, 0, 4}, test::addAbsorber(description));
  description.setEmission(square, {grey(1.0f), false});
  const Scene scene(description);
  const double a = 2.0 / std::sqrt(5.0);
  for (const std::uint32_t count : {1u, 2u, 5u}) {
    PathSettings settings = with(Strategy::Mis);
    settings.lightSamples = count;
    EXPECT_TRUE(agree(meanOf(scene, PathIntegrator(settings), 16, 64), 4.0 * a * std::atan(a) / 3.14159265359))
        << count;
  }
}

TEST(Mixture, EveryWeightAndSetOfTargetsAgrees) {
  SceneDescription description = test::room();
  const Id glass = description.addMaterial("glass", DielectricMaterial{1.5f, false});
  description.shapes[test::addSphere(description, {0.3f, -0.4f, 0.2f}, 0.4f, glass)].name = "ball";
  const Scene scene(description);
  const Estimate expected = meanOf(scene, PathIntegrator(with(Strategy::Mis)), 24, 256, 100);
  const std::vector<std::vector<std::string>> sets{{}, {"lights"}, {"ball"}, {"lights", "ball"}};
  std::uint32_t seed = 0;
  for (const auto& targets : sets) {
    for (const float weight : {0.0f, 0.3f, 0.8f}) {
      PathSettings settings = with(Strategy::Mixture);
      settings.targets = targets;
      settings.targetWeight = weight;
      EXPECT_TRUE(agree(meanOf(scene, PathIntegrator(settings), 24, 128, ++seed), expected)) << seed;
    }
  }
}

// --- Tests of the tests: densities that are 2 % wrong -------------------------------------------------------------

constexpr float kWrong = 1.02f;

struct WrongLightPdf : SceneQueries {
  using SceneQueries::SceneQueries;
  LightSample<float> sampleLight(const LightSet& lights, const ScatterPoint<float>& from,
                                 LightRandom<float> random) const {
    LightSample<float> sample = SceneQueries::sampleLight(lights, from, random);
    sample.weight *= 1.0f / kWrong;
    sample.pdf *= kWrong;
    return sample;
  }
};

struct WrongTargetPdf : SceneQueries {
  using SceneQueries::SceneQueries;
  float targetPdf(const TargetSet& targets, const ScatterPoint<float>& from, Vec3f wi) const {
    return SceneQueries::targetPdf(targets, from, wi) * kWrong;
  }
};

template <class Queries>
class WrongPath final : public RadianceIntegratorWith<PathContext> {
 public:
  explicit WrongPath(const PathSettings& settings) : settings_(settings) {}
  PathContext prepareRadiance(const Scene& scene) const override { return PathContext(scene, settings_); }
  Rgb radiance(const Scene& scene, const PathContext& context, const Ray<float>& ray,
               const Sampler<float>& sampler) const override {
    PathCounts counts;
    Queries queries(scene, counts);
    return tracePath(context.plan(), queries, ray, sampler).radiance;
  }

 private:
  PathSettings settings_;
};

TEST(TestOfTheTest, ADensityTwoPercentTooHighIsRejected) {
  const Scene scene(test::room());
  const Estimate expected = meanOf(scene, PathIntegrator(with(Strategy::Mis)), 24, 400, 100);
  const auto light = WrongPath<WrongLightPdf>(with(Strategy::Light));
  const auto mis = WrongPath<WrongLightPdf>(with(Strategy::Mis));
  const auto mixture = WrongPath<WrongTargetPdf>(with(Strategy::Mixture));
  EXPECT_FALSE(agree(meanOf(scene, light, 24, 400), expected));
  EXPECT_FALSE(agree(meanOf(scene, mis, 24, 400), expected));
  EXPECT_FALSE(agree(meanOf(scene, mixture, 24, 400), expected));
}

}  // namespace
}  // namespace steradian
