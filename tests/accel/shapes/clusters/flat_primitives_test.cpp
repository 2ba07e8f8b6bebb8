#include "steradian/accel/shapes/clusters/flat_primitives.h"

#include <gtest/gtest.h>

#include "steradian/accel/shapes/clusters/cluster_builder.h"
#include "steradian/accel/shapes/clusters/cluster_set.h"
#include "steradian/tests/accel/shapes/mixed_scene.h"

namespace steradian {
namespace {

using F = Lanes<8>;

using test::allShapes;
using test::mixedScene;
using test::Numbers;

TEST(FlatPrimitives, FindTheHitsOfClusters) {
  const SceneDescription scene = mixedScene();
  const std::vector<Id> shapes = allShapes(scene);
  ASSERT_TRUE(FlatPrimitives::fits(scene, shapes));
  const FlatPrimitives flat(scene, shapes);
  const ClusterSet clusters(buildClusters(scene, shapes).clusters, bestIsa());
  Numbers number;
  int hits = 0;
  for (int round = 0; round < 4000; ++round) {
    Ray<F> rays;
    for (int i = 0; i < 8; ++i) {
      const Vec3f from = number.point(4.0f);
      setLane(rays, i,
              {from, normalize(number.point(2.0f) - from), i % 4 == 0 ? number(1.0f, 6.0f) : kInfinity,
               number(0.0f, 0.99f)});
    }
    Mask<8> active(true);
    active.set(3, round % 2 == 0);
    const auto found = flat.intersect(rays, active);
    const Mask<8> occluded = flat.occluded(rays, active);
    const SurfacePoint<F> points = flat.surfacePoint(rays, found);
    for (int i = 0; i < 8; ++i) {
      LeafHit expected;
      if (active[i]) clusters.intersect(lane(rays, i), kNone, expected);
      ASSERT_EQ(found.valid[i], expected.found());
      ASSERT_EQ(occluded[i], expected.found());
      if (!expected.found()) continue;
      ++hits;
      ASSERT_EQ(found.t[i], expected.t);
      ASSERT_EQ(points.shape[i], expected.shape);
      ASSERT_EQ(points.primitive[i], expected.primitive);
      ASSERT_EQ(points.material[i], scene.shapes[expected.shape].material);
    }
  }
  EXPECT_GT(hits, 5000);
}

TEST(FlatPrimitives, FitWhatIsSmallAndOfLeafKinds) {
  SceneDescription scene;
  TriangleMesh smooth;
  smooth.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  smooth.indices = {0, 1, 2};
  smooth.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  scene.addShape("smooth", smooth, kNone);
  scene.addShape("custom", CustomShapeSet{}, kNone);
  SphereSet ball;
  ball.add({0, 0, 0}, 1.0f);
  scene.addShape("ball", ball, kNone);
  EXPECT_TRUE(FlatPrimitives::fits(scene, std::vector<Id>{0, 2}));
  EXPECT_FALSE(FlatPrimitives::fits(scene, std::vector<Id>{1}));
  EXPECT_FALSE(FlatPrimitives::fits(scene, std::vector<Id>{1, 2}));
  EXPECT_TRUE(FlatPrimitives::fits(scene, std::vector<Id>{2}));
  EXPECT_FALSE(FlatPrimitives::fits(scene, {}));
  SphereSet many;
  for (int i = 0; i <= 64; ++i) many.add({0, 0, 0}, 1.0f);
  scene.addShape("many", many, kNone);
  EXPECT_FALSE(FlatPrimitives::fits(scene, std::vector<Id>{3}));
}

TEST(FlatPrimitives, MaterialsOfPrimitives) {
  SceneDescription scene;
  SphereSet balls;
  balls.add({-2.0f, 0.0f, 0.0f}, 1.0f);
  balls.add({2.0f, 0.0f, 0.0f}, 1.0f);
  scene.shapes[scene.addShape("balls", balls, 7)].primitiveMaterials = {3, 4};
  const FlatPrimitives flat(scene, std::vector<Id>{0});
  Ray<F> rays{{F(-2.0f), F(0.0f), F(5.0f)}, {F(0.0f), F(0.0f), F(-1.0f)}};
  rays.origin.x.set(5, 2.0f);
  const SurfacePoint<F> points = flat.surfacePoint(rays, flat.intersect(rays, Mask<8>(true)));
  EXPECT_EQ(points.material[0], 3u);
  EXPECT_EQ(points.material[5], 4u);
}

}  // namespace
}  // namespace steradian
