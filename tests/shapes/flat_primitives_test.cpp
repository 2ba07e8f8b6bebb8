#include "steradian/accel/shapes/flat_primitives.h"

#include <gtest/gtest.h>

#include <random>

#include "steradian/accel/shapes/cluster_set.h"

namespace steradian {
namespace {

using F = Lanes<8>;

class Numbers {
 public:
  float operator()(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  Vec3f point(float reach) {
    const float x = (*this)(-reach, reach), y = (*this)(-reach, reach);
    return {x, y, (*this)(-reach, reach)};
  }

 private:
  std::mt19937 engine_{7};
};

/// Some of every kind, one behind the other and in two shapes each; the last quads are copies of the first.
SceneDescription mixedScene() {
  Numbers number;
  SceneDescription scene;
  for (int round = 0; round < 2; ++round) {
    QuadSet quads, walls;
    SphereSet spheres, rising;
    BoxSet upright, turned;
    DiskSet disks;
    TriangleMesh mesh;
    for (int i = 0; i < 3; ++i) {
      quads.add(number.point(2.0f), number.point(1.0f), number.point(1.0f));
      const Vec3f edges = number.point(2.0f);
      walls.add(number.point(2.0f), {0.0f, edges.x, 0.0f}, {i == 0 ? edges.y : 0.0f, 0.0f, i == 0 ? 0.0f : edges.z});
      spheres.add(number.point(2.0f), number(0.2f, 0.8f));
      const Vec3f start = number.point(2.0f);
      rising.addMoving(start, start + number.point(1.0f), 0.5f);
      upright.addRotatedY(number.point(2.0f), {0.3f, 0.5f, 0.2f}, number(0.0f, 90.0f));
      turned.addRotatedY(number.point(2.0f), {0.4f, 0.2f, 0.3f}, 30.0f);
      turned.rotationX.back() = 0.3f;
      disks.add(number.point(2.0f), normalize(number.point(1.0f)), 0.7f);
      for (int k = 0; k < 3; ++k) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(number.point(2.0f));
      }
    }
    scene.addShape("quads", quads, static_cast<Id>(round));
    scene.addShape("walls", walls, 6);
    if (round == 1) {
      // Not aligned as a whole, but one of them by itself.
      quads.add({0.5f, 0.0f, -1.0f}, {0.0f, 0.0f, 2.0f}, {0.0f, 1.0f, 0.0f});
      scene.addShape("one wall", quads, 7);
    }
    scene.addShape("spheres", spheres, 1);
    scene.addShape("rising", rising, 8);
    scene.addShape("upright", upright, 2);
    scene.addShape("turned", turned, 3);
    scene.addShape("disks", disks, 4);
    scene.addShape("mesh", mesh, 5);
    if (round == 1) scene.shapes.push_back(scene.shapes.front());
  }
  return scene;
}

std::vector<Id> allShapes(const SceneDescription& scene) {
  std::vector<Id> ids;
  for (Id i = 0; i < scene.shapes.size(); ++i) ids.push_back(i);
  return ids;
}

TEST(FlatPrimitives, FindTheHitsOfClusters) {
  const SceneDescription scene = mixedScene();
  const std::vector<Id> shapes = allShapes(scene);
  ASSERT_TRUE(FlatPrimitives::holds(scene, shapes));
  const FlatPrimitives flat(scene, shapes);
  const ClusterSet clusters(scene, shapes);
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
    const auto found = flat.nearest(rays, active);
    const Mask<8> any = flat.any(rays, active);
    const SurfacePoint<F> points = flat.surfacePoint(rays, found);
    for (int i = 0; i < 8; ++i) {
      LeafHit expected;
      if (active[i]) clusters.nearest(lane(rays, i), kNone, expected);
      ASSERT_EQ(found.valid[i], expected.found());
      ASSERT_EQ(any[i], expected.found());
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

TEST(FlatPrimitives, LeaveOutWhatTheyDoNotKnow) {
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
  EXPECT_FALSE(FlatPrimitives::holds(scene, std::vector<Id>{0, 2}));
  EXPECT_FALSE(FlatPrimitives::holds(scene, std::vector<Id>{1}));
  EXPECT_TRUE(FlatPrimitives::holds(scene, std::vector<Id>{2}));
  EXPECT_FALSE(FlatPrimitives::holds(scene, {}));
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
  const SurfacePoint<F> points = flat.surfacePoint(rays, flat.nearest(rays, Mask<8>(true)));
  EXPECT_EQ(points.material[0], 3u);
  EXPECT_EQ(points.material[5], 4u);
}

}  // namespace
}  // namespace steradian
