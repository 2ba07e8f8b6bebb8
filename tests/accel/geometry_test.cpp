#include "steradian/accel/geometry.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <ctime>

#include <chrono>
#include <cmath>
#include <thread>

#include "steradian/accel/shapes/clusters/flat_primitives.h"
#include "steradian/accel/surface_point_of.h"
#include "steradian/core/base/diagnostics.h"
#include "steradian/tests/accel/random_scene.h"
#include "steradian/tests/accel/same_hits.h"
#include "steradian/tests/accel/shapes/mixed_scene.h"

namespace steradian::test {
namespace {

TEST(Geometry, HierarchiesGiveTheHitsOfALoopOverAllKinds) {
  const auto scene = std::make_shared<SceneDescription>(randomScene(1, 400));
  const Geometry loop(scene, direct()), tree(scene, hierarchy()), embree(scene, embreeHierarchy());
  Random random(2);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray<float> ray = random.ray(12.0f);
    const Hit<float> expected = loop.intersect(ray), hit = tree.intersect(ray);
    ASSERT_NO_FATAL_FAILURE(expectSame(expected, hit));
    ASSERT_NO_FATAL_FAILURE(expectSame(expected, embree.intersect(ray)));
    for (const Geometry* geometry : {&loop, &tree, &embree}) ASSERT_EQ(geometry->occluded(ray), hit.valid);
    hits += hit.valid;
  }
  EXPECT_GT(hits, 4000);
}

TEST(Geometry, PacketsFindTheHitsOfSingleRays) {
  const auto scene = std::make_shared<SceneDescription>(randomScene(21, 200));
  for (const GeometrySettings& settings : {hierarchy(), embreeHierarchy()}) {
    const Geometry geometry(scene, settings);
    Random random(22);
    EmbreeCounts counts;
    for (std::size_t count = 0; count <= 8; ++count) {
      for (int round = 0; round < 100; ++round) {
        std::vector<Ray<float>> rays(count);
        for (Ray<float>& ray : rays) ray = random.ray(12.0f);
        std::vector<Hit<float>> hits(count);
        geometry.intersectPacket(rays, hits, &counts);
        for (std::size_t i = 0; i < count; ++i)
          ASSERT_NO_FATAL_FAILURE(expectSame(geometry.intersect(rays[i]), hits[i]));
      }
    }
    // Custom shapes are traversed by Embree, so both use it.
    EXPECT_EQ(counts.rays, 100u * 36u);
    EXPECT_GT(counts.callbacks, 0u);
    std::vector<Ray<float>> nine(9);
    std::vector<Hit<float>> hits(9);
    EXPECT_THROW(geometry.intersectPacket(nine, hits), Error);
  }
}

TEST(Geometry, CountsWhatEmbreeDoes) {
  SceneDescription balls;
  SphereSet set;
  for (int i = 0; i < 100; ++i) set.add({static_cast<float>(i), 0.0f, 0.0f}, 0.4f);
  balls.addShape("balls", set, 0);
  const auto scene = std::make_shared<SceneDescription>(balls);
  const Geometry own(scene), embree(scene, embreeHierarchy());
  EmbreeCounts none, some;
  const Ray<float> ray{{50.0f, 0.0f, 5.0f}, {0.0f, 0.0f, -1.0f}};
  EXPECT_TRUE(own.intersectUsable(ray, &none).valid);
  EXPECT_TRUE(own.occludedUsable(ray, &none));
  EXPECT_EQ(none.rays, 0u);
  EXPECT_EQ(none.callbacks, 0u);
  EXPECT_TRUE(embree.intersectUsable(ray, &some).valid);
  EXPECT_TRUE(embree.occludedUsable(ray, &some));
  EXPECT_EQ(some.rays, 2u);
  EXPECT_GE(some.callbacks, 2u);
  EXPECT_LE(some.callbacks, 6u);  // not one for each of the 13 clusters
}

using Eight = Lanes<8>;

/// The point of the ray in one of eight lanes, by the record of what it hit.
SurfacePoint<float> pointByRecord(const PointRecord* records, std::uint32_t record, PointKinds kinds,
                                  const Ray<float>& ray, const Hit<float>& hit, int at) {
  Ray<Eight> rays;
  RecordHit<Eight> hits;
  setLane(rays, at, ray);
  setLane(hits.valid, at, true);
  setLane(hits.t, at, hit.t);
  setLane(hits.u, at, hit.u);
  setLane(hits.v, at, hit.v);
  setLane(hits.record, at, record);
  hits.parametersKnown = true;
  return lane(surfacePoint(records, kinds, rays, hits, true), at);
}

void expectSamePoint(const SurfacePoint<float>& point, const SurfacePoint<float>& expected) {
  ASSERT_TRUE(point.valid);
  ASSERT_EQ(point.shape, expected.shape);
  ASSERT_EQ(point.primitive, expected.primitive);
  ASSERT_EQ(point.material, expected.material);
  ASSERT_EQ(point.distance, expected.distance);
  ASSERT_EQ(point.position.x, expected.position.x);
  ASSERT_EQ(point.position.z, expected.position.z);
  ASSERT_EQ(point.positionError.y, expected.positionError.y);
  ASSERT_EQ(point.shadingNormal.y, expected.shadingNormal.y);
  ASSERT_EQ(point.uv.x, expected.uv.x);
  ASSERT_EQ(point.uv.y, expected.uv.y);
}

// Points of several rays at once are those of single rays, uv included, with and without a hierarchy.
TEST(Geometry, PointsByRecordsAreThoseOfSingleRays) {
  const auto scene = std::make_shared<SceneDescription>(mixedScene());
  Numbers number;
  for (const GeometrySettings& settings : {direct(), hierarchy()}) {
    const Geometry geometry(scene, settings);
    const FlatPrimitives* flat = geometry.flat();
    EXPECT_EQ(flat != nullptr, settings.accel.maxClustersWithoutTree != 0);
    EXPECT_EQ(geometry.keptRecords().empty(), flat != nullptr);
    EXPECT_EQ(geometry.recordsByPlace(true), flat == nullptr);
    constexpr PointKinds all = ~0u >> 24;
    int points = 0;
    for (int i = 0; i < 8000; ++i) {
      const Vec3f from = number.point(4.0f);
      const Ray<float> ray{from, normalize(number.point(2.0f) - from), kInfinity, number(0.0f, 0.99f)};
      const Hit<float> hit = geometry.intersect(ray);
      if (!hit.valid) continue;
      ++points;
      const SurfacePoint<float> expected = geometry.surfacePoint(ray, hit);
      PointRecord record;
      geometry.fillRecord(record, hit);
      ASSERT_NO_FATAL_FAILURE(expectSamePoint(pointByRecord(&record, 0, all, ray, hit, i % 8), expected));
      if (flat == nullptr) {
        const PointRecord* kept = geometry.keptRecords().data();
        ASSERT_NO_FATAL_FAILURE(expectSamePoint(pointByRecord(kept, hit.place, all, ray, hit, i % 8), expected));
      } else {
        Ray<Eight> rays;
        setLane(rays, i % 8, ray);
        Mask<8> active(false);
        active.set(i % 8, true);
        const SurfacePoint<Eight> found = flat->surfacePoint(rays, flat->intersect<Eight, true>(rays, active), true);
        ASSERT_NO_FATAL_FAILURE(expectSamePoint(lane(found, i % 8), expected));
      }
    }
    EXPECT_GT(points, 3000);
  }
}

TEST(Geometry, KeepsRecordsOfAllButTheLargestScenes) {
  const auto withBoxes = [](std::uint32_t count) {
    auto scene = std::make_shared<SceneDescription>();
    BoxSet boxes;
    for (std::uint32_t i = 0; i < count; ++i)
      boxes.addRotatedY({static_cast<float>(i), 0, 0}, {0.3f, 0.3f, 0.3f}, 7.0f);
    scene->addShape("boxes", std::move(boxes), 5);
    return scene;
  };
  const Geometry large(withBoxes(65536)), larger(withBoxes(65537));
  EXPECT_GE(large.keptRecords().size(), 65536u);
  EXPECT_TRUE(larger.keptRecords().empty());
  EXPECT_TRUE(larger.recordsByPlace(true));
  EXPECT_GT(large.statistics().bytes, larger.statistics().bytes + 80u * 65536u - 1000u);
  EXPECT_EQ(large.keptRecords()[3].material, 5u);
}

TEST(Geometry, EquallyNearHitsGoToTheSmallerIdInAnyStructure) {
  // The same floor many times over, in several shapes and clusters, and axis-parallel rays through shared edges.
  SceneDescription scene;
  for (int copy = 0; copy < 3; ++copy) {
    QuadSet floor;
    for (int x = 0; x < 12; ++x) {
      for (int z = 0; z < 12; ++z) {
        addTo(floor, {{static_cast<float>(x), 0.0f, static_cast<float>(z)}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}});
      }
    }
    scene.addShape("floor", floor, 0);
  }
  const auto shared = std::make_shared<SceneDescription>(scene);
  const Geometry loop(shared, direct()), tree(shared, hierarchy()), embree(shared, embreeHierarchy());
  for (int x = 0; x <= 24; ++x) {
    for (int z = 0; z <= 24; ++z) {
      for (const float dx : {0.0f, 0.25f}) {
        const Vec3f target{0.5f * static_cast<float>(x), 0.0f, 0.5f * static_cast<float>(z)};
        const Vec3f direction = normalize(Vec3f{dx, -1.0f, 0.0f});
        const Ray<float> ray{target - direction * 4.0f, direction};
        const Hit<float> hit = tree.intersect(ray);
        ASSERT_NO_FATAL_FAILURE(expectSame(loop.intersect(ray), hit));
        ASSERT_NO_FATAL_FAILURE(expectSame(embree.intersect(ray), hit));
        if (x > 0 && x < 24 && z > 0 && z < 24) {
          ASSERT_TRUE(hit.valid);
          EXPECT_EQ(hit.shape, 0u);
        }
      }
    }
  }
}

TEST(Geometry, SegmentsEndWhereTheySay) {
  const auto scene = std::make_shared<SceneDescription>(randomScene(3, 100));
  for (const GeometrySettings settings :
       {direct(), hierarchy(), embreeHierarchy(), GeometrySettings{.accel = {.maxClusteredTriangles = 0}}}) {
    const Geometry geometry(scene, settings);
    Random random(4);
    for (int i = 0; i < 3000; ++i) {
      Ray<float> ray = random.ray(12.0f);
      const Hit<float> hit = geometry.intersect(ray);
      if (!hit.valid) continue;
      ray.tMax = hit.t * 0.9999f;
      ASSERT_FALSE(geometry.occluded(ray));
      ASSERT_FALSE(geometry.intersect(ray).valid);
      ray.tMax = hit.t * 1.0001f;
      ASSERT_TRUE(geometry.occluded(ray));
      ray.tMin = hit.t * 1.00001f;
      ASSERT_EQ(geometry.occluded(ray), geometry.intersect(ray).valid);
    }
  }
}

TEST(Geometry, SurfacePointsOfLargeSetsAreThoseOfSmallOnes) {
  // Sets beyond some thousands are read from the clusters, others from the description.
  const auto large = std::make_shared<SceneDescription>(randomScene(17, 4500));
  const Geometry geometry(large);
  Random random(18);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray<float> ray = random.ray(12.0f);
    const Hit<float> hit = geometry.intersect(ray);
    if (!hit.valid) continue;
    ++hits;
    const SurfacePoint<float> a = geometry.surfacePoint(ray, hit);
    const SurfacePoint<float> b = localSurfacePoint(large->shapes[hit.shape], ray, hit);
    ASSERT_EQ(length(a.position - b.position), 0.0f);
    ASSERT_EQ(length(a.positionError - b.positionError), 0.0f);
    ASSERT_EQ(length(a.geometricNormal - b.geometricNormal), 0.0f);
    ASSERT_EQ(a.uv.x, b.uv.x);
    ASSERT_EQ(a.uv.y, b.uv.y);
    ASSERT_EQ(a.shape, hit.shape);
    ASSERT_EQ(a.material, large->shapes[hit.shape].material);
  }
  EXPECT_GT(hits, 1000);
}

TEST(Geometry, NativeTrianglesAndClustersAgree) {
  const auto scene = std::make_shared<SceneDescription>(randomScene(5, 300));
  const Geometry loop(scene, direct()), native(scene, {.accel = {.maxClusteredTriangles = 0}});
  Random random(6);
  int differ = 0;
  for (int i = 0; i < 5000; ++i) {
    const Ray<float> ray = random.ray(12.0f);
    const Hit<float> expected = loop.intersect(ray), hit = native.intersect(ray);
    if (expected.valid == hit.valid &&
        (!hit.valid || (hit.shape == expected.shape && hit.primitive == expected.primitive))) {
      if (hit.valid) {
        ASSERT_NEAR(hit.t, expected.t, 1e-4f * (1.0f + hit.t));
        ASSERT_NEAR(hit.u, expected.u, 1e-2f);
        ASSERT_NEAR(hit.v, expected.v, 1e-2f);
      }
    } else {
      ++differ;
    }
  }
  EXPECT_LE(differ, 3);
}

TEST(Geometry, InstancesAreCopiesUnderTheirTransform) {
  // The flat scene holds a sphere set and a box; the other one instances them with rotation, scale and translation.
  SceneDescription scene = randomScene(7, 60);
  const Matrix turn = transformOf({0.7f, 1.1f, -0.4f}, {2.0f, 2.0f, 2.0f}, {5.0f, -3.0f, 1.0f});
  const Matrix mirror = transformOf({0.0f, 0.5f, 0.0f}, {-1.0f, 1.0f, 3.0f}, {-30.0f, 0.0f, 0.0f});
  Group group{"all", {}};
  for (Id id = 0; id < scene.shapes.size(); ++id) group.shapes.push_back(id);
  const auto flat = std::make_shared<SceneDescription>(scene);
  scene.groups = {group};
  scene.instances = {{0, {turn}, {}}, {0, {mirror}, {}}};
  const auto instanced = std::make_shared<SceneDescription>(scene);
  for (const std::size_t clustered : {std::size_t{0}, std::size_t{100000}}) {
    const Geometry local(flat, {.accel = {.maxClusteredTriangles = clustered}}),
        world(instanced, {.accel = {.maxClusteredTriangles = clustered}});
    ASSERT_EQ(world.instanceTransforms().size(), 2u);
    Random random(8);
    int differ = 0, hits = 0;
    for (int i = 0; i < 4000; ++i) {
      const std::uint32_t instance = static_cast<std::uint32_t>(i % 2);
      const Matrix& m = world.instanceTransforms()[instance];
      Ray<float> ray = random.ray(12.0f);
      ray.tMax = 15.0f;
      const Hit<float> expected = local.intersect(ray);
      const SurfacePoint<float> here = local.surfacePoint(ray, expected);
      Ray<float> there{transformPoint(m, ray.origin), transformVector(m, ray.direction)};
      const float scale = length(there.direction);
      there.direction = normalize(there.direction);
      there.tMax = ray.tMax * scale;
      const Hit<float> hit = world.intersect(there);
      if (hit.valid != expected.valid || (hit.valid && hit.primitive != expected.primitive)) {
        ++differ;
        continue;
      }
      if (!hit.valid) continue;
      ++hits;
      ASSERT_EQ(hit.instance, instance);
      ASSERT_EQ(hit.shape, expected.shape);
      ASSERT_NEAR(hit.t, expected.t * scale, 2e-3f * scale);
      const SurfacePoint<float> point = world.surfacePoint(there, hit);
      ASSERT_LT(length(point.position - transformPoint(m, here.position)), 1e-2f);
      const Matrix inverse(Imath::M44d(m).inverse());
      const Vec3f normal = normalize(transformNormal(inverse, here.geometricNormal));
      ASSERT_GT(dot(point.geometricNormal, normal), 0.999f);
      ASSERT_EQ(point.instance, instance);
      ASSERT_EQ(point.material, here.material);
    }
    EXPECT_GT(hits, 500);
    EXPECT_LT(differ, 20);
  }
}

TEST(Geometry, RaysThatMakeNoSenseHitNothing) {
  const auto scene = std::make_shared<SceneDescription>(randomScene(9, 50));
  for (const GeometrySettings settings : {direct(), hierarchy(), embreeHierarchy()}) {
    const Geometry geometry(scene, settings);
    const float nan = std::nanf("");
    for (const Ray<float>& ray :
         {Ray<float>{{nan, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}}, Ray<float>{{kInfinity, 0.0f, 0.0f}, {-1.0f, 0.0f, 0.0f}},
          Ray<float>{{}, {}}, Ray<float>{{}, {nan, nan, nan}}, Ray<float>{{}, {0.0f, 0.0f, 1.0f}, nan},
          Ray<float>{{}, {0.0f, 0.0f, 1.0f}, -1.0f}}) {
      EXPECT_FALSE(geometry.intersect(ray).valid);
      EXPECT_FALSE(geometry.occluded(ray));
    }
    EXPECT_FALSE(geometry.surfacePoint({{}, {0.0f, 0.0f, 1.0f}}, {}).valid);
  }
}

TEST(Geometry, AnEmptySceneIsEmpty) {
  const Geometry geometry(std::make_shared<SceneDescription>());
  EXPECT_TRUE(geometry.bounds().empty());
  EXPECT_FALSE(geometry.intersect({{}, {0.0f, 0.0f, 1.0f}}).valid);
  EXPECT_EQ(geometry.statistics().primitives(), 0u);
}

TEST(Geometry, StatisticsCountWhatIsThere) {
  const auto scene = std::make_shared<SceneDescription>(randomScene(10, 320));
  const Geometry geometry(scene, hierarchy());
  const GeometryStatistics s = geometry.statistics();
  EXPECT_EQ(s.spheres, 320u);
  EXPECT_EQ(s.quads, 320u);
  EXPECT_EQ(s.boxes, 640u);  // upright ones and others
  EXPECT_EQ(s.disks, 320u);
  EXPECT_EQ(s.triangles, 320u);
  EXPECT_EQ(s.custom, 2u);
  EXPECT_GE(s.clusters, 6u * 40u);
  EXPECT_LE(s.clusters, 6u * 40u + 12u);  // and a few primitives oversized in their clusters
  // 6 to 12 rows of 8 numbers a cluster, and the hierarchy.
  EXPECT_GT(s.bytes, s.clusters * 6 * 32);
  EXPECT_LT(s.bytes, s.clusters * (12 * 32 + 256) + (1u << 18));  // and Embree's of the custom shapes
  EXPECT_GT(s.buildSeconds, 0.0);
  const Bounds3 bounds = geometry.bounds();
  EXPECT_LT(bounds.low.x, -4.0f);
  EXPECT_GT(bounds.high.y, 4.0f);
  EXPECT_LT(bounds.magnitude(), 10.0f);
}

TEST(Geometry, SingularTransformsAndBoundlessShapesAreErrors) {
  SceneDescription scene = randomScene(11, 20);
  scene.groups = {{"g", {0}}};
  scene.instances = {{0, {transformOf({}, {1.0f, 0.0f, 1.0f}, {})}, {}}};
  EXPECT_THROW(Geometry(std::make_shared<SceneDescription>(scene)), Error);
  scene.instances.clear();
  scene.groups.clear();
  scene.addShape("endless", CustomShapeSet{{std::make_shared<Slab>(kInfinity)}}, 0);
  EXPECT_THROW(Geometry(std::make_shared<SceneDescription>(scene)), Error);
}

double cpuSeconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Workers of earlier tests spin for a while before they sleep.
void waitUntilOthersSleep() {
  for (int i = 0; i < 400; ++i) {
    const double before = cpuSeconds(CLOCK_PROCESS_CPUTIME_ID);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (cpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - before < 2e-4) return;
  }
}

TEST(Geometry, BuildsStayInTheArenaOfTheCaller) {
  // In an arena of one thread that thread does all the work, so its CPU time is that of the process.
  const auto scene = std::make_shared<SceneDescription>(randomScene(12, 6000));
  tbb::task_arena arena(1);
  arena.execute([&] {
    const Geometry warmUp(scene);
    waitUntilOthersSleep();
    const double process = cpuSeconds(CLOCK_PROCESS_CPUTIME_ID), thread = cpuSeconds(CLOCK_THREAD_CPUTIME_ID);
    const Geometry clusters(scene), native(scene, {.accel = {.maxClusteredTriangles = 0}});
    const double own = cpuSeconds(CLOCK_THREAD_CPUTIME_ID) - thread;
    EXPECT_LT(cpuSeconds(CLOCK_PROCESS_CPUTIME_ID) - process, 1.1 * own + 1e-3);
  });
}

TEST(Geometry, AClosedRoomDoesNotLeak) {
  // Six walls that share their edges; rays at the edges and corners.
  SceneDescription scene;
  QuadSet walls;
  const Vec3f x{5.55f, 0.0f, 0.0f}, y{0.0f, 5.55f, 0.0f}, z{0.0f, 0.0f, 5.55f};
  addTo(walls, {{}, x, y});
  addTo(walls, {{}, y, z});
  addTo(walls, {{}, z, x});
  addTo(walls, {z, x, y});
  addTo(walls, {x, y, z});
  addTo(walls, {y, z, x});
  scene.addShape("walls", walls, 0);
  const auto shared = std::make_shared<SceneDescription>(scene);
  for (const GeometrySettings settings : {direct(), hierarchy(), embreeHierarchy()}) {
    const Geometry geometry(shared, settings);
    Random random(16);
    for (int i = 0; i < 20000; ++i) {
      const auto at = [&] { return random.uniform(0.5f, 5.0f); };
      const auto end = [&] { return random.engine() % 2 == 0 ? 0.0f : 5.55f; };
      const Vec3f target{i % 3 == 0 ? at() : end(), i % 3 == 1 ? at() : end(), i % 5 == 0 ? at() : end()};
      const Vec3f origin{at(), at(), at()};
      ASSERT_TRUE(geometry.intersect({origin, normalize(target - origin)}).valid);
    }
  }
}

TEST(Geometry, TwoAtOnceDoNotDisturbEachOther) {
  const auto one = std::make_shared<SceneDescription>(randomScene(13, 200));
  const auto two = std::make_shared<SceneDescription>(randomScene(14, 200));
  const auto hitsOf = [](const Geometry& geometry) {
    Random random(15);
    std::vector<float> distances;
    for (int i = 0; i < 3000; ++i) distances.push_back(geometry.intersect(random.ray(12.0f)).t);
    return distances;
  };
  const std::vector<float> alone[2] = {hitsOf(Geometry(one, direct())), hitsOf(Geometry(two, direct()))};
  std::vector<float> together[2];
  std::thread first([&] { together[0] = hitsOf(Geometry(one, hierarchy())); });
  std::thread second([&] { together[1] = hitsOf(Geometry(two, hierarchy())); });
  first.join();
  second.join();
  EXPECT_EQ(together[0], alone[0]);
  EXPECT_EQ(together[1], alone[1]);
}

}  // namespace
}  // namespace steradian::test
