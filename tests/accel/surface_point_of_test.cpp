#include "steradian/accel/surface_point_of.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/tests/accel/leaving_rays.h"

namespace steradian::test {
namespace {

/// The point where a ray hits the only shape of a scene.
SurfacePoint<float> surfacePointAt(const ShapeGeometry& shape, const Ray<float>& ray) {
  SceneDescription scene;
  scene.addShape("shape", shape, 5);
  const Geometry geometry(std::make_shared<SceneDescription>(scene));
  return geometry.surfacePoint(ray, geometry.intersect(ray));
}

void expectNear(Vec3f a, Vec3f b, float tolerance = 1e-5f) { EXPECT_LT(length(a - b), tolerance); }

TEST(SurfacePoint, SphereHasTheBooksParameters) {
  SphereSet set;
  addTo(set, {{1.0f, 2.0f, 3.0f}, 2.0f});
  // "The Next Week", 4.4: <1,0,0> is (.5,.5), <0,1,0> is (.5,1), <0,0,1> is (.25,.5), <-1,0,0> is (0,.5), <0,0,-1>
  // is (.75,.5).
  const struct {
    Vec3f normal;
    float u, v;
  } cases[] = {{{1, 0, 0}, 0.50f, 0.50f},  {{0, 1, 0}, 0.50f, 1.00f},  {{0, 0, 1}, 0.25f, 0.50f},
               {{0, -1, 0}, 0.50f, 0.00f}, {{0, 0, -1}, 0.75f, 0.50f}, {{-1, 0, 0}, 0.00f, 0.50f}};
  for (const auto& c : cases) {
    const SurfacePoint<float> p = surfacePointAt(set, {Vec3f{1.0f, 2.0f, 3.0f} + c.normal * 5.0f, -c.normal});
    ASSERT_TRUE(p.valid);
    expectNear(p.geometricNormal, c.normal);
    expectNear(p.position, Vec3f{1.0f, 2.0f, 3.0f} + c.normal * 2.0f);
    EXPECT_FLOAT_EQ(p.distance, 3.0f);
    EXPECT_EQ(p.material, 5u);
    EXPECT_NEAR(p.uv.y, c.v, 1e-5f);
    // The seam at -x is both ends.
    const float du = std::abs(p.uv.x - c.u);
    if (c.normal.y == 0.0f) {
      EXPECT_LT(std::min(du, 1.0f - du), 1e-5f);
    }
    EXPECT_GE(p.uv.x, 0.0f);
    EXPECT_LE(p.uv.x, 1.0f);
  }
  // From inside the normal is still outward.
  expectNear(surfacePointAt(set, {{1.0f, 2.0f, 3.0f}, {0.0f, 0.0f, 1.0f}}).geometricNormal, {0.0f, 0.0f, 1.0f});
}

TEST(SurfacePoint, QuadHasParametersAlongItsEdges) {
  QuadSet set;
  addTo(set, {{1.0f, 1.0f, 1.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 4.0f, 0.0f}});
  const SurfacePoint<float> p = surfacePointAt(set, {{1.5f, 4.0f, 3.0f}, {0.0f, 0.0f, -1.0f}});
  ASSERT_TRUE(p.valid);
  expectNear(p.position, {1.5f, 4.0f, 1.0f});
  expectNear(p.geometricNormal, {0.0f, 0.0f, 1.0f});
  EXPECT_NEAR(p.uv.x, 0.25f, 1e-6f);
  EXPECT_NEAR(p.uv.y, 0.75f, 1e-6f);
}

TEST(SurfacePoint, DiskHasAngleAndRadius) {
  DiskSet set;
  addTo(set, {{0.0f, 1.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 2.0f});
  const Frame<float> frame = Frame<float>::fromZ({0.0f, 1.0f, 0.0f});
  for (const float angle : {0.1f, 0.3f, 0.6f, 0.9f}) {
    const Vec3f offset = frame.x * std::cos(kTwoPi * angle) + frame.y * std::sin(kTwoPi * angle);
    const SurfacePoint<float> p = surfacePointAt(set, {offset + Vec3f{0.0f, -3.0f, 0.0f}, {0.0f, 1.0f, 0.0f}});
    ASSERT_TRUE(p.valid);
    expectNear(p.position, offset + Vec3f{0.0f, 1.0f, 0.0f});
    expectNear(p.geometricNormal, {0.0f, 1.0f, 0.0f});
    EXPECT_NEAR(p.uv.x, angle, 1e-5f);
    EXPECT_NEAR(p.uv.y, 0.5f, 1e-5f);
  }
}

TEST(SurfacePoint, BoxFacesHaveTheBooksParameters) {
  BoxSet set;
  addTo(set, {{0.0f, 0.0f, 0.0f}, {1.0f, 2.0f, 3.0f}, 1.0f, 0.0f, 0.0f, 0.0f});
  set.rotationW = {1.0f};
  // At (x, y, z) = (.5, 1, 1.5) on every face; "The Next Week", 8.1 gives corner and edges of each.
  const struct {
    Vec3f normal;
    float u, v;
  } cases[] = {{{0, 0, 1}, 0.75f, 0.75f},  {{1, 0, 0}, 0.25f, 0.75f}, {{0, 0, -1}, 0.25f, 0.75f},
               {{-1, 0, 0}, 0.75f, 0.75f}, {{0, 1, 0}, 0.75f, 0.25f}, {{0, -1, 0}, 0.75f, 0.75f}};
  for (const auto& c : cases) {
    const Vec3f inPlane = Vec3f{0.5f, 1.0f, 1.5f} * (Vec3f{1.0f, 1.0f, 1.0f} - absolute(c.normal));
    const SurfacePoint<float> p = surfacePointAt(set, {inPlane + c.normal * 10.0f, -c.normal});
    ASSERT_TRUE(p.valid);
    expectNear(p.geometricNormal, c.normal);
    EXPECT_NEAR(p.uv.x, c.u, 1e-5f);
    EXPECT_NEAR(p.uv.y, c.v, 1e-5f);
  }
  // Turned: the normal turns too, also for the exit face from inside.
  const float h = std::sqrt(0.5f);
  set.rotationW = {h};
  set.rotationY = {h};
  const SurfacePoint<float> p = surfacePointAt(set, {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}});
  expectNear(p.position, {3.0f, 0.0f, 0.0f});
  expectNear(p.geometricNormal, {1.0f, 0.0f, 0.0f});
}

TEST(SurfacePoint, MeshesInterpolateNormalsAndParameters) {
  TriangleMesh mesh;
  addTo(mesh, {0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f});
  const Ray<float> ray{{0.5f, 0.25f, 3.0f}, {0.0f, 0.0f, -1.0f}};
  SurfacePoint<float> p = surfacePointAt(mesh, ray);
  ASSERT_TRUE(p.valid);
  expectNear(p.geometricNormal, {0.0f, 0.0f, 1.0f});
  expectNear(p.shadingNormal, {0.0f, 0.0f, 1.0f});
  EXPECT_NEAR(p.uv.x, 0.5f, 1e-6f);
  EXPECT_NEAR(p.uv.y, 0.25f, 1e-6f);
  const Vec3f a = normalize(Vec3f{0.0f, 0.3f, 1.0f}), b = normalize(Vec3f{0.5f, 0.0f, 1.0f}), c{0.0f, 0.0f, 1.0f};
  mesh.normals = {a, b, c};
  mesh.uvs = {{0.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 1.0f}};
  p = surfacePointAt(mesh, ray);
  expectNear(p.geometricNormal, {0.0f, 0.0f, 1.0f});
  expectNear(p.shadingNormal, normalize(a * 0.25f + b * 0.5f + c * 0.25f));
  EXPECT_NEAR(p.uv.x, 0.25f, 1e-6f);
  EXPECT_NEAR(p.uv.y, 0.75f, 1e-6f);
  // Normals that point the other way are turned to the side of the geometric one.
  for (Vec3f& n : mesh.normals) n = -n;
  EXPECT_GT(dot(surfacePointAt(mesh, ray).shadingNormal, Vec3f{0.0f, 0.0f, 1.0f}), 0.5f);
}

TEST(SurfacePoint, CustomShapesGiveTheirOwnNormal) {
  const CustomShapeSet set{{std::make_shared<Slab>(2.0f, 1.0f)}};
  const SurfacePoint<float> p = surfacePointAt(set, {{1.0f, 0.0f, -3.0f}, {0.0f, 0.0f, 1.0f}});
  ASSERT_TRUE(p.valid);
  expectNear(p.position, {1.0f, 0.0f, 1.0f});
  expectNear(p.geometricNormal, {0.0f, 0.0f, 1.0f});
  EXPECT_NEAR(p.uv.x, 0.75f, 1e-6f);
}

TEST(SurfacePoint, PrimitivesCanHaveMaterialsOfTheirOwn) {
  SphereSet set;
  addTo(set, {{0.0f, 0.0f, 0.0f}, 1.0f});
  addTo(set, {{5.0f, 0.0f, 0.0f}, 1.0f});
  SceneDescription scene;
  scene.shapes[scene.addShape("spheres", set, 5)].primitiveMaterials = {8, 9};
  const Geometry geometry(std::make_shared<SceneDescription>(scene));
  const Ray<float> ray{{5.0f, 0.0f, 9.0f}, {0.0f, 0.0f, -1.0f}};
  EXPECT_EQ(geometry.surfacePoint(ray, geometry.intersect(ray)).material, 9u);
}

// --- Rays that leave a surface ------------------------------------------------------------------------------------

class LeavingRays : public testing::TestWithParam<std::tuple<float, float>> {};

TEST_P(LeavingRays, DoNotMeetTheSurfaceTheyLeave) {
  const auto [place, size] = GetParam();
  for (int kind = 0; kind < 6; ++kind) {
    for (const std::size_t clustered : {std::size_t{100}, std::size_t{0}}) {
      if (clustered == 0 && kind < 5) continue;  // native triangles
      Random random(static_cast<unsigned>(kind) + 1);
      Leaks leaks;
      for (int round = 0; round < (clustered ? 120 : 30); ++round) {
        SceneDescription scene;
        scene.addShape("shape", randomShape(kind, random, place, size), 0);
        const Geometry geometry(std::make_shared<SceneDescription>(scene),
                                {.accel = {.maxClusteredTriangles = clustered}});
        leaveBy(geometry, isClosed(kind), random, size, leaks);
      }
      EXPECT_GT(leaks.points, 200) << kind;
      EXPECT_EQ(leaks.touched, 0) << kind << " of " << leaks.points;
      EXPECT_EQ(leaks.escaped, 0) << kind << " of " << leaks.points;
    }
  }
}

TEST_P(LeavingRays, DoNotMeetTheInstanceTheyLeave) {
  const auto [place, size] = GetParam();
  for (int kind = 0; kind < 6; ++kind) {
    Random random(static_cast<unsigned>(kind) + 10);
    Leaks leaks;
    for (int round = 0; round < 15; ++round) {
      SceneDescription scene;
      const float scale = std::exp(random.uniform(-3.0f, 3.0f));
      scene.addShape("shape", randomShape(kind, random, size / scale, size / scale), 0);
      scene.groups = {{"group", {0}}};
      const Vec3f scales = Vec3f{random.uniform(0.5f, 1.5f), random.uniform(0.5f, 1.5f), random.uniform(-1.5f, -0.5f)};
      scene.instances = {{0, {transformOf(random.point(3.0f), scales * scale, random.point(place))}, {}}};
      const Geometry geometry(std::make_shared<SceneDescription>(scene),
                              {.accel = {.maxClusteredTriangles = round % 2 ? 0u : 100u}});
      leaveBy(geometry, isClosed(kind), random, size, leaks);
    }
    EXPECT_GT(leaks.points, 100) << kind;
    EXPECT_EQ(leaks.touched, 0) << kind << " of " << leaks.points;
    EXPECT_EQ(leaks.escaped, 0) << kind << " of " << leaks.points;
  }
}

INSTANTIATE_TEST_SUITE_P(Coordinates, LeavingRays,
                         testing::Values(std::tuple{1e-3f, 1e-3f}, std::tuple{1e-3f, 1e-4f}, std::tuple{1.0f, 1.0f},
                                         std::tuple{100.0f, 1.0f}, std::tuple{1e3f, 1e3f}, std::tuple{1e6f, 1e2f},
                                         std::tuple{1e6f, 1e6f}));

}  // namespace
}  // namespace steradian::test
