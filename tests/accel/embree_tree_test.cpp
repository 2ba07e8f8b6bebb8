#include "steradian/accel/embree_tree.h"

#include <gtest/gtest.h>

#include "steradian/accel/shapes/clusters/cluster_builder.h"
#include "steradian/tests/accel/random_scene.h"

namespace steradian::test {
namespace {

Bounds3 boundsOfChild(const ClusterTree::Node& node, std::uint32_t i) {
  const auto corner = [&](int side) {
    return Vec3f{node.side[side][0][i], node.side[side][1][i], node.side[side][2][i]};
  };
  return {corner(0), corner(1)};
}

bool holds(const Bounds3& outer, const Bounds3& inner) {
  const auto isAtMost = [](Vec3f a, Vec3f b) { return a.x <= b.x && a.y <= b.y && a.z <= b.z; };
  return isAtMost(outer.low, inner.low) && isAtMost(inner.high, outer.high);
}

/// Checks the invariants of a tree: each cluster in one leaf, bounds that enclose all below them, no path too long.
class TreeCheck {
 public:
  TreeCheck(const embree::Device& device, const std::vector<Bounds3>& clusters, float padding = 0.0f)
      : tree_(embree::buildTree(device, clusters, padding)), clusters_(clusters), seen_(clusters.size(), 0) {
    for (Bounds3& b : clusters_) {
      b.low = b.low - Vec3f{padding, padding, padding};
      b.high = b.high + Vec3f{padding, padding, padding};
    }
    check(0, {{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, kInfinity}}, 1);
    EXPECT_EQ(std::count(seen_.begin(), seen_.end(), 1), static_cast<std::ptrdiff_t>(clusters.size()));
  }

 private:
  void check(std::uint32_t number, const Bounds3& around, std::uint32_t depth) {
    ASSERT_LT(number, tree_.nodes.size());
    ASSERT_LE(depth, ClusterTree::kMaxDepth);
    const ClusterTree::Node& node = tree_.nodes[number];
    for (std::uint32_t i = 0; i < ClusterTree::kWidth; ++i) {
      const Bounds3 bounds = boundsOfChild(node, i);
      if (bounds.empty()) continue;
      EXPECT_TRUE(holds(around, bounds));
      if (node.child[i] & ClusterTree::kLeaf) {
        const std::uint32_t cluster = node.child[i] & ~ClusterTree::kLeaf;
        ASSERT_LT(cluster, clusters_.size());
        ++seen_[cluster];
        EXPECT_TRUE(holds(bounds, clusters_[cluster]));
      } else {
        EXPECT_GT(node.child[i], number);
        check(node.child[i], bounds, depth + 1);
      }
    }
  }

  const ClusterTree tree_;
  std::vector<Bounds3> clusters_;
  std::vector<int> seen_;
};

TEST(EmbreeTree, HoldsEachThingOnceWithinItsBounds) {
  const embree::Device device;
  Random random(1);
  for (const std::size_t count : {2u, 8u, 9u, 100u, 5000u}) {
    std::vector<Bounds3> clusters(count);
    for (Bounds3& b : clusters) {
      b.include(random.point(10.0f));
      b.include(b.low + random.point(1.0f));
    }
    const TreeCheck ofClusters(device, clusters, 0.01f);
  }
  EXPECT_TRUE(embree::buildTree(device, {}, 0.0f).nodes.empty());
  const Bounds3 one{{0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}};
  EXPECT_TRUE(embree::buildTree(device, std::span(&one, 1), 0.0f).nodes.empty());
  device.check();
}

TEST(EmbreeTree, ThingsInOnePlaceMakeNoTreeTooDeep) {
  const embree::Device device;
  const Bounds3 one{{0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}};
  const std::vector<Bounds3> same(20000, one);
  const TreeCheck ofSame(device, same);
  // Each a third of the one before: no plane separates more than one from the others.
  std::vector<Bounds3> nested;
  for (float size = 1e30f; size > 1e-30f; size /= 3.0f) nested.push_back({{0.0f, 0.0f, 0.0f}, {size, size, size}});
  const TreeCheck ofNested(device, nested);
  device.check();
}

ClusterSet withTree(const SceneDescription& scene, std::span<const Id> shapes) {
  const embree::Device device;
  BuiltClusters built = buildClusters(scene, shapes);
  built.clusters.tree = embree::buildTree(device, built.bounds, 1e-5f);
  return {std::move(built.clusters), bestIsa()};
}

void expectSame(const LeafHit& hit, const LeafHit& expected) {
  ASSERT_EQ(hit.t, expected.t);
  ASSERT_EQ(hit.u, expected.u);
  ASSERT_EQ(hit.shape, expected.shape);
  ASSERT_EQ(hit.primitive, expected.primitive);
}

void expectATreeChangesNoHit(int many) {
  Random random(11);
  SceneDescription scene;
  SphereSet balls;
  balls.add({0.0f, -100.0f, 0.0f}, 99.0f);  // a cluster of its own
  for (int i = 0; i < 150 * many; ++i) balls.add(random.point(4.0f), random.uniform(0.02f, 0.1f));
  SphereSet rising;
  for (int i = 0; i < 50 * many; ++i) {
    const Vec3f from = random.point(4.0f);
    rising.addMoving(from, from + random.point(0.5f), random.uniform(0.02f, 0.1f));
  }
  BoxSet boxes;
  for (int i = 0; i < 20 * many; ++i)
    boxes.addRotatedY(random.point(4.0f), {0.1f, 0.2f, 0.05f}, random.uniform(0.0f, 90.0f));
  QuadSet walls;
  for (int i = 0; i < 40; ++i) walls.add(random.point(4.0f), {0.3f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.4f});
  const std::vector<Id> shapes{scene.addShape("balls", balls, kNone), scene.addShape("boxes", boxes, kNone),
                               scene.addShape("walls", walls, kNone), scene.addShape("rising", rising, kNone)};
  const ClusterSet all(buildClusters(scene, shapes).clusters, bestIsa()), tree = withTree(scene, shapes);
  EXPECT_GT(tree.bytes(), all.bytes());
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3f from = random.direction() * 6.0f;
    Ray<float> ray{from, normalize(random.point(4.0f) - from)};
    if (i % 3 == 0) ray.tMax = random.uniform(0.1f, 8.0f);
    if (i % 5 == 0) ray.direction.y = 0.0f;
    ray.time = random.uniform(0.0f, 0.99f);
    LeafHit expected, hit;
    all.intersect(ray, kNone, expected);
    tree.intersect(ray, kNone, hit);
    ASSERT_NO_FATAL_FAILURE(expectSame(hit, expected));
    ASSERT_EQ(tree.occluded(ray), all.occluded(ray));
    // With an earlier hit, found elsewhere.
    LeafHit before{random.uniform(1.0f, 8.0f), 0.5f, 0.5f, 2, 7, kNone}, alsoBefore = before;
    all.intersect(ray, kNone, before);
    tree.intersect(ray, kNone, alsoBefore);
    ASSERT_NO_FATAL_FAILURE(expectSame(alsoBefore, before));
    hits += hit.found();
  }
  EXPECT_GT(hits, 500 * many);
}

TEST(EmbreeTree, ChangesNoHit) {
  for (const int many : {1, 2, 10}) expectATreeChangesNoHit(many);
}

// Copies of one quad fill several clusters, in any order in which the tree is traversed.
TEST(EmbreeTree, EquallyNearHitsGoToTheSmallestId) {
  SceneDescription scene;
  std::vector<Id> shapes;
  for (int s = 0; s < 3; ++s) {
    QuadSet quads;
    for (int i = 0; i < 100; ++i) quads.add({-1.0f, -1.0f, 0.0f}, {2.0f, 0.0f, 0.1f}, {0.0f, 2.0f, 0.0f});
    shapes.push_back(scene.addShape("quads " + std::to_string(s), quads, kNone));
  }
  const ClusterSet tree = withTree(scene, shapes);
  Random random(12);
  for (int i = 0; i < 100; ++i) {
    const Vec3f from = random.direction() + Vec3f{0.0f, 0.0f, 3.0f};
    LeafHit hit;
    tree.intersect({from, normalize(Vec3f{0.0f, 0.0f, 0.05f} - from)}, kNone, hit);
    ASSERT_TRUE(hit.found());
    ASSERT_EQ(hit.shape, 0u);
    ASSERT_EQ(hit.primitive, 0u);
  }
}

}  // namespace
}  // namespace steradian::test
