#include "steradian/accel/shapes/clusters/leaf_kernels.h"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

namespace steradian {
namespace {

using F = LeafLanes;

void nearestInCustom(const Clusters::Custom& custom, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
  const auto hit = custom.implementation->intersect(ray);
  // Someone else's code: hold it to its contract.
  if (!hit || !(hit->t > ray.tMin && hit->t < ray.tMax)) return;
  const LeafHit candidate{hit->t, hit->uv.x, hit->uv.y, custom.shape, custom.primitive, instance, kNone};
  keepFirst(candidate, best);
}

bool anyInCustom(const Clusters::Custom& custom, const Ray<float>& ray) {
  LeafHit hit;
  nearestInCustom(custom, ray, kNone, hit);
  return hit.found();
}

void nearestInOne(const Clusters& clusters, std::uint32_t cluster, const Ray<float>& ray, const Ray<F>& lanes,
                  std::uint32_t instance, LeafHit& best) {
  if (!clusters.visit(cluster, [&](const auto& c) { meetNearest(c, cluster, lanes, instance, best); })) {
    nearestInCustom(clusters.customOf(cluster), ray, instance, best);
  }
}
bool anyInOne(const Clusters& clusters, std::uint32_t cluster, const Ray<float>& ray, const Ray<F>& lanes) {
  bool hit = false;
  if (clusters.visit(cluster, [&](const auto& c) { hit = meetAny(c, lanes); })) return hit;
  return anyInCustom(clusters.customOf(cluster), ray);
}

/// A ray against the bounds of a node's children (Kay & Kajiya 1986), which are wide enough for rounding. The ray is
/// the same in all lanes: along each axis it enters all boxes on the same side.
class RayToNode {
 public:
  explicit RayToNode(const Ray<float>& ray) : tMin_(ray.tMin), tMax_(ray.tMax) {
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
  /// Bounds beyond t are not met any more; those that begin there are.
  void shorten(float t) { tMax_ = L(t); }

  /// The children whose bounds the ray meets, as bits, and from what distance on.
  struct Met {
    std::uint32_t children;
    float distance[ClusterTree::kWidth];
  };
  Met meet(const ClusterTree::Node& node) const {
    const float* in = &node.side[0][0][0];
    const L near =
        maximum(maximum(reach(in, 0, entry_[0]), reach(in, 1, entry_[1])), maximum(reach(in, 2, entry_[2]), tMin_));
    const L far =
        minimum(minimum(reach(in, 0, exit_[0]), reach(in, 1, exit_[1])), minimum(reach(in, 2, exit_[2]), tMax_));
    Met met;
    met.children = laneBits(near <= far);
    store(met.distance, near);
    return met;
  }

 private:
  using L = Lanes<static_cast<int>(ClusterTree::kWidth)>;

  L reach(const float* in, int axis, std::size_t plane) const {
    return (load<L>(in + plane) - origin_[axis]) * reciprocal_[axis];
  }

  L origin_[3], reciprocal_[3], tMin_, tMax_;
  std::size_t entry_[3], exit_[3];  ///< where in a node the planes are that the ray enters and leaves bounds by
};

std::uint32_t takeLowest(std::uint32_t& bits) {
  const auto i = static_cast<std::uint32_t>(std::countr_zero(bits));
  bits &= bits - 1;
  return i;
}

/// Most that can wait: of each node on the way down all children but one.
constexpr std::size_t kStackSize = ClusterTree::kMaxDepth * (ClusterTree::kWidth - 1);

/// Where a ray still has to go, the nearest on top.
class WayByDistance {
 public:
  /// Down from a child to the nearest leaf whose bounds the ray meets on the way, or to nothing. What lies aside waits.
  std::optional<std::uint32_t> descend(const ClusterTree& tree, std::uint32_t child, const RayToNode& ray) {
    while (!(child & ClusterTree::kLeaf)) {
      const ClusterTree::Node& node = tree.nodes[child];
      const RayToNode::Met met = ray.meet(node);
      if (met.children == 0) return std::nullopt;
      child = nearestOf(node, met);
    }
    return child & ~ClusterTree::kLeaf;
  }
  /// The nearest that waits and does not begin beyond `t`.
  std::optional<std::uint32_t> next(float t) {
    while (top_ != stops_) {
      --top_;
      if (top_->distance <= t) return top_->child;
    }
    return std::nullopt;
  }

 private:
  struct Stop {
    float distance;
    std::uint32_t child;
  };

  /// Of children that are met, of which there are some; the others wait.
  std::uint32_t nearestOf(const ClusterTree::Node& node, const RayToNode::Met& met) {
    std::uint32_t left = met.children;
    const std::uint32_t first = takeLowest(left);
    if (left == 0) return node.child[first];
    const std::uint32_t second = takeLowest(left);
    // Either may be the nearer one: no branch could be foretold.
    const std::uint32_t near = met.distance[first] < met.distance[second] ? first : second;
    const std::uint32_t far = first + second - near;
    Stop nearest{met.distance[near], node.child[near]};
    const Stop* const below = top_;
    *top_++ = {met.distance[far], node.child[far]};
    while (left != 0) {
      const std::uint32_t i = takeLowest(left);
      Stop stop{met.distance[i], node.child[i]};
      if (stop.distance < nearest.distance) std::swap(stop, nearest);
      Stop* place = top_++;
      for (; place > below && place[-1].distance < stop.distance; --place) *place = place[-1];
      *place = stop;
    }
    return nearest.child;
  }

  Stop stops_[kStackSize];
  Stop* top_ = stops_;
};

void nearestInTree(const Clusters& clusters, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
  const Ray<F> lanes = broadcastRay<F>(ray);
  RayToNode toNode(ray);
  if (best.found()) toNode.shorten(best.t);
  WayByDistance way;
  for (std::optional<std::uint32_t> child = 0u; child; child = way.next(best.t)) {
    const std::optional<std::uint32_t> cluster = way.descend(clusters.tree, *child, toNode);
    if (!cluster) continue;
    const float before = best.t;
    nearestInOne(clusters, *cluster, ray, lanes, instance, best);
    if (best.t < before) toNode.shorten(best.t);
  }
}

bool anyInTree(const Clusters& clusters, const Ray<float>& ray) {
  const Ray<F> lanes = broadcastRay<F>(ray);
  const RayToNode toNode(ray);
  std::uint32_t stops[kStackSize + 1];
  std::uint32_t* top = stops;
  *top++ = 0;
  while (top != stops) {
    const std::uint32_t child = *--top;
    if (child & ClusterTree::kLeaf) {
      if (anyInOne(clusters, child & ~ClusterTree::kLeaf, ray, lanes)) return true;
      continue;
    }
    const ClusterTree::Node& node = clusters.tree.nodes[child];
    for (RayToNode::Met met = toNode.meet(node); met.children != 0;) *top++ = node.child[takeLowest(met.children)];
  }
  return false;
}

void nearest(const Clusters& clusters, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
  if (!clusters.tree.nodes.empty()) return nearestInTree(clusters, ray, instance, best);
  const Ray<F> lanes = broadcastRay<F>(ray);
  std::apply(
      [&](const auto&... kind) {
        std::uint32_t number = 0;
        const auto meetAll = [&](const auto& ofKind) {
          for (const auto& cluster : ofKind) meetNearest(cluster, number++, lanes, instance, best);
        };
        (meetAll(kind), ...);
      },
      clusters.kinds);
  for (const Clusters::Custom& custom : clusters.custom) nearestInCustom(custom, ray, instance, best);
}

bool any(const Clusters& clusters, const Ray<float>& ray) {
  if (!clusters.tree.nodes.empty()) return anyInTree(clusters, ray);
  const Ray<F> lanes = broadcastRay<F>(ray);
  const auto meetsAny = [&](const auto& ofKind) {
    return std::any_of(ofKind.begin(), ofKind.end(), [&](const auto& cluster) { return meetAny(cluster, lanes); });
  };
  return std::apply([&](const auto&... kind) { return (meetsAny(kind) || ...); }, clusters.kinds) ||
         std::any_of(clusters.custom.begin(), clusters.custom.end(),
                     [&](const Clusters::Custom& custom) { return anyInCustom(custom, ray); });
}

}  // namespace

namespace STERADIAN_ISA {
constinit const LeafKernels leafKernels{nearest, any};
}

}  // namespace steradian
