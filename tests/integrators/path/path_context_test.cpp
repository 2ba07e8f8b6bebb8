#include "steradian/integrators/path/path_context.h"

#include <gtest/gtest.h>

#include <type_traits>

#include "steradian/tests/integrators/small_scenes.h"

namespace steradian {
namespace {

static_assert(!std::is_copy_constructible_v<PathContext> && !std::is_move_constructible_v<PathContext>);

PathSettings with(Strategy strategy) { return {.strategy = strategy}; }

TEST(PathContext, AreaLightsAreThoseOfTheScene) {
  const Scene scene(test::room());
  for (const Strategy strategy : {Strategy::Bsdf, Strategy::Light, Strategy::Mis, Strategy::Mixture}) {
    const PathContext context(scene, with(strategy));
    EXPECT_EQ(&context.plan().lights->areas(), &scene.lights().areas());
    EXPECT_EQ(&context.plan().diracLights->areas(), &scene.lights().areas());
    EXPECT_EQ(&context.scene(), &scene);
  }
}

TEST(PathContext, StrategiesDifferInTheLightsTheySample) {
  SceneDescription description = test::room();
  description.addLight("sky", ConstantSky{grey(1.0f)});
  const Scene scene(description);
  const auto sampled = [&](const LightSet& lights) {
    int count = 0;
    for (const LightInfo& info : lights.info()) count += info.probability > 0.0f ? 1 : 0;
    return count;
  };
  const auto expect = [&](Strategy strategy, int usual, int dirac) {
    const PathContext context(scene, with(strategy));
    EXPECT_EQ(sampled(*context.plan().lights), usual) << static_cast<int>(strategy);
    EXPECT_EQ(sampled(*context.plan().diracLights), dirac) << static_cast<int>(strategy);
  };
  expect(Strategy::Bsdf, 0, 0);
  expect(Strategy::Light, 2, 0);
  expect(Strategy::Mis, 1, 1);
  expect(Strategy::Mixture, 0, 0);
}

TEST(PathContext, ThePlanDecidesWhatTheSettingsLeaveOpen) {
  SceneDescription description = test::room();
  description.defaults.maxDepth = 7;
  const Scene scene(description);
  EXPECT_EQ(PathContext(scene, {}).plan().maxDepth, 7u);
  EXPECT_EQ(PathContext(scene, {.maxDepth = 3}).plan().maxDepth, 3u);
  EXPECT_EQ(PathContext(scene, {}).plan().targetWeight, 0.0f) << "a room without targets";
  EXPECT_EQ(PathContext(scene, with(Strategy::Mixture)).plan().targetWeight, 0.5f) << "aims at the lights";
  EXPECT_EQ(PathContext(scene, {.targets = {"lights"}}).plan().targetWeight, 0.25f);
  EXPECT_EQ(PathContext(scene, with(Strategy::Bsdf)).plan().targets, nullptr);
  EXPECT_THROW(PathContext(scene, {.targets = {"lihgts"}}), Error);
}

}  // namespace
}  // namespace steradian
