/// Moving shapes are hit where they are at the ray's time.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "steradian/accel/geometry.h"
#include "steradian/accel/transformed_point.h"
#include "steradian/core/base/diagnostics.h"
#include "steradian/core/math/motion.h"
#include "steradian/tests/accel/leaving_rays.h"
#include "steradian/tests/accel/same_hits.h"

namespace steradian::test {
namespace {

Ray<float> rayAtSomeTime(Random& random, float reach) {
  Ray<float> ray = random.ray(reach);
  ray.time = random.engine() % 8 == 0 ? 0.0f : random.uniform(0.0f, kOneMinusEpsilon);
  return ray;
}

Matrix randomKey(Random& random, float reach, bool mirror = false) {
  const auto size = [&] { return random.uniform(0.6f, 1.6f); };
  const float x = size();
  return transformOf(random.point(3.0f), {mirror ? -x : x, size(), size()}, random.point(reach));
}
Motion randomMotion(Random& random, float reach, bool mirror = false) {
  const Matrix open = randomKey(random, reach, mirror);
  return {open, randomKey(random, reach, mirror)};
}

/// Every shape alone and at rest.
std::vector<Geometry> alone(const SceneDescription& scene, const GeometrySettings& settings) {
  std::vector<Geometry> geometries;
  for (const ShapeDescription& shape : scene.shapes) {
    auto one = std::make_shared<SceneDescription>();
    one->shapes = {shape};
    one->shapes[0].motion.reset();
    geometries.emplace_back(one, settings);
  }
  return geometries;
}

struct Placed {
  Id shape;
  Id instance = kNone;
  std::optional<MovingTransform> motion = std::nullopt;  ///< of the shape
  std::optional<MovingTransform> place = std::nullopt;   ///< of the instance
};

/// The nearest hit, by a loop over all placed shapes.
Hit<float> loopOver(const std::vector<Placed>& all, const std::vector<Geometry>& shapes, const Ray<float>& ray) {
  Hit<float> best;
  for (const Placed& placed : all) {
    Ray<float> local = ray;
    if (placed.place) local = transformed(local, affineInverse(placed.place->at(ray.time)));
    if (placed.motion) local = transformed(local, affineInverse(placed.motion->at(ray.time)));
    Hit<float> hit = shapes[placed.shape].intersect(local);
    if (!hit.valid || hit.t >= best.t) continue;
    hit.shape = placed.shape;
    hit.instance = placed.instance;
    best = hit;
  }
  return best;
}

void expectLoop(const Geometry& geometry, const std::vector<Placed>& all, const std::vector<Geometry>& shapes,
                unsigned seed) {
  Random random(seed);
  int hits = 0, moving = 0;
  for (int i = 0; i < 8000; ++i) {
    Ray<float> ray = rayAtSomeTime(random, 12.0f);
    if (i % 4 == 0) ray.tMax = random.uniform(2.0f, 12.0f);
    const Hit<float> expected = loopOver(all, shapes, ray), hit = geometry.intersect(ray);
    ASSERT_NO_FATAL_FAILURE(expectSame(hit, expected)) << i;
    ASSERT_EQ(geometry.occluded(ray), expected.valid);
    if (!hit.valid) continue;
    ++hits;
    const auto placed = std::find_if(
        all.begin(), all.end(), [&](const Placed& p) { return p.shape == hit.shape && p.instance == hit.instance; });
    moving += placed->motion || placed->place ? 1 : 0;
    // The point is on the ray.
    const SurfacePoint<float> point = geometry.surfacePoint(ray, hit);
    ASSERT_LT(length(point.position - ray.at(hit.t)), 1e-4f);
    ASSERT_EQ(point.instance, hit.instance);
    ASSERT_EQ(point.distance, hit.t);
  }
  EXPECT_GT(hits, 1000);
  EXPECT_GT(moving, 500);
}

TEST(MovingGeometry, SpheresInAHierarchyAreThoseOfALoop) {
  SceneDescription description = randomScene(1, 100);
  Random random(2);
  SphereSet rising;
  for (int i = 0; i < 400; ++i) {
    const Vec3f from = random.point(5.0f);
    if (i % 3 == 0) {
      rising.add(from, 0.2f);
    } else {
      rising.addMoving(from, from + random.point(2.0f), random.uniform(0.1f, 0.3f));
    }
  }
  const Id shape = description.addShape("rising", rising, 0);
  const auto scene = std::make_shared<SceneDescription>(description);
  const Geometry loop(scene, direct()), tree(scene, hierarchy());
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray<float> ray = rayAtSomeTime(random, 12.0f);
    const Hit<float> expected = loop.intersect(ray), hit = tree.intersect(ray);
    ASSERT_NO_FATAL_FAILURE(expectSame(expected, hit));
    ASSERT_EQ(tree.occluded(ray), hit.valid);
    if (!hit.valid || hit.shape != shape) continue;
    ++hits;
    const SurfacePoint<float> point = tree.surfacePoint(ray, hit);
    const Vec3f center = movingSphereAt(rising, hit.primitive).at(ray.time).center;
    ASSERT_NEAR(length(point.position - center), rising.radius[hit.primitive], 1e-5f);
    ASSERT_GT(dot(point.geometricNormal, normalize(point.position - center)), 0.99999f);
  }
  EXPECT_GT(hits, 2000);
}

TEST(MovingGeometry, ShapesMoveByThemselves) {
  SceneDescription scene = randomScene(3, 80);
  Random random(4);
  std::vector<Placed> all;
  for (Id id = 0; id < scene.shapes.size(); ++id) {
    all.push_back({id});
    if (id % 3 == 2) continue;  // at rest
    scene.shapes[id].motion = randomMotion(random, 2.0f, id % 2 == 0);
    all.back().motion.emplace(*scene.shapes[id].motion);
  }
  const auto shared = std::make_shared<SceneDescription>(scene);
  const std::vector<Geometry> shapes = alone(scene, direct());
  for (const GeometrySettings& settings :
       {direct(), hierarchy(), GeometrySettings{.accel = {.maxClusteredTriangles = kAlways}}, embreeHierarchy()}) {
    expectLoop(Geometry(shared, settings), all, shapes, 5);
  }
}

TEST(MovingGeometry, InstancesMoveWithWhatIsInThem) {
  SceneDescription scene = randomScene(6, 40);
  Random random(7);
  scene.groups = {{"some", {0, 1, 2}}, {"others", {3, 5}}};
  scene.shapes[1].motion = randomMotion(random, 1.0f);
  // Those at rest are compared below: Embree transforms their rays, with roundings of its own.
  const auto key = [&] { return randomKey(random, 3.0f); };
  scene.instances.push_back({1, {key(), key()}, {key(), key()}, {}});
  scene.instances.push_back({0, {randomKey(random, 3.0f, true)}, {randomKey(random, 3.0f, true)}, {}});
  std::vector<Placed> all{{4}, {6}};
  Id instance = 0;
  for (const InstanceSet& set : scene.instances) {
    for (std::size_t i = 0; i < set.transforms.size(); ++i, ++instance) {
      for (const Id id : scene.groups[set.group].shapes) {
        Placed placed{id, instance};
        if (scene.shapes[id].motion) placed.motion.emplace(*scene.shapes[id].motion);
        placed.place.emplace(Motion{set.transforms[i], set.closing[i]});
        all.push_back(placed);
      }
    }
  }
  const auto shared = std::make_shared<SceneDescription>(scene);
  const std::vector<Geometry> shapes = alone(scene, direct());
  for (const GeometrySettings& settings :
       {direct(), hierarchy(), GeometrySettings{.accel = {.maxClusteredTriangles = kAlways}}, embreeHierarchy()}) {
    expectLoop(Geometry(shared, settings), all, shapes, 8);
  }
}

/// Everything at one time of its motion, at rest.
SceneDescription frozen(const SceneDescription& scene, float time) {
  SceneDescription still = scene;
  for (ShapeDescription& shape : still.shapes) {
    if (!shape.motion) continue;
    const Matrix then = MovingTransform(*shape.motion).at(time);
    shape.motion = Motion{then, then};
  }
  for (InstanceSet& set : still.instances) {
    for (std::size_t i = 0; i < set.closing.size(); ++i) {
      set.transforms[i] = MovingTransform({set.transforms[i], set.closing[i]}).at(time);
    }
    set.closing.clear();
  }
  return still;
}

TEST(MovingGeometry, IsTheStillSceneOfEachTime) {
  SceneDescription scene = randomScene(9, 60);
  Random random(10);
  scene.groups = {{"some", {0, 1, 2}}, {"others", {3, 4, 5}}};
  scene.shapes[1].motion = randomMotion(random, 1.0f);
  scene.shapes[6].motion = randomMotion(random, 1.0f);
  for (Id group = 0; group < 2; ++group) {
    scene.instances.push_back({group, {randomKey(random, 3.0f)}, {}, {}});
    scene.instances.push_back({group, {randomKey(random, 3.0f)}, {randomKey(random, 3.0f)}, {}});
  }
  for (const std::size_t clustered : {std::size_t{0}, std::size_t{100000}}) {
    const GeometrySettings settings{
        .accel = {.maxClustersWithoutTree = clustered == 0 ? 0u : 64u, .maxClusteredTriangles = clustered}};
    const Geometry moving(std::make_shared<SceneDescription>(scene), settings);
    int hits = 0, differ = 0;
    for (const float time : {0.0f, 0.3f, 0.77f, kOneMinusEpsilon}) {
      const Geometry still(std::make_shared<SceneDescription>(frozen(scene, time)), settings);
      for (int i = 0; i < 2000; ++i) {
        Ray<float> ray = random.ray(12.0f);
        ray.time = time;
        const Hit<float> expected = still.intersect(ray), hit = moving.intersect(ray);
        if (hit.valid != expected.valid || hit.shape != expected.shape || hit.primitive != expected.primitive) {
          ++differ;
          continue;
        }
        if (!hit.valid) continue;
        ++hits;
        ASSERT_EQ(hit.instance, expected.instance);
        ASSERT_NEAR(hit.t, expected.t, 1e-4f * (1.0f + hit.t));
        const SurfacePoint<float> a = moving.surfacePoint(ray, hit), b = still.surfacePoint(ray, expected);
        ASSERT_LT(length(a.position - b.position), 1e-3f);
        ASSERT_GT(dot(a.geometricNormal, b.geometricNormal), 0.999f);
        ASSERT_EQ(a.material, b.material);
      }
    }
    EXPECT_GT(hits, 1500);
    EXPECT_LT(differ, 20);
  }
}

TEST(MovingGeometry, OfCopiesInOnePlaceTheFirstIsHit) {
  SceneDescription scene = randomScene(12, 30);
  Random random(13);
  scene.groups = {{"all", {0, 1, 2, 3, 4, 5, 6}}};
  const Motion motion = randomMotion(random, 1.0f);
  scene.instances = {{0, std::vector<Matrix>(9, motion.open), std::vector<Matrix>(9, motion.close)}};
  for (const GeometrySettings& settings : {direct(), hierarchy()}) {
    const Geometry geometry(std::make_shared<SceneDescription>(scene), settings);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
      const Hit<float> hit = geometry.intersect(rayAtSomeTime(random, 12.0f));
      if (!hit.valid) continue;
      ++hits;
      ASSERT_EQ(hit.instance, 0u);
    }
    EXPECT_GT(hits, 100);
  }
}

TEST(MovingGeometry, BoundsAndStatistics) {
  SceneDescription scene;
  SphereSet ball;
  ball.addMoving({0, 0, 0}, {0, 3, 0}, 1.0f);
  scene.shapes[scene.addShape("ball", ball, 0)].motion = Motion{Matrix(), transformOf({}, {1, 1, 1}, {5, 0, 0})};
  const Geometry geometry(std::make_shared<SceneDescription>(scene));
  const Bounds3 bounds = geometry.bounds();
  EXPECT_NEAR(bounds.low.x, -1.0f, 1e-3f);
  EXPECT_NEAR(bounds.high.x, 6.0f, 1e-3f);
  EXPECT_NEAR(bounds.high.y, 4.0f, 1e-3f);
  EXPECT_EQ(geometry.statistics().spheres, 1u);
  EXPECT_EQ(geometry.statistics().clusters, 1u);
  EXPECT_GT(geometry.statistics().bytes, 500u);
  // Both motions are composed.
  const Ray<float> ray{{2.5f, 1.5f, 9.0f}, {0.0f, 0.0f, -1.0f}, kInfinity, 0.5f};
  EXPECT_NEAR(geometry.intersect(ray).t, 8.0f, 1e-5f);
  EXPECT_EQ(geometry.intersect(ray).instance, kNone);
}

TEST(MovingGeometry, KnowsWhetherTimeMatters) {
  const auto depends = [](const auto& change) {
    SceneDescription scene;
    SphereSet ball;
    ball.add({0, 0, 0}, 1.0f);
    scene.addShape("ball", ball, 0);
    scene.groups = {{"group", {0}}};
    scene.instances = {{0, {Matrix()}, {Matrix()}}};
    change(scene);
    return Geometry(std::make_shared<SceneDescription>(scene)).dependsOnTime();
  };
  const Matrix there = transformOf({}, {1, 1, 1}, {1, 0, 0});
  EXPECT_FALSE(depends([](auto&) {}));
  EXPECT_TRUE(depends([&](auto& s) { s.instances[0].closing = {there}; }));
  EXPECT_TRUE(depends([&](auto& s) { s.shapes[0].motion = Motion{Matrix(), there}; }));
  EXPECT_TRUE(depends([](auto& s) { std::get<SphereSet>(s.shapes[0].geometry).addMoving({}, {1, 0, 0}, 1.0f); }));
  EXPECT_TRUE(depends([](auto& s) { s.addShape("custom", CustomShapeSet{{std::make_shared<Slab>(1.0f)}}, 0); }));
}

TEST(MovingGeometry, SingularKeysAreErrors) {
  SceneDescription scene = randomScene(11, 20);
  const Matrix flat = transformOf({}, {1.0f, 0.0f, 1.0f}, {});
  scene.shapes[0].motion = Motion{Matrix(), flat};
  EXPECT_THROW(Geometry(std::make_shared<SceneDescription>(scene)), Error);
  scene.shapes[0].motion.reset();
  scene.groups = {{"g", {0}}};
  scene.instances = {{0, {Matrix()}, {flat}, {}}};
  EXPECT_THROW(Geometry(std::make_shared<SceneDescription>(scene)), Error);
}

class LeavingRaysInMotion : public testing::TestWithParam<std::tuple<float, float>> {};

/// A shape under a motion, or a moving instance of it, or both.
SceneDescription movingShape(int kind, int way, Random& random, float place, float size) {
  SceneDescription scene;
  const float scale = std::exp(random.uniform(-2.0f, 2.0f));
  scene.addShape("shape", randomShape(kind, random, size / scale, size / scale), 0);
  const auto key = [&](float scaling, float reach) {
    const Vec3f scales{random.uniform(0.5f, 1.5f), random.uniform(0.5f, 1.5f), random.uniform(-1.5f, -0.5f)};
    return transformOf(random.point(3.0f), scales * scaling, random.point(reach));
  };
  const auto motion = [&](float scaling, float reach) {
    const Matrix open = key(scaling, reach);
    return Motion{open, key(scaling, reach)};
  };
  if (way == 0) {
    scene.shapes[0].motion = motion(scale, place);
    return scene;
  }
  if (way == 2) scene.shapes[0].motion = motion(1.0f, size / scale);
  scene.groups = {{"group", {0}}};
  const Motion whole = motion(scale, place);
  scene.instances = {{0, {whole.open}, {whole.close}, {}}};
  return scene;
}

TEST_P(LeavingRaysInMotion, DoNotMeetTheSurfaceTheyLeave) {
  const auto [place, size] = GetParam();
  for (int kind = 0; kind < 6; ++kind) {
    Random random(static_cast<unsigned>(kind) + 20);
    Leaks leaks;
    for (int round = 0; round < 60; ++round) {
      const SceneDescription moving = movingShape(kind, round % 3, random, place, size);
      const float time = random.uniform(0.0f, kOneMinusEpsilon);
      const Geometry geometry(std::make_shared<SceneDescription>(moving),
                              {.accel = {.accel = round % 3 ? Accel::Auto : Accel::Embree,
                                         .maxClustersWithoutTree = round % 2 ? 0u : 64u,
                                         .maxClusteredTriangles = round % 4 ? 100u : 0u}});
      // // Where it is at that time.
      const Geometry still(std::make_shared<SceneDescription>(frozen(moving, time)));
      leaveBy(geometry, isClosed(kind), random, size, leaks, time, still.bounds());
    }
    EXPECT_GT(leaks.points, 200) << kind;
    EXPECT_EQ(leaks.touched, 0) << kind << " of " << leaks.points;
    EXPECT_EQ(leaks.escaped, 0) << kind << " of " << leaks.points;
  }
}

INSTANTIATE_TEST_SUITE_P(Coordinates, LeavingRaysInMotion,
                         testing::Values(std::tuple{1e-3f, 1e-3f}, std::tuple{1.0f, 1.0f}, std::tuple{100.0f, 1.0f},
                                         std::tuple{1e3f, 1e3f}, std::tuple{1e6f, 1e2f}));

}  // namespace
}  // namespace steradian::test
