#include "steradian/accel/accel.h"

#include <gtest/gtest.h>

#include "steradian/core/base/diagnostics.h"
#include "steradian/tests/accel/random_scene.h"

namespace steradian::test {
namespace {

SceneDescription withBalls(int count) {
  SceneDescription scene;
  SphereSet balls;
  for (int i = 0; i < count; ++i) balls.add({static_cast<float>(i), 0.0f, 0.0f}, 0.4f);
  scene.addShape("balls", balls, 0);
  return scene;
}

Accel chosen(const SceneDescription& scene) { return planAccel(scene).accel; }

std::string refusal(const SceneDescription& scene, Accel accel) {
  try {
    planAccel(scene, {.accel = accel});
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    return error.diagnostics().front().message;
  }
  return {};
}

TEST(Accel, AutoIsFlatForFewPrimitivesAndBvh8ForMore) {
  EXPECT_EQ(chosen(withBalls(64)), Accel::Flat);
  EXPECT_EQ(chosen(withBalls(65)), Accel::Bvh8);
  EXPECT_EQ(chosen({}), Accel::Bvh8);
  EXPECT_EQ(planAccel(withBalls(5), {.maxClustersWithoutTree = 0}).accel, Accel::Bvh8);
  // What Embree traverses is not counted.
  SceneDescription scene = withBalls(10);
  scene.groups = {{"many", {scene.addShape("many", std::get<SphereSet>(withBalls(100).shapes[0].geometry), 0)}}};
  scene.instances = {{0, {Matrix(), Matrix()}, {}}};
  EXPECT_EQ(chosen(scene), Accel::Flat);
  EXPECT_EQ(planAccel(scene).instances, 2u);
  EXPECT_TRUE(planAccel(scene).needsEmbree());
  EXPECT_EQ(describe(planAccel(scene)), "flat; Embree: 2 instances");
}

TEST(Accel, MeshesAreEmbreesOwnBeyondSomeTriangles) {
  const SceneDescription scene = randomScene(1, 300);
  EXPECT_EQ(planAccel(scene).triangles, 300u);
  EXPECT_EQ(planAccel(scene, {.maxClusteredTriangles = 300}).triangles, 0u);
  EXPECT_EQ(planAccel(scene).customShapes, 2u);
  EXPECT_EQ(describe(planAccel(scene)), "bvh8; Embree: 300 triangles, 2 custom shapes");
  SceneDescription own = scene;
  own.shapes.pop_back();  // the custom ones
  EXPECT_EQ(planAccel(own, {.accel = Accel::Bvh8}).triangles, 0u);
}

TEST(Accel, RefusesByNameWhatASceneCannotHave) {
  EXPECT_EQ(refusal(withBalls(64), Accel::Flat), "");
  EXPECT_EQ(refusal(withBalls(65), Accel::Flat), "accel flat is not for more than 64 primitives: the scene has 65");
  SceneDescription scene = withBalls(3);
  scene.shapes[0].motion = Motion{Matrix(), transformOf({}, {1, 1, 1}, {1, 0, 0})};
  EXPECT_EQ(refusal(scene, Accel::Flat), "accel flat is not for shapes that move by a motion");
  EXPECT_EQ(refusal(scene, Accel::Bvh8), "");
  scene = withBalls(3);
  scene.groups = {{"group", {0}}};
  scene.instances = {{0, {Matrix()}, {}}};
  EXPECT_EQ(refusal(scene, Accel::Flat), "accel flat is not for instances");
  EXPECT_EQ(refusal(scene, Accel::Bvh8), "");
  scene = withBalls(3);
  scene.addShape("slab", CustomShapeSet{{std::make_shared<Slab>(1.0f)}}, 0);
  EXPECT_EQ(refusal(scene, Accel::Flat), "accel flat is not for custom shapes");
  EXPECT_EQ(refusal(scene, Accel::Bvh8), "accel bvh8 is not for custom shapes");
  EXPECT_EQ(refusal(scene, Accel::Embree), "");
}

TEST(Accel, HasNames) {
  EXPECT_EQ(nameOf(Accel::Auto), "auto");
  EXPECT_EQ(nameOf(Accel::Embree), "embree");
  for (const std::string_view name : kAccelNames) EXPECT_EQ(nameOf(accelOf(name)), name);
  EXPECT_THROW(accelOf("bvh"), Error);
}

}  // namespace
}  // namespace steradian::test
