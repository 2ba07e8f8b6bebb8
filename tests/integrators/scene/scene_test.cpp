#include "steradian/integrators/scene/scene.h"

#include <gtest/gtest.h>

#include "steradian/integrators/scene/scene_hash.h"
#include "steradian/tests/integrators/small_scenes.h"

namespace steradian {
namespace {

TEST(Scene, RefusesABadDescriptionWithEverythingThatIsWrong) {
  SceneDescription bad = test::room();
  bad.shapes[0].material = 77;
  std::get<QuadSet>(bad.shapes[1].geometry).uX[0] = kInfinity;
  try {
    const Scene scene(bad);
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Scene);
    EXPECT_GE(error.diagnostics().size(), 2u);
  }
}

TEST(Scene, CanBeEmpty) {
  const Scene scene{SceneDescription{}};
  EXPECT_FALSE(scene.geometry().intersect({{0, 0, 0}, {0, 0, 1}}).valid);
  EXPECT_TRUE(scene.lights().empty());
}

TEST(SceneHash, DependsOnWhatIsSeen) {
  const std::uint64_t hash = sceneHash(test::room());
  EXPECT_EQ(sceneHash(test::room()), hash);
  const auto changed = [&](auto change) {
    SceneDescription scene = test::room();
    change(scene);
    return sceneHash(scene) != hash;
  };
  EXPECT_TRUE(changed([](auto& s) { std::get<QuadSet>(s.shapes[2].geometry).vY[0] += 1e-6f; }));
  EXPECT_TRUE(changed([](auto& s) { s.emissions[0].twoSided = true; }));
  EXPECT_TRUE(changed([](auto& s) { std::get<PerspectiveCamera>(s.camera).focusDistance = 2.0f; }));
  EXPECT_TRUE(changed([](auto& s) { s.addLight("sky", ConstantSky{}); }));
  EXPECT_TRUE(changed([](auto& s) { std::swap(s.shapes[0], s.shapes[1]); }));
  EXPECT_TRUE(changed([](auto& s) { s.shapes[3].target = true; }));
  EXPECT_FALSE(changed([](auto& s) { s.name = "another"; }));
  EXPECT_FALSE(changed([](auto& s) { s.shapes[0].name = "floor"; }));
  EXPECT_FALSE(changed([](auto& s) { s.defaults.width = 3; }));
}

TEST(SceneHash, IsTheSameOnEveryMachine) {
  EXPECT_EQ(sceneHashText(sceneHash(SceneDescription{})), "3b6700861137a058");
  EXPECT_EQ(sceneHashText(0x2au), "000000000000002a");
}

}  // namespace
}  // namespace steradian
