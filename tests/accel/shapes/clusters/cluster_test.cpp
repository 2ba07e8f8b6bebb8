#include "steradian/accel/shapes/clusters/cluster.h"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <numeric>

#include "steradian/accel/shapes/clusters/cluster_builder.h"
#include "steradian/accel/shapes/clusters/cluster_partition.h"
#include "steradian/accel/shapes/clusters/cluster_set.h"
#include "steradian/accel/shapes/primitives/shape_at.h"
#include "steradian/tests/accel/shapes/leaf_test.h"

namespace steradian::test {
namespace {

/// Nearest hit by width 1, one primitive after the other.
template <class Shape>
LeafHit oneByOne(const std::vector<Shape>& shapes, const Ray<float>& ray) {
  LeafHit best;
  for (std::uint32_t i = 0; i < shapes.size(); ++i) {
    const ShapeHit<float> hit = intersect(shapes[i], ray);
    if (hit.valid && hit.t < best.t) best = {hit.t, hit.u, hit.v, 7, i, kNone};
  }
  return best;
}

template <class F, class Leaf>
void expectIntersects(const Cluster<Leaf>& cluster, const Ray<float>& ray, const LeafHit& expected) {
  LeafHit best;
  intersectCluster(cluster, 3, broadcastRay<F>(ray), kNone, best);
  ASSERT_EQ(best.found(), expected.found());
  ASSERT_EQ(best.t, expected.t);
  ASSERT_EQ(best.primitive, expected.primitive);
  ASSERT_EQ(best.shape, expected.shape);
  ASSERT_EQ(best.place, expected.found() ? 3 * kClusterSize + expected.primitive : kNone);
  ASSERT_EQ(clusterOccludes(cluster, broadcastRay<F>(ray)), expected.found());
}

template <class Leaf, class Make>
void expectClusterIsLoop(unsigned seed, int count, const Make& make) {
  Random random(seed);
  int hits = 0;
  for (int round = 0; round < 300; ++round) {
    Cluster<Leaf> cluster;
    std::vector<typename Leaf::Shape> shapes;
    for (int i = 0; i < count; ++i) {
      shapes.push_back(make(random));
      cluster.put(i, shapes.back(), 7, static_cast<std::uint32_t>(i));
    }
    Ray<float> ray = random.rayTowards({0.0f, 0.0f, 0.0f}, 1.0f, 4.0f);
    ray.time = 0.9f * static_cast<float>(round) / 300.0f;
    const LeafHit expected = oneByOne(shapes, ray);
    ASSERT_NO_FATAL_FAILURE(expectIntersects<Lanes<4>>(cluster, ray, expected));
    ASSERT_NO_FATAL_FAILURE(expectIntersects<Lanes<8>>(cluster, ray, expected));
    hits += expected.found();
  }
  EXPECT_GT(hits, 5);
}

Sphere<float> randomSphere(Random& random) { return {random.point(1.5f), random.uniform(0.1f, 0.5f)}; }
MovingSphere<float> randomMovingSphere(Random& random) {
  return {random.point(1.5f), random.point(1.0f), random.uniform(0.1f, 0.5f)};
}
Quad<float> randomQuad(Random& random) { return {random.point(1.5f), random.direction(), random.direction()}; }
AlignedQuad randomAlignedQuad(Random& random) {
  const auto axis = [](int i) { return Vec3f{i == 0 ? 1.0f : 0.0f, i == 1 ? 1.0f : 0.0f, i == 2 ? 1.0f : 0.0f}; };
  const int u = static_cast<int>(random.uniform(0.0f, 2.99f)), v = (u + (random.uniform(0, 1) < 0.5f ? 1 : 2)) % 3;
  return *AlignedQuad::of(
      {random.point(1.5f), axis(u) * random.uniform(0.5f, 1.5f), axis(v) * -random.uniform(0.5f, 1.5f)});
}

TEST(Cluster, IsALoopOverItsPrimitives) {
  for (const int count : {1, 3, 4, 5, 8}) {
    expectClusterIsLoop<SphereLeaf>(1, count, randomSphere);
    expectClusterIsLoop<MovingSphereLeaf>(1, count, randomMovingSphere);
    expectClusterIsLoop<QuadLeaf>(2, count, randomQuad);
    expectClusterIsLoop<AlignedQuadLeaf>(3, count, randomAlignedQuad);
  }
}

TEST(Cluster, EquallyNearHitsGoToTheSmallestId) {
  const Quad<float> quad{{-1.0f, -1.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}};
  const Ray<float> ray{{0.0f, 0.0f, 3.0f}, {0.0f, 0.0f, -1.0f}};
  Cluster<QuadLeaf> cluster;
  for (int i = 0; i < kClusterSize; ++i) cluster.put(i, quad, 3, static_cast<std::uint32_t>(10 + i));
  const auto nearest = [&](LeafHit best, std::uint32_t instance) {
    intersectCluster(cluster, 0, broadcastRay<Lanes<8>>(ray), instance, best);
    return best;
  };
  EXPECT_EQ(nearest({}, kNone).primitive, 10u);
  // A hit found elsewhere at the same distance stays if its id is smaller, and goes if not.
  EXPECT_EQ(nearest({3.0f, 0.0f, 0.0f, 2, 99, kNone}, kNone).primitive, 99u);
  EXPECT_EQ(nearest({3.0f, 0.0f, 0.0f, 4, 0, kNone}, kNone).shape, 3u);
  EXPECT_EQ(nearest({3.0f, 0.0f, 0.0f, 3, 10, 5}, 4).instance, 4u);
  EXPECT_EQ(nearest({3.0f, 0.0f, 0.0f, 3, 10, 5}, 6).instance, 5u);
  // A nearer hit stays, regardless of its id.
  EXPECT_EQ(nearest({2.0f, 0.0f, 0.0f, 4, 0, kNone}, kNone).shape, 4u);
}

std::vector<Bounds3> randomBounds(Random& random, std::size_t count, float reach, float size) {
  std::vector<Bounds3> all(count);
  for (Bounds3& b : all) {
    const Vec3f center = random.point(reach), half{size, size, size};
    b = {center - half, center + half};
  }
  return all;
}

ClusterPartition partition(const std::vector<Bounds3>& all) {
  return partitionIntoClusters(static_cast<std::uint32_t>(all.size()), [&](std::uint32_t i) { return all[i]; });
}

void expectEveryOneOnce(const ClusterPartition& p, std::size_t count) {
  std::vector<int> seen(count, 0);
  for (const ClusterRange& range : p.ranges) {
    EXPECT_GE(range.count, 1u);
    EXPECT_LE(range.count, static_cast<std::uint32_t>(kClusterSize));
    for (std::uint32_t i = 0; i < range.count; ++i) {
      ++seen[p.items[range.begin + i].ordinal];
      if (i > 0) {
        EXPECT_LT(p.items[range.begin + i - 1].ordinal, p.items[range.begin + i].ordinal);
      }
    }
  }
  EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<std::ptrdiff_t>(count));
}

TEST(ClusterPartition, HoldsEveryPrimitiveOnceInFullClusters) {
  Random random(3);
  for (const std::size_t count : {1u, 8u, 9u, 100u, 1000u, 20000u}) {
    const ClusterPartition p = partition(randomBounds(random, count, 10.0f, 0.1f));
    expectEveryOneOnce(p, count);
    EXPECT_EQ(p.ranges.size(), (count + 7) / 8);
  }
  EXPECT_TRUE(partition({}).ranges.empty());
}

TEST(ClusterPartition, ClustersAreCompact) {
  Random random(4);
  const std::vector<Bounds3> all = randomBounds(random, 4096, 10.0f, 0.1f);
  double volume = 0.0;
  const ClusterPartition p = partition(all);
  for (const ClusterRange& range : p.ranges) {
    Bounds3 b;
    for (std::uint32_t i = 0; i < range.count; ++i) b.include(all[p.items[range.begin + i].ordinal]);
    volume += b.extent().x * b.extent().y * b.extent().z;
  }
  EXPECT_LT(volume, 1.2 * 20.0 * 20.0 * 20.0);
}

TEST(ClusterPartition, OversizedPrimitivesAreAlone) {
  Random random(5);
  std::vector<Bounds3> all = randomBounds(random, 500, 11.0f, 0.2f);
  all[123] = {{-1000.0f, -2000.0f, -1000.0f}, {1000.0f, 0.0f, 1000.0f}};
  // Too small for a size class of its own, too large for its neighbours.
  all[321] = {{-5.0f, -0.5f, -5.0f}, {5.0f, 0.5f, 5.0f}};
  const ClusterPartition p = partition(all);
  expectEveryOneOnce(p, all.size());
  for (const ClusterRange& range : p.ranges) {
    for (std::uint32_t i = 0; i < range.count; ++i) {
      if (p.items[range.begin + i].ordinal == 123) {
        EXPECT_EQ(range.count, 1u);
      }
    }
  }
  EXPECT_LE(p.ranges.size(), 66u);
}

TEST(ClusterPartition, HoldsEveryPrimitiveOnceAtTheEndsOfFloats) {
  for (const float scale : {1e38f, 3e38f, 1e-38f, 1e-44f, 0.0f}) {
    Random random(8);
    std::vector<Bounds3> all(300);
    for (Bounds3& b : all) {
      b.include(random.point(1.0f) * scale);
      b.include(random.point(1.0f) * scale);
    }
    expectEveryOneOnce(partition(all), all.size());
  }
}

TEST(ClusterPartition, SmallPartsOfMuchAreCutInTheMiddleInTheEnd) {
  // Each ten times as far away as the one before: a plane separates one from all others.
  std::vector<Bounds3> all(5000, Bounds3{{0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}});
  float place = 1e-37f;
  for (std::size_t i = 0; i < 75; ++i, place *= 10.0f) all[i] = {{place, place, place}, {place, place, place}};
  expectEveryOneOnce(partition(all), all.size());
}

TEST(ClusterPartition, DoesNotDependOnTheNumberOfThreads) {
  Random random(6);
  std::vector<Bounds3> all = randomBounds(random, 30000, 10.0f, 0.1f);
  for (std::size_t i = 0; i < 10000; ++i) all[2 * i] = all[0];  // ties in every axis
  const tbb::global_control allowThreads(tbb::global_control::max_allowed_parallelism, 4);
  ClusterPartition first;
  for (const int threads : {1, 4}) {
    tbb::task_arena arena(threads);
    const ClusterPartition p = arena.execute([&] { return partition(all); });
    if (threads == 1) {
      first = p;
      continue;
    }
    ASSERT_EQ(p.ranges.size(), first.ranges.size());
    for (std::size_t i = 0; i < p.items.size(); ++i) ASSERT_EQ(p.items[i].ordinal, first.items[i].ordinal);
  }
}

TEST(ClusterSet, IsTheSameForEveryInstructionSet) {
  Random random(7);
  SceneDescription scene;
  SphereSet spheres;
  QuadSet quads;
  for (int i = 0; i < 100; ++i) {
    const Sphere<float> s = randomSphere(random);
    spheres.centerX.push_back(s.center.x);
    spheres.centerY.push_back(s.center.y);
    spheres.centerZ.push_back(s.center.z);
    spheres.radius.push_back(0.3f * s.radius);
    const Quad<float> q = randomQuad(random);
    for (auto [to, value] : {std::pair{&quads.cornerX, q.corner.x},
                             {&quads.cornerY, q.corner.y},
                             {&quads.cornerZ, q.corner.z},
                             {&quads.uX, q.u.x},
                             {&quads.uY, q.u.y},
                             {&quads.uZ, q.u.z},
                             {&quads.vX, q.v.x},
                             {&quads.vY, q.v.y},
                             {&quads.vZ, q.v.z}}) {
      to->push_back(value * 0.5f);
    }
  }
  scene.addShape("spheres", spheres, 0);
  scene.addShape("quads", quads, 0);
  const std::vector<Id> ids = {1, 0};
  const BuiltClusters built = buildClusters(scene, ids);
  const ClusterSet set(built.clusters, Isa::Baseline);
  std::vector<ClusterSet> sameSets;
  for (const Isa isa : compiledIsas()) {
    if (isUsable(isa)) sameSets.emplace_back(built.clusters, isa);
  }
  EXPECT_EQ(set.size(), 26u);
  EXPECT_GT(set.bytes(), 26u * 8u * 6u * 4u);
  for (int i = 0; i < 500; ++i) {
    const Ray<float> ray = random.rayTowards({0.0f, 0.0f, 0.0f}, 1.0f, 4.0f);
    LeafHit expected;
    set.intersect(ray, kNone, expected);
    ASSERT_EQ(set.occluded(ray), expected.found());
    if (expected.found()) {
      ASSERT_TRUE(set.isUsed(expected.place));
      PointRecord record;
      set.fillRecord(record, expected.place);
      ASSERT_EQ(record.shape, expected.shape);
      ASSERT_EQ(record.primitive, expected.primitive);
      ASSERT_EQ(std::holds_alternative<Sphere<float>>(set.leafShape(expected.place)), expected.shape == 0);
    }
    for (const ClusterSet& same : sameSets) {
      LeafHit hit;
      same.intersect(ray, kNone, hit);
      ASSERT_EQ(hit.t, expected.t);
      ASSERT_EQ(hit.u, expected.u);
      ASSERT_EQ(hit.primitive, expected.primitive);
      ASSERT_EQ(hit.place, expected.place);
      ASSERT_EQ(same.occluded(ray), expected.found());
    }
  }
}

}  // namespace
}  // namespace steradian::test
