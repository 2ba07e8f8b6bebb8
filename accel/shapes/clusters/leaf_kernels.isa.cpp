#include "steradian/accel/shapes/clusters/leaf_kernels.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

namespace steradian {
namespace {

using F = LeafLanes;

void intersectCluster(const Clusters& clusters, std::uint32_t cluster, const Ray<F>& lanes, std::uint32_t instance,
                      LeafHit& best) {
  clusters.visit(cluster, [&](const auto& c) { steradian::intersectCluster(c, cluster, lanes, instance, best); });
}
bool clusterOccludes(const Clusters& clusters, std::uint32_t cluster, const Ray<F>& lanes) {
  bool hit = false;
  clusters.visit(cluster, [&](const auto& c) { hit = steradian::clusterOccludes(c, lanes); });
  return hit;
}

/// A ray against the bounds of a node's children (Kay & Kajiya 1986), which are wide enough for rounding. The ray is
/// the same in all lanes: along each axis it enters all boxes on the same side.
class NodeIntersector {
 public:
  explicit NodeIntersector(const Ray<float>& ray) : tMin_(ray.tMin), tMax_(ray.tMax) {
    const float origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const float direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    for (int axis = 0; axis < 3; ++axis) {
      const float reciprocal = reciprocalOfComponent(direction[axis]);
      origin_[axis] = L(origin[axis]);
      reciprocal_[axis] = L(reciprocal);
      const std::size_t low = static_cast<std::size_t>(axis) * ClusterTree::kWidth,
                        high = low + 3 * ClusterTree::kWidth;
      entry_[axis] = reciprocal < 0.0f ? high : low;
      exit_[axis] = reciprocal < 0.0f ? low : high;
    }
  }
  /// Shortens the ray to t: bounds that begin beyond t are no longer hit, those that begin at t are.
  void shorten(float t) { tMax_ = L(t); }

  /// The children whose bounds the ray hits, as bits, and from what distance on.
  struct Hits {
    std::uint32_t children;
    float distance[ClusterTree::kWidth];
  };
  Hits intersect(const ClusterTree::Node& node) const {
    const float* in = &node.side[0][0][0];
    const L near =
        maximum(maximum(reach(in, 0, entry_[0]), reach(in, 1, entry_[1])), maximum(reach(in, 2, entry_[2]), tMin_));
    const L far =
        minimum(minimum(reach(in, 0, exit_[0]), reach(in, 1, exit_[1])), minimum(reach(in, 2, exit_[2]), tMax_));
    Hits hits;
    hits.children = laneBits(near <= far);
    store(hits.distance, near);
    return hits;
  }

 private:
  using L = Lanes<static_cast<int>(ClusterTree::kWidth)>;

  L reach(const float* in, int axis, std::size_t plane) const {
    return (load<L>(in + plane) - origin_[axis]) * reciprocal_[axis];
  }

  L origin_[3], reciprocal_[3], tMin_, tMax_;
  std::size_t entry_[3], exit_[3];  ///< offsets in a node of the planes by which the ray enters and leaves bounds
};

std::uint32_t takeLowest(std::uint32_t& bits) {
  const auto i = static_cast<std::uint32_t>(std::countr_zero(bits));
  bits &= bits - 1;
  return i;
}

/// The largest number of entries: all children but one of each node on the way down.
constexpr std::size_t kStackSize = ClusterTree::kMaxDepth * (ClusterTree::kWidth - 1);

/// The nodes and clusters that a ray still has to visit, the nearest on top.
class TraversalStack {
 public:
  /// Down from a child to the nearest leaf whose bounds the ray hits on the way, or to nothing. The other children on
  /// the way are pushed.
  std::optional<std::uint32_t> descend(const ClusterTree& tree, std::uint32_t child, const NodeIntersector& ray) {
    while (!(child & ClusterTree::kLeaf)) {
      const ClusterTree::Node& node = tree.nodes[child];
      const NodeIntersector::Hits hits = ray.intersect(node);
      if (hits.children == 0) return std::nullopt;
      child = nearestOf(node, hits);
    }
    return child & ~ClusterTree::kLeaf;
  }
  /// Pops the nearest entry that does not begin beyond `t`.
  std::optional<std::uint32_t> next(float t) {
    while (top_ != entries_) {
      --top_;
      if (top_->distance <= t) return top_->child;
    }
    return std::nullopt;
  }

 private:
  struct Entry {
    float distance;
    std::uint32_t child;
  };

  /// The nearest of the children that are hit, of which there are some; the others are pushed.
  std::uint32_t nearestOf(const ClusterTree::Node& node, const NodeIntersector::Hits& hits) {
    std::uint32_t left = hits.children;
    const std::uint32_t first = takeLowest(left);
    if (left == 0) return node.child[first];
    const std::uint32_t second = takeLowest(left);
    // Which one is nearer is unpredictable: no branch.
    const std::uint32_t near = hits.distance[first] < hits.distance[second] ? first : second;
    const std::uint32_t far = first + second - near;
    Entry nearest{hits.distance[near], node.child[near]};
    const Entry* const below = top_;
    *top_++ = {hits.distance[far], node.child[far]};
    while (left != 0) {
      const std::uint32_t i = takeLowest(left);
      Entry entry{hits.distance[i], node.child[i]};
      if (entry.distance < nearest.distance) std::swap(entry, nearest);
      Entry* place = top_++;
      for (; place > below && place[-1].distance < entry.distance; --place) *place = place[-1];
      *place = entry;
    }
    return nearest.child;
  }

  Entry entries_[kStackSize];
  Entry* top_ = entries_;
};

void intersectTree(const Clusters& clusters, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
  const Ray<F> lanes = broadcastRay<F>(ray);
  NodeIntersector nodes(ray);
  if (best.found()) nodes.shorten(best.t);
  TraversalStack stack;
  for (std::optional<std::uint32_t> child = 0u; child; child = stack.next(best.t)) {
    const std::optional<std::uint32_t> cluster = stack.descend(clusters.tree, *child, nodes);
    if (!cluster) continue;
    const float before = best.t;
    intersectCluster(clusters, *cluster, lanes, instance, best);
    if (best.t < before) nodes.shorten(best.t);
  }
}

bool treeOccludes(const Clusters& clusters, const Ray<float>& ray) {
  const Ray<F> lanes = broadcastRay<F>(ray);
  const NodeIntersector nodes(ray);
  std::uint32_t entries[kStackSize + 1];
  std::uint32_t* top = entries;
  *top++ = 0;
  while (top != entries) {
    const std::uint32_t child = *--top;
    if (child & ClusterTree::kLeaf) {
      if (clusterOccludes(clusters, child & ~ClusterTree::kLeaf, lanes)) return true;
      continue;
    }
    const ClusterTree::Node& node = clusters.tree.nodes[child];
    for (NodeIntersector::Hits hits = nodes.intersect(node); hits.children != 0;)
      *top++ = node.child[takeLowest(hits.children)];
  }
  return false;
}

void intersect(const Clusters& clusters, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
  if (!clusters.tree.nodes.empty()) return intersectTree(clusters, ray, instance, best);
  const Ray<F> lanes = broadcastRay<F>(ray);
  std::apply(
      [&](const auto&... kind) {
        std::uint32_t number = 0;
        const auto intersectAll = [&](const auto& ofKind) {
          for (const auto& cluster : ofKind) intersectCluster(cluster, number++, lanes, instance, best);
        };
        (intersectAll(kind), ...);
      },
      clusters.kinds);
}

bool occluded(const Clusters& clusters, const Ray<float>& ray) {
  if (!clusters.tree.nodes.empty()) return treeOccludes(clusters, ray);
  const Ray<F> lanes = broadcastRay<F>(ray);
  const auto anyOccludes = [&](const auto& ofKind) {
    return std::any_of(ofKind.begin(), ofKind.end(),
                       [&](const auto& cluster) { return clusterOccludes(cluster, lanes); });
  };
  return std::apply([&](const auto&... kind) { return (anyOccludes(kind) || ...); }, clusters.kinds);
}

void intersectOne(const Clusters& clusters, std::uint32_t cluster, const Ray<float>& ray, std::uint32_t instance,
                  LeafHit& best) {
  intersectCluster(clusters, cluster, broadcastRay<F>(ray), instance, best);
}
bool occludedByOne(const Clusters& clusters, std::uint32_t cluster, const Ray<float>& ray) {
  return clusterOccludes(clusters, cluster, broadcastRay<F>(ray));
}

}  // namespace

namespace STERADIAN_ISA {
constinit const LeafKernels leafKernels{intersect, occluded, intersectOne, occludedByOne};
}

}  // namespace steradian
