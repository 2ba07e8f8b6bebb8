#include "steradian/integrators/volumes/volumes.h"

#include <gtest/gtest.h>

#include "steradian/integrators/scene/scene.h"
#include "steradian/tests/integrators/small_scenes.h"

namespace steradian {
namespace {

const Vec3f kIn{0.0f, 0.0f, -1.0f}, kOut{0.0f, 0.0f, 1.0f};

/// A point on the side +z of a body.
SurfacePoint<float> on(Id shape, Id material, std::uint32_t primitive = 0) {
  SurfacePoint<float> at;
  at.valid = true;
  at.geometricNormal = kOut;
  at.shape = shape;
  at.primitive = primitive;
  at.material = material;
  return at;
}

/// Glass of priority 2, liquid of priority 1 and a fog without any: shapes, materials and media of the same number.
SceneDescription threeBodies() {
  SceneDescription scene;
  for (const char* name : {"glass", "liquid", "fog"}) scene.addMedium({.name = name, .absorption = grey(1.0f)});
  test::addSphere(scene, {}, 1.0f, scene.addMaterial("glass", DielectricMaterial{.eta = 1.5f}));
  test::addSphere(scene, {}, 1.0f, scene.addMaterial("liquid", DielectricMaterial{.eta = 1.3f}));
  test::addSphere(scene, {}, 1.0f, scene.addMaterial("fog", InterfaceMaterial{}));
  scene.shapes[0].interior = Interior{0, 2};
  scene.shapes[1].interior = Interior{1, 1};
  scene.shapes[2].interior = Interior{2, 0};
  return scene;
}

TEST(Volumes, TheHighestPriorityCountsThenTheInnermost) {
  const Volumes volumes(threeBodies());
  Bodies bodies;
  constexpr std::uint32_t glass = 0, liquid = 1, fog = 2, vacuum = 3;
  EXPECT_EQ(volumes.mediumIn(bodies), vacuum);
  volumes.cross(on(0, 0), kIn, bodies);
  EXPECT_EQ(volumes.mediumIn(bodies), glass);
  volumes.cross(on(2, 2), kIn, bodies);
  EXPECT_EQ(volumes.mediumIn(bodies), glass);
  volumes.cross(on(1, 1), kIn, bodies);
  EXPECT_EQ(volumes.mediumIn(bodies), glass);
  volumes.cross(on(0, 0), kOut, bodies);
  EXPECT_EQ(volumes.mediumIn(bodies), liquid);
  volumes.cross(on(1, 1), kOut, bodies);
  EXPECT_EQ(volumes.mediumIn(bodies), fog);
  volumes.cross(on(2, 2), kOut, bodies);
  EXPECT_EQ(volumes.mediumIn(bodies), vacuum);
  EXPECT_TRUE(bodies.empty());
}

TEST(Volumes, SurfacesInsideOfHigherPrioritiesAreNotThere) {
  const Volumes volumes(threeBodies());
  Bodies bodies;
  EXPECT_TRUE(volumes.boundary(on(1, 1), kIn, bodies).isReal);
  EXPECT_FALSE(volumes.boundary(on(2, 2), kIn, bodies).isReal) << "an interface";
  volumes.cross(on(0, 0), kIn, bodies);
  EXPECT_FALSE(volumes.boundary(on(1, 1), kIn, bodies).isReal);
  volumes.cross(on(1, 1), kIn, bodies);
  const Boundary toLiquid = volumes.boundary(on(0, 0), kOut, bodies);
  EXPECT_TRUE(toLiquid.isReal);
  EXPECT_EQ(toLiquid.outsideEta, 1.3f);
  EXPECT_FALSE(volumes.boundary(on(1, 1), kOut, bodies).isReal);
  volumes.cross(on(0, 0), kOut, bodies);
  const Boundary toGlass = volumes.boundary(on(0, 0), kIn, bodies);
  EXPECT_TRUE(toGlass.isReal);
  EXPECT_EQ(toGlass.outsideEta, 1.3f);
  const Boundary toAir = volumes.boundary(on(1, 1), kOut, bodies);
  EXPECT_TRUE(toAir.isReal);
  EXPECT_EQ(toAir.outsideEta, 1.0f);
}

TEST(Volumes, BodiesOfOneSetAreApart) {
  const Volumes volumes(threeBodies());
  Bodies bodies;
  volumes.cross(on(2, 2, 0), kIn, bodies);
  volumes.cross(on(2, 2, 1), kIn, bodies);
  volumes.cross(on(2, 2, 0), kOut, bodies);
  EXPECT_EQ(volumes.mediumIn(bodies), 2u);
  volumes.cross(on(2, 2, 1), kOut, bodies);
  EXPECT_EQ(volumes.mediumIn(bodies), volumes.media().none());
}

TEST(Volumes, MoreBodiesThanCanBeToldApartAreLeftOut) {
  const Volumes volumes(threeBodies());
  Bodies bodies;
  for (std::uint32_t i = 0; i < Bodies::kMost + 3; ++i) volumes.cross(on(2, 2, i), kIn, bodies);
  for (std::uint32_t i = Bodies::kMost + 3; i-- > 0;) volumes.cross(on(2, 2, i), kOut, bodies);
  EXPECT_TRUE(bodies.empty());
}

TEST(Volumes, ScenesWithoutThemAreKnown) {
  EXPECT_TRUE(Volumes(test::room()).empty());
  EXPECT_FALSE(Volumes(threeBodies()).empty());
  SceneDescription fog = test::room();
  fog.outside = fog.addMedium({.name = "fog", .scattering = grey(0.1f)});
  const Volumes volumes(fog);
  EXPECT_FALSE(volumes.empty());
  EXPECT_FALSE(volumes.passable());
  EXPECT_EQ(volumes.mediumIn({}), 0u);
}

TEST(Scene, KnowsWhatTheCameraIsIn) {
  SceneDescription scene;
  const Id air = scene.addMaterial("air", InterfaceMaterial{});
  for (const float radius : {3.0f, 1.0f, 2.0f}) {
    const Id medium = scene.addMedium({.name = "m", .absorption = grey(radius)});
    scene.shapes[test::addSphere(scene, {0, 0, 0}, radius, air)].interior = Interior{medium};
  }
  scene.shapes[test::addSphere(scene, {20, 0, 0}, 1.0f, air)].interior = Interior{0};
  scene.camera = PerspectiveCamera{.lookFrom = {0.1f, 0.2f, 0.3f}};
  const auto absorptionIn = [](const Scene& s, const Bodies& bodies) {
    return s.volumes().media().at<float>(s.volumes().mediumIn(bodies)).extinction.r;
  };
  const auto absorptionAt = [&](const Scene& s, Vec3f position) { return absorptionIn(s, s.bodiesAt(position, 0.0f)); };
  const Scene built(scene);
  EXPECT_EQ(absorptionAt(built, {0.5f, 0.0f, 0.0f}), 1.0f);
  EXPECT_EQ(absorptionAt(built, {0.0f, 1.5f, 0.0f}), 2.0f);
  EXPECT_EQ(absorptionAt(built, {0.0f, 0.0f, -2.5f}), 3.0f);
  EXPECT_EQ(absorptionAt(built, {9.0f, 0.0f, 0.0f}), 0.0f);
  EXPECT_EQ(absorptionAt(built, {20.0f, 0.5f, 0.0f}), 3.0f);
  EXPECT_EQ(absorptionIn(built, built.bodiesAtStart({})), 1.0f);
}

}  // namespace
}  // namespace steradian
