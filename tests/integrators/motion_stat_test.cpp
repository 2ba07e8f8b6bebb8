/// Motion blur is the mean of still pictures, and every strategy finds the light of moving emitters.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "steradian/core/samplers/rng.h"
#include "steradian/tests/integrators/moving_scenes.h"
#include "steradian/tests/integrators/small_scenes.h"
#include "steradian/tests/integrators/strategies.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using test::Estimate;
using test::meanOf;
using test::RunningMean;
using test::with;

constexpr int kSize = 16, kBlock = 4, kAcross = kSize / kBlock;
using Blocks = std::vector<RunningMean>;

/// Mean luminances of the blocks of one picture, one more value for each.
void addPicture(const Film& film, std::vector<double>& sums, double weight) {
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const int block = y / kBlock * kAcross + x / kBlock;
      sums[static_cast<std::size_t>(block)] +=
          weight * static_cast<double>(luminance(film.radiance(x, y))) / (kBlock * kBlock);
    }
  }
}

using MakeScene = std::function<SceneDescription(float time)>;

/// `runs` independent means of `frames` pictures each, at times that are spread over the shutter interval. A scene that
/// moves by itself is one frame.
Blocks pictures(const MakeScene& scene, int runs, int frames, std::uint32_t samplesPerPixel, std::uint32_t seed) {
  Blocks blocks(kAcross * kAcross);
  const PathIntegrator integrator(with(Strategy::Mis));
  for (int run = 0; run < runs; ++run) {
    std::vector<double> sums(blocks.size(), 0.0);
    for (int frame = 0; frame < frames; ++frame) {
      const auto number = static_cast<std::uint32_t>(run * frames + frame);
      const float u = toUnitFloat<float>(randomWords<std::uint32_t>(number, seed, 0u, 0u)[0]);
      const Scene still(scene((static_cast<float>(frame) + u) / static_cast<float>(frames)));
      const RenderSettings settings = test::settingsOf(kSize, kSize, samplesPerPixel, seed + number);
      addPicture(render(still, integrator, settings).film, sums, 1.0 / frames);
    }
    for (std::size_t i = 0; i < blocks.size(); ++i) blocks[i].add(sums[i]);
  }
  return blocks;
}

constexpr int kRuns = 32;

Blocks blurred(const SceneDescription& scene) {
  return pictures([&](float) { return scene; }, kRuns, 1, 64, 1);
}
Blocks averaged(
    const SceneDescription& scene, const std::function<float(float)>& timeOf = [](float t) { return t; }) {
  return pictures([&](float time) { return test::frozen(scene, timeOf(time)); }, kRuns, 8, 8, 1000);
}

/// The smallest p-value of all blocks.
double smallestP(const Blocks& a, const Blocks& b) {
  double smallest = 1.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double error = std::hypot(a[i].standardError(), b[i].standardError());
    const double difference = std::max(std::abs(a[i].mean() - b[i].mean()) - 1e-5 * b[i].mean(), 0.0);
    smallest = std::min(smallest, difference > 0.0 ? test::studentPValue(difference / error, kRuns - 1) : 1.0);
  }
  return smallest;
}

double level() { return test::sidakLevel(test::suiteLevel(), kAcross * kAcross); }

TEST(MotionBlur, IsTheMeanOfStillPictures) {
  const struct {
    const char* name;
    SceneDescription scene;
  } cases[]{{"sphere", test::flyingSphere()},
            {"box", test::tumblingBox()},
            {"instances", test::tumblingInstances()},
            {"lights", test::movingLights()}};
  for (const auto& c : cases) EXPECT_GT(smallestP(blurred(c.scene), averaged(c.scene)), level()) << c.name;
}

// Of the tests: pictures that miss the last tenth of the motion have another mean.
TEST(MotionBlur, AMotionThatEndsTooSoonIsFound) {
  const SceneDescription scene = test::everythingMoves();
  const auto early = [](float time) { return 0.9f * time; };
  EXPECT_LT(smallestP(blurred(scene), averaged(scene, early)), level());
}

// A ball of radius r that flies from (-1, h, 0) to (1, h, 0) above a white floor: radiance r^2 h / d^3 at each time, of
// which the mean is r^2 / (h sqrt(h^2 + 1)).
TEST(MotionBlur, OfALightIsItsMeanIrradiance) {
  SceneDescription byItself = test::floorPoint(), bySet = test::floorPoint(), byInstance = test::floorPoint();
  SphereSet comet;
  comet.addMoving({-1.0f, 2.0f, 0.0f}, {1.0f, 2.0f, 0.0f}, 0.5f);
  byItself.setEmission(byItself.addShape("comet", comet, test::addAbsorber(byItself)), {grey(1.0f), false});
  const Matrix open = test::placed({-1.0f, 0.0f, 0.0f}), close = test::placed({1.0f, 0.0f, 0.0f});
  for (SceneDescription* scene : {&bySet, &byInstance}) {
    const Id ball = test::addSphere(*scene, {0.0f, 2.0f, 0.0f}, 0.5f, test::addAbsorber(*scene));
    scene->setEmission(ball, {grey(1.0f), false});
    if (scene == &bySet) {
      scene->shapes[ball].motion = Motion{open, close};
    } else {
      scene->groups.push_back({"ball", {ball}});
      scene->instances.push_back({0, {open}, {close}, {}});
    }
  }
  for (const SceneDescription* description : {&byItself, &bySet, &byInstance}) {
    test::expectRadiance(*description, 0.25 / (2.0 * std::sqrt(5.0)));
  }
}

TEST(MotionBlur, StrategiesAgree) {
  for (SceneDescription description : {test::movingLights(), test::everythingMoves()}) {
    // The sampling targets move too.
    for (ShapeDescription& shape : description.shapes) {
      shape.target = shape.emission != kNone || shape.name == "tumbling" || shape.name == "rolling";
    }
    test::expectStrategiesAgree(description, 128);
  }
}

}  // namespace
}  // namespace steradian
