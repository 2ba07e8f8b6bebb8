#include <gtest/gtest.h>

#include <cmath>

#include "steradian/lights/target_set.h"
#include "steradian/tests/lights/light_scenes.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using namespace steradian::test;

/// Irradiance at a point that faces up, by light samples alone; their weights may be falsified.
RunningMean irradiance(const LightSet& lights, const ScatterPoint<float>& from, std::uint32_t samples,
                       double factor = 1.0) {
  RunningMean mean;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const LightSample<float> s = lights.sample(from, lightRandom(i));
    mean.add(s.pdf > 0.0f ? factor * static_cast<double>(s.weight.g * maximum(s.wi.y, 0.0f)) : 0.0);
  }
  return mean;
}

double pValue(const RunningMean& mean, double expected) {
  return zTestPValue(mean.mean(), mean.standardError(), expected, 2e-6 * expected);
}

double irradianceTest(const SceneDescription& scene, double expected, double factor = 1.0) {
  const LightSet lights(scene, kBounds, {.sampleSkies = true});
  return pValue(irradiance(lights, pointAt({0, 0, 0}), 100000, factor), expected);
}

struct Emitter {
  ShapeGeometry geometry;
  double irradiance;  ///< at the origin, of radiance 1
};
/// Closed forms: pi R^2 / d^2; pi R^2 / (R^2 + h^2); the view factor of a parallel square from below its centre.
std::vector<Emitter> closedForms() {
  TriangleMesh halves;
  halves.positions = {{-0.5f, 1, -0.5f}, {0.5f, 1, -0.5f}, {0.5f, 1, 0.5f}, {-0.5f, 1, 0.5f}};
  halves.indices = {0, 1, 2, 0, 2, 3};
  QuadSet quarters;
  for (const Vec3f corner : {Vec3f{-0.5f, 1, -0.5f}, {0, 1, -0.5f}, {-0.5f, 1, 0}, {0, 1, 0}}) {
    quarters.add(corner, {0.5f, 0, 0}, {0, 0, 0.5f});
  }
  const double a = 0.5 / std::sqrt(1.25), squareOfOne = 4.0 * a * std::atan(a);
  return {{sphere({0, 2, 0}, 0.5f), 0.196350},
          {disk({0, 2, 0}, {0, -1, 0}, 0.5f), 0.184800},
          {ceilingSquare(1.0f, 1.0f), 0.752275},
          {halves, squareOfOne},
          {quarters, squareOfOne}};
}

TEST(LightsStat, IrradianceOfClosedForms) {
  for (const Emitter& emitter : closedForms()) {
    SceneDescription scene;
    addEmitter(scene, emitter.geometry, grey(1.0f));
    EXPECT_GT(irradianceTest(scene, emitter.irradiance), suiteLevel()) << emitter.irradiance;
    EXPECT_LT(irradianceTest(scene, emitter.irradiance, 1.02), suiteLevel()) << "2 % too much is found";
  }
}

// The same from an instance that is stretched: a square of 2 x 0.5 at height 1 made of the unit square has no closed
// form, but one that is stretched and shrunk back has.
TEST(LightsStat, IrradianceOfInstances) {
  SceneDescription scene;
  const Id shape = addEmitter(scene, disk({0, 1, 0}, {0, -1, 0}, 1.0f), grey(1.0f));
  scene.groups.push_back({"lamp", {shape}});
  Matrix squeezed;
  squeezed.scale(toImath({0.5f, 2.0f, 0.5f}));  // radius 0.5 at height 2
  Matrix mirrored;
  mirrored.scale(toImath({-0.5f, 2.0f, 0.5f}));
  scene.instances.push_back({0, {squeezed}, {}});
  EXPECT_GT(irradianceTest(scene, 0.184800), suiteLevel());
  scene.instances.push_back({0, {mirrored}, {}});
  EXPECT_GT(irradianceTest(scene, 2.0 * 0.184800), suiteLevel());
}

// Lights of all kinds, each selected by its power: their irradiances add up.
TEST(LightsStat, IrradianceOfManyLightsAddsUp) {
  SceneDescription scene;
  double expected = 0.0;
  for (const Emitter& emitter : closedForms()) {
    const float radiance = 1.0f + static_cast<float>(expected);
    addEmitter(scene, emitter.geometry, grey(radiance));
    expected += static_cast<double>(radiance) * emitter.irradiance;
  }
  for (int i = 0; i < 300; ++i) {
    const float x = 0.02f * static_cast<float>(i - 150), power = 0.001f * static_cast<float>(i);
    scene.lights.push_back({"", PointLight{{x, 1, 0}, grey(power)}, {}});
    expected += static_cast<double>(power) / std::pow(1.0 + static_cast<double>(x * x), 1.5);
  }
  scene.lights.push_back({"", SpotLight{{0, 2, 0}, {0, -1, 0}, grey(4.0f), 20.0f, 30.0f}, {}});
  expected += 1.0;
  scene.lights.push_back({"", DistantLight{{1, -1, 0}, grey(2.0f)}, {}});
  expected += std::sqrt(2.0);
  scene.lights.push_back({"", ConstantSky{grey(0.5f)}, {}});
  expected += 0.5 * M_PI;
  EXPECT_GT(irradianceTest(scene, expected), suiteLevel());
}

// The furnace: a sky of radiance 1 gives pi; a gradient gives pi nadir + (zenith - nadir) 5 pi / 6, since the mean of
// (1 + y) / 2 with weight y over the hemisphere is 5/6.
TEST(LightsStat, IrradianceOfSkies) {
  SceneDescription constant;
  constant.lights.push_back({"", ConstantSky{grey(1.0f)}, {}});
  EXPECT_GT(irradianceTest(constant, M_PI), suiteLevel());
  SceneDescription gradient;
  gradient.lights.push_back({"", GradientSky{grey(1.0f), grey(0.5f)}, {}});
  EXPECT_GT(irradianceTest(gradient, M_PI * (1.0 - 0.5 * 5.0 / 6.0)), suiteLevel());
}

TEST(LightsStat, SkySampling) {
  for (const Vec3f normal : {Vec3f{0, 1, 0}, normalize(Vec3f{1, -2, 3}), Vec3f{0, 0, 0}}) {
    CheckOptions options;
    if (lengthSquared(normal) > 0.0f) options.grid.axis = normal;
    EXPECT_TRUE(checkDirectionSampler([&](float, Vec2f u) { return sampleSky(normal, u); },
                                      [&](Vec3f wi) { return static_cast<double>(skyPdf(normal, wi)); }, options));
  }
}

// A light by samples of its own and by uniform directions that happen to hit it, weighted with both densities.
RunningMean combined(const Quad<float>& emitter, std::uint32_t samples, float falsified) {
  SceneDescription scene;
  const Id shape = addEmitter(scene, quad(emitter.corner, emitter.u, emitter.v), grey(1.0f));
  addEmitter(scene, sphere({5, 5, 5}, 0.3f), grey(2.0f));  // takes its share of the selection
  const LightSet lights(scene, kBounds);
  const ScatterPoint<float> from = pointAt({0, 0, 0});
  RunningMean mean;
  for (std::uint32_t i = 0; i < samples; ++i) {
    double sum = 0.0;
    const LightSample<float> s = lights.sample(from, lightRandom(i));
    if (s.pdf > 0.0f && s.wi.x + s.wi.z < 1.0f) {  // not the other light
      sum += static_cast<double>(s.weight.g * s.wi.y * misWeight(s.pdf, kInvFourPi));
    }
    const Vec3f wi = UniformSphere<float>::sample(lightRandom(i + samples).position);
    const ShapeHit<float> found = intersect(emitter, Ray<float>{from.position, wi});
    if (found.valid) {
      SurfacePoint<float> hit;
      hit.valid = true;
      hit.shape = shape, hit.primitive = 0;
      hit.geometricNormal = {0, -1, 0};
      const Emission<float> e = lights.emission(from, {from.position, wi}, hit);
      const float pdf = e.pdf * falsified;
      sum += static_cast<double>(e.radiance.g * wi.y * kFourPi * misWeight(kInvFourPi, pdf));
    }
    mean.add(sum);
  }
  return mean;
}

TEST(LightsStat, MultipleImportanceSamplingAddsUp) {
  const Quad<float> emitter{{-0.5f, 1, -0.5f}, {1, 0, 0}, {0, 0, 1}};
  EXPECT_GT(pValue(combined(emitter, 400000, 1.0f), 0.752275), suiteLevel());
  EXPECT_LT(pValue(combined(emitter, 400000, 1.3f), 0.752275), suiteLevel()) << "a wrong density is found";
}

TEST(LightsStat, SelectionByWeight) {
  for (const std::size_t size : {7u, 256u, 257u, 1000u}) {
    std::vector<float> weights;
    double total = 0.0;
    for (std::size_t i = 0; i < size; ++i)
      weights.push_back(static_cast<float>(i % 5) * lightRandom(static_cast<std::uint32_t>(i)).select);
    for (const float w : weights) total += static_cast<double>(w);
    const LightSelection selection(weights);
    constexpr std::uint32_t samples = 200000;
    std::vector<double> observed(size, 0.0), expected;
    double sum = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
      expected.push_back(static_cast<double>(weights[i]) / total * samples);
      EXPECT_NEAR(static_cast<double>(selection.probability(i)), static_cast<double>(weights[i]) / total, 1e-6);
      sum += static_cast<double>(selection.probability(i));
    }
    EXPECT_NEAR(sum, 1.0, 1e-6);
    for (std::uint32_t i = 0; i < samples; ++i) {
      const auto choice = selection.choose(lightRandom(i).select);
      ASSERT_EQ(choice.probability, selection.probability(choice.index));
      observed[choice.index] += 1.0;
    }
    EXPECT_GT(chiSquareTest(observed, expected).pValue, suiteLevel()) << size;
  }
}

// Targets that overlap, one behind the other, seen from inside: the density of a set is the sum over all of them.
TEST(LightsStat, TargetsOverlappingAndOccluded) {
  SceneDescription scene;
  addEmitter(scene, ceilingSquare(2.0f, 2.0f), grey(3.0f), false, "lamp");
  scene.addShape("glass", sphere({0.2f, 1.2f, 0.0f}, 0.4f), kNone);  // before the lamp
  scene.addShape("window", ceilingSquare(1.0f, 2.0f), kNone);        // in its plane
  scene.addShape("box", box({0.5f, 1.0f, 0.5f}, {0.3f, 0.2f, 0.3f}, 20.0f), kNone);
  scene.addShape("shell", sphere({0, 0, 0}, 4.0f), kNone);  // around everything
  // The shell has every direction in its support: quadrature may miss a corner of a square, but no cell is empty.
  const std::vector<std::vector<std::string>> sets{{"shell", "lights"},
                                                   {"shell", "lights", "glass"},
                                                   {"shell", "lights", "window"},
                                                   {"shell", "lights", "glass", "window", "box"}};
  for (const auto& names : sets) {
    const TargetSet targets(scene, names);
    const ScatterPoint<float> from = pointAt({0.1f, 0.0f, -0.1f});
    CheckOptions options;
    options.grid.axis = {0, 1, 0};
    options.grid.focus = 1.0;
    options.grid.rings = 16;
    options.grid.sectors = 24;
    options.quadratureTolerance = 1e-6;
    options.edgeShare = 1e-3;
    options.samples = 100000;
    EXPECT_TRUE(checkDirectionSampler(
        [&](float choice, Vec2f u) {
          return targets.sampleDirection(from, {choice, u});
        },
        [&](Vec3f wi) { return static_cast<double>(targets.pdfDirection(from, wi)); }, options))
        << names.size();
  }
}

}  // namespace
}  // namespace steradian
