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
SceneDescription threeInteriors() {
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
  const Volumes volumes(threeInteriors());
  InteriorStack interior;
  constexpr std::uint32_t glass = 0, liquid = 1, fog = 2, vacuum = 3;
  EXPECT_EQ(volumes.mediumIn(interior), vacuum);
  volumes.cross(on(0, 0), kIn, interior);
  EXPECT_EQ(volumes.mediumIn(interior), glass);
  volumes.cross(on(2, 2), kIn, interior);
  EXPECT_EQ(volumes.mediumIn(interior), glass);
  volumes.cross(on(1, 1), kIn, interior);
  EXPECT_EQ(volumes.mediumIn(interior), glass);
  volumes.cross(on(0, 0), kOut, interior);
  EXPECT_EQ(volumes.mediumIn(interior), liquid);
  volumes.cross(on(1, 1), kOut, interior);
  EXPECT_EQ(volumes.mediumIn(interior), fog);
  volumes.cross(on(2, 2), kOut, interior);
  EXPECT_EQ(volumes.mediumIn(interior), vacuum);
  EXPECT_TRUE(interior.empty());
}

TEST(Volumes, SurfacesInsideOfHigherPrioritiesAreNotThere) {
  const Volumes volumes(threeInteriors());
  InteriorStack interior;
  EXPECT_TRUE(volumes.boundary(on(1, 1), kIn, interior).isReal);
  EXPECT_FALSE(volumes.boundary(on(2, 2), kIn, interior).isReal) << "an interface";
  volumes.cross(on(0, 0), kIn, interior);
  EXPECT_FALSE(volumes.boundary(on(1, 1), kIn, interior).isReal);
  volumes.cross(on(1, 1), kIn, interior);
  const Boundary toLiquid = volumes.boundary(on(0, 0), kOut, interior);
  EXPECT_TRUE(toLiquid.isReal);
  EXPECT_EQ(toLiquid.outsideEta, 1.3f);
  EXPECT_FALSE(volumes.boundary(on(1, 1), kOut, interior).isReal);
  volumes.cross(on(0, 0), kOut, interior);
  const Boundary toGlass = volumes.boundary(on(0, 0), kIn, interior);
  EXPECT_TRUE(toGlass.isReal);
  EXPECT_EQ(toGlass.outsideEta, 1.3f);
  const Boundary toAir = volumes.boundary(on(1, 1), kOut, interior);
  EXPECT_TRUE(toAir.isReal);
  EXPECT_EQ(toAir.outsideEta, 1.0f);
}

TEST(Volumes, BodiesOfOneSetAreApart) {
  const Volumes volumes(threeInteriors());
  InteriorStack interior;
  volumes.cross(on(2, 2, 0), kIn, interior);
  volumes.cross(on(2, 2, 1), kIn, interior);
  volumes.cross(on(2, 2, 0), kOut, interior);
  EXPECT_EQ(volumes.mediumIn(interior), 2u);
  volumes.cross(on(2, 2, 1), kOut, interior);
  EXPECT_EQ(volumes.mediumIn(interior), volumes.media().none());
}

TEST(Volumes, MoreBodiesThanCanBeToldApartAreLeftOut) {
  const Volumes volumes(threeInteriors());
  InteriorStack interior;
  for (std::uint32_t i = 0; i < InteriorStack::kMaxSize + 3; ++i) volumes.cross(on(2, 2, i), kIn, interior);
  for (std::uint32_t i = InteriorStack::kMaxSize + 3; i-- > 0;) volumes.cross(on(2, 2, i), kOut, interior);
  EXPECT_TRUE(interior.empty());
}

TEST(Volumes, ScenesWithoutThemAreKnown) {
  EXPECT_TRUE(Volumes(test::room()).empty());
  EXPECT_FALSE(Volumes(threeInteriors()).empty());
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
  const auto absorptionIn = [](const Scene& s, const InteriorStack& interior) {
    return s.volumes().media().at<float>(s.volumes().mediumIn(interior)).extinction.r;
  };
  const auto absorptionAt = [&](const Scene& s, Vec3f position) {
    return absorptionIn(s, s.interiorAt(position, 0.0f));
  };
  const Scene built(scene);
  EXPECT_EQ(absorptionAt(built, {0.5f, 0.0f, 0.0f}), 1.0f);
  EXPECT_EQ(absorptionAt(built, {0.0f, 1.5f, 0.0f}), 2.0f);
  EXPECT_EQ(absorptionAt(built, {0.0f, 0.0f, -2.5f}), 3.0f);
  EXPECT_EQ(absorptionAt(built, {9.0f, 0.0f, 0.0f}), 0.0f);
  EXPECT_EQ(absorptionAt(built, {20.0f, 0.5f, 0.0f}), 3.0f);
  EXPECT_EQ(absorptionIn(built, built.interiorAtStart({})), 1.0f);
}

}  // namespace
}  // namespace steradian
