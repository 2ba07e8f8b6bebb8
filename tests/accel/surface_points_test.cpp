#include "steradian/accel/surface_points.h"

#include <gtest/gtest.h>

#include "steradian/tests/accel/random_scene.h"
#include "steradian/tests/accel/same_hits.h"

namespace steradian::test {
namespace {

using F = Lanes<8>;

void expectSame(Vec3f a, Vec3f b) {
  ASSERT_EQ(a.x, b.x);
  ASSERT_EQ(a.y, b.y);
  ASSERT_EQ(a.z, b.z);
}

void expectSame(const SurfacePoint<float>& point, const SurfacePoint<float>& expected) {
  ASSERT_EQ(point.valid, expected.valid);
  if (!expected.valid) return;
  ASSERT_NO_FATAL_FAILURE(expectSame(point.position, expected.position));
  ASSERT_NO_FATAL_FAILURE(expectSame(point.positionError, expected.positionError));
  ASSERT_NO_FATAL_FAILURE(expectSame(point.geometricNormal, expected.geometricNormal));
  ASSERT_NO_FATAL_FAILURE(expectSame(point.shadingNormal, expected.shadingNormal));
  ASSERT_EQ(point.uv.x, expected.uv.x);
  ASSERT_EQ(point.uv.y, expected.uv.y);
  ASSERT_EQ(point.distance, expected.distance);
  ASSERT_EQ(point.shape, expected.shape);
  ASSERT_EQ(point.primitive, expected.primitive);
  ASSERT_EQ(point.instance, expected.instance);
  ASSERT_EQ(point.material, expected.material);
}

/// A mesh with normals and uv of its own.
TriangleMesh smoothMesh(Random& random, int count) {
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    const Vec3f a = random.point(5.0f);
    addTo(mesh, a, a + random.direction() * 0.8f, a + random.direction() * 0.8f);
    for (int k = 0; k < 3; ++k) {
      mesh.normals.push_back(random.direction());
      mesh.uvs.push_back({random.uniform(0.0f, 1.0f), random.uniform(0.0f, 1.0f)});
    }
  }
  return mesh;
}

/// Everything at once: shapes of all kinds, custom ones, smooth meshes, some of them in motion, in instances at rest
/// and moving ones, and moving in moving instances.
SceneDescription everything(int count) {
  SceneDescription scene = randomScene(31, count);
  Random random(32);
  const Id smooth = scene.addShape("smooth", smoothMesh(random, 3 * count), 3);
  const Id moving = scene.addShape("moving", scene.shapes[1].geometry, 4);
  const Id inGroup = scene.addShape("in a group", scene.shapes[3].geometry, 5);
  const Id smoothInGroup = scene.addShape("smooth in a group", smoothMesh(random, count), 6);
  const Id movingInGroup = scene.addShape("moving in a group", scene.shapes[0].geometry, 7);
  const Matrix there = transformOf({0.3f, 0.1f, 0.2f}, {1.1f, 0.9f, 1.0f}, {1.0f, -0.5f, 0.5f});
  scene.shapes[moving].motion = Motion{Matrix(), there};
  scene.shapes[movingInGroup].motion = Motion{there, Matrix()};
  scene.shapes[smooth].motion = Motion{Matrix(), transformOf({}, {1, 1, 1}, {0.5f, 0.0f, 0.0f})};
  scene.groups = {{"group", {inGroup, smoothInGroup, movingInGroup}}};
  const Matrix turned = transformOf({0.7f, 1.1f, -0.4f}, {1.2f, 0.8f, 1.0f}, {2.0f, -3.0f, 1.0f});
  const Matrix mirrored = transformOf({0.0f, 0.5f, 0.0f}, {-1.0f, 1.0f, 1.5f}, {-2.0f, 0.0f, 0.0f});
  scene.instances = {{0, {turned, mirrored}, {}, {}}, {0, {turned}, {there}, {}}};
  return scene;
}

/// Returns for which placements points were compared, as bits: direct, instance, beyond.
void expectPointsOfSingleRays(const SceneDescription& description, const GeometrySettings& settings) {
  const Geometry geometry(std::make_shared<SceneDescription>(description), settings);
  Random random(33);
  int points = 0, direct = 0, transformedOnce = 0, twice = 0, smooth = 0;
  for (int round = 0; round < 1500; ++round) {
    Ray<F> rays;
    std::array<Ray<float>, 8> each;
    std::array<Hit<float>, 8> hits;
    SurfacePoints<F> found(geometry, true);
    for (int i = 0; i < 8; ++i) {
      Ray<float>& ray = each[static_cast<std::size_t>(i)];
      ray = random.ray(10.0f);
      ray.time = random.uniform(0.0f, 0.99f);
      setLane(rays, i, ray);
      const Hit<float> hit = hits[static_cast<std::size_t>(i)] = geometry.intersect(ray);
      if (!hit.valid || (round + i) % 5 == 0) continue;  // some lanes are idle
      found.add(i, ray, hit);
      Matrix a, b;
      const Geometry::Placement placement = geometry.placementOf(hit, ray.time, a, b);
      direct += placement == Geometry::Placement::Direct;
      transformedOnce += placement == Geometry::Placement::Transformed;
      twice += placement == Geometry::Placement::TransformedTwice;
      smooth += geometry.vertexData(hit) != nullptr;
    }
    const SurfacePoint<F> all = found.find(rays);
    for (int i = 0; i < 8; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const bool active = hits[k].valid && (round + i) % 5 != 0;
      const SurfacePoint<float> expected = active ? geometry.surfacePoint(each[k], hits[k]) : SurfacePoint<float>{};
      ASSERT_NO_FATAL_FAILURE(expectSame(lane(all, i), expected));
      points += active;
    }
  }
  EXPECT_GT(points, 2000);
  EXPECT_GT(direct, 300);
  EXPECT_GT(transformedOnce, 300);
  EXPECT_GT(twice, 20);
  EXPECT_GT(smooth, 100);
}

TEST(SurfacePoints, AreThoseOfSingleRays) {
  for (const std::size_t triangles : {std::size_t{0}, std::size_t{100000}}) {
    for (const Accel accel : {Accel::Auto, Accel::Embree}) {
      expectPointsOfSingleRays(everything(60), {.accel = {.accel = accel, .maxClusteredTriangles = triangles}});
    }
  }
}

TEST(SurfacePoints, AreThoseOfSingleRaysWhereNoRecordsAreKept) {
  expectPointsOfSingleRays(everything(20000), {});
  expectPointsOfSingleRays(everything(3000), {.accel = {.maxClusteredTriangles = 1000000}});
}

// The groups cluster their shapes in different ways, so that a hit's place in one of them is another's in the other.
TEST(SurfacePoints, OfShapesInSeveralGroupsAreOnTheirPrimitives) {
  SceneDescription scene = randomScene(34, 100);
  const SceneDescription others = randomScene(36, 70);
  const Id quads = scene.addShape("more quads", others.shapes[1].geometry, 2);
  const Id boxes = scene.addShape("more boxes", others.shapes[3].geometry, 2);
  scene.groups = {{"first", {0, 1, 3}}, {"second", {1, 2, 3, 4, 5, quads, boxes}}};
  const Matrix left = transformOf({}, {1.0f, 1.0f, 1.0f}, {-8.0f, 0.0f, 0.0f});
  const Matrix right = transformOf({}, {1.0f, 1.0f, 1.0f}, {8.0f, 0.0f, 0.0f});
  scene.instances = {{0, {left}, {}, {}}, {1, {right}, {}, {}}};
  const auto shared = std::make_shared<const SceneDescription>(scene);
  const Geometry geometry(shared);
  Random random(35);
  int points = 0;
  for (int i = 0; i < 4000; ++i) {
    Ray<float> ray = random.ray(5.0f);
    ray.origin.x += i % 2 == 0 ? -8.0f : 8.0f;
    const Hit<float> hit = geometry.intersect(ray);
    if (!hit.valid || hit.instance == kNone) continue;
    ++points;
    const Matrix& matrix = geometry.instanceTransforms()[hit.instance];
    const Matrix inverse = affineInverse(matrix);
    const SurfacePoint<float> expected =
        transformed(localSurfacePoint(scene.shapes[hit.shape], transformed(ray, inverse), hit), matrix, inverse);
    SurfacePoints<F> found(geometry, true);
    found.add(3, ray, hit);
    Ray<F> rays;
    setLane(rays, 3, ray);
    for (const SurfacePoint<float>& point : {geometry.surfacePoint(ray, hit), lane(found.find(rays), 3)}) {
      ASSERT_NO_FATAL_FAILURE(expectSame(point.position, expected.position));
      ASSERT_NO_FATAL_FAILURE(expectSame(point.geometricNormal, expected.geometricNormal));
      ASSERT_EQ(point.uv.x, expected.uv.x);
      ASSERT_EQ(point.primitive, hit.primitive);
    }
  }
  EXPECT_GT(points, 500);
}

TEST(SurfacePoints, NeedNoHit) {
  const Geometry geometry(std::make_shared<SceneDescription>(everything(10)));
  EXPECT_FALSE(any(SurfacePoints<F>(geometry, true).find({}).valid));
}

}  // namespace
}  // namespace steradian::test
