#include "steradian/accel/shapes/leaf_kernels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace steradian {
namespace {

using F = Lanes<kNativeWidth>;

void nearestInCustom(const Clusters::Custom& custom, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
  const auto hit = custom.implementation->intersect(ray);
  // Someone else's code: hold it to its contract.
  if (!hit || !(hit->t > ray.tMin && hit->t < ray.tMax)) return;
  const LeafHit candidate{hit->t, hit->uv.x, hit->uv.y, custom.shape, custom.primitive, instance};
  if (candidate.t < best.t || (candidate.t == best.t && comesFirst(candidate, best))) best = candidate;
}

bool anyInCustom(const Clusters::Custom& custom, const Ray<float>& ray) {
  LeafHit hit;
  nearestInCustom(custom, ray, kNone, hit);
  return hit.found();
}

void nearestInOne(const Clusters& clusters, std::uint32_t cluster, const Ray<float>& ray, const Ray<F>& lanes,
                  std::uint32_t instance, LeafHit& best) {
  if (!clusters.visit(cluster, [&](const auto& c) { meetNearest(c, lanes, instance, best); })) {
    nearestInCustom(clusters.customOf(cluster), ray, instance, best);
  }
}
void nearestInOne(const Clusters& clusters, std::uint32_t cluster, const Ray<float>& ray, std::uint32_t instance,
                  LeafHit& best) {
  nearestInOne(clusters, cluster, ray, broadcastRay<F>(ray), instance, best);
}

bool anyInOne(const Clusters& clusters, std::uint32_t cluster, const Ray<float>& ray, const Ray<F>& lanes) {
  bool hit = false;
  if (clusters.visit(cluster, [&](const auto& c) { hit = meetAny(c, lanes); })) return hit;
  return anyInCustom(clusters.customOf(cluster), ray);
}
bool anyInOne(const Clusters& clusters, std::uint32_t cluster, const Ray<float>& ray) {
  return anyInOne(clusters, cluster, ray, broadcastRay<F>(ray));
}

/// A ray against bounds (Kay & Kajiya 1986), which are wide enough for rounding. The ray is the same in all lanes:
/// along each axis it enters all boxes on the same side.
class RayToBounds {
 public:
  using Block = Clusters::BoundsBlock;

  explicit RayToBounds(const Ray<float>& ray) : tMin_(ray.tMin), tMax_(ray.tMax) {
    const float origin[3] = {ray.origin.x, ray.origin.y, ray.origin.z};
    const float direction[3] = {ray.direction.x, ray.direction.y, ray.direction.z};
    for (int axis = 0; axis < 3; ++axis) {
      const float reciprocal = reciprocalOfComponent(direction[axis]);
      origin_[axis] = F(origin[axis]);
      reciprocal_[axis] = F(reciprocal);
      const std::size_t low = static_cast<std::size_t>(axis) * kClusterSize, high = low + 3 * kClusterSize;
      entry_[axis] = reciprocal < 0.0f ? high : low;
      exit_[axis] = reciprocal < 0.0f ? low : high;
    }
  }

  /// Calls visit(i, distance) for the boxes i of these blocks that the ray may meet, no nearer than `distance`; until
  /// it returns false, and then returns false.
  template <class Visit>
  bool forEachMet(std::span<const Block> blocks, const Visit& visit) const {
    std::uint32_t first = 0;
    for (const Block& block : blocks) {
      float distance[kClusterSize];
      std::uint32_t met = 0;
      for (int i = 0; i < kClusterSize; i += kNativeWidth) {
        const float* in = &block.side[0][0][i];
        const F near =
            maximum(maximum(reach(in, 0, entry_[0]), reach(in, 1, entry_[1])), maximum(reach(in, 2, entry_[2]), tMin_));
        const F far =
            minimum(minimum(reach(in, 0, exit_[0]), reach(in, 1, exit_[1])), minimum(reach(in, 2, exit_[2]), tMax_));
        met |= laneBits(near <= far) << i;
        store(distance + i, near);
      }
      for (; met != 0; met &= met - 1) {
        const auto i = static_cast<std::uint32_t>(std::countr_zero(met));
        if (!visit(first + i, distance[i])) return false;
      }
      first += kClusterSize;
    }
    return true;
  }

 private:
  F reach(const float* in, int axis, std::size_t plane) const {
    return (load<F>(in + plane) - origin_[axis]) * reciprocal_[axis];
  }

  F origin_[3], reciprocal_[3], tMin_, tMax_;
  std::size_t entry_[3], exit_[3];  ///< where in a block the planes are that the ray enters and leaves boxes by
};

/// Boxes that a ray may meet, the nearest first.
class ByDistance {
 public:
  bool full() const { return count_ == kMost; }
  void add(std::uint32_t box, float distance) {
    std::size_t place = count_++;
    for (; place > 0 && boxes_[place - 1].distance > distance; --place) boxes_[place] = boxes_[place - 1];
    boxes_[place] = {distance, box};
  }
  /// Calls visit(box) for those no further than best.t, which may shrink on the way, and forgets all.
  template <class Visit>
  void visit(const LeafHit& best, const Visit& visit) {
    for (std::size_t i = 0; i < count_ && boxes_[i].distance <= best.t; ++i) visit(boxes_[i].box);
    count_ = 0;
  }

 private:
  struct Box {
    float distance;
    std::uint32_t box;
  };
  static constexpr std::size_t kMost = 64;
  std::array<Box, kMost> boxes_;
  std::size_t count_ = 0;
};

/// Of the boxes in blocks, the nearest ones first, until there is a hit before all others.
template <class Visit>
void forEachByDistance(const RayToBounds& ray, std::span<const Clusters::BoundsBlock> blocks, const LeafHit& best,
                       const Visit& visit) {
  ByDistance met;
  ray.forEachMet(blocks, [&](std::uint32_t box, float distance) {
    if (distance > best.t) return true;
    if (met.full()) met.visit(best, visit);
    met.add(box, distance);
    return true;
  });
  met.visit(best, visit);
}

std::span<const Clusters::BoundsBlock> boundsIn(const Clusters& clusters, std::uint32_t block) {
  return {&clusters.bounds[block], 1};
}

void nearestInMet(const Clusters& clusters, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
  const Ray<F> lanes = broadcastRay<F>(ray);
  const RayToBounds toBounds(ray);
  const auto meet = [&](std::uint32_t first, std::span<const Clusters::BoundsBlock> bounds) {
    forEachByDistance(toBounds, bounds, best,
                      [&](std::uint32_t i) { nearestInOne(clusters, first + i, ray, lanes, instance, best); });
  };
  if (clusters.boundsOfBlocks.empty()) return meet(0, clusters.bounds);
  forEachByDistance(toBounds, clusters.boundsOfBlocks, best,
                    [&](std::uint32_t block) { meet(block * kClusterSize, boundsIn(clusters, block)); });
}

bool anyInMet(const Clusters& clusters, const Ray<float>& ray) {
  const Ray<F> lanes = broadcastRay<F>(ray);
  const RayToBounds toBounds(ray);
  const auto misses = [&](std::uint32_t first, std::span<const Clusters::BoundsBlock> bounds) {
    return toBounds.forEachMet(bounds,
                               [&](std::uint32_t i, float) { return !anyInOne(clusters, first + i, ray, lanes); });
  };
  if (clusters.boundsOfBlocks.empty()) return !misses(0, clusters.bounds);
  return !toBounds.forEachMet(clusters.boundsOfBlocks, [&](std::uint32_t block, float) {
    return misses(block * kClusterSize, boundsIn(clusters, block));
  });
}

void nearestInAll(const Clusters& clusters, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
  if (!clusters.bounds.empty()) return nearestInMet(clusters, ray, instance, best);
  const Ray<F> lanes = broadcastRay<F>(ray);
  std::apply(
      [&](const auto&... kind) {
        const auto meetAll = [&](const auto& ofKind) {
          for (const auto& cluster : ofKind) meetNearest(cluster, lanes, instance, best);
        };
        (meetAll(kind), ...);
      },
      clusters.kinds);
  for (const Clusters::Custom& custom : clusters.custom) nearestInCustom(custom, ray, instance, best);
}

bool anyInAll(const Clusters& clusters, const Ray<float>& ray) {
  if (!clusters.bounds.empty()) return anyInMet(clusters, ray);
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
constinit const LeafKernels leafKernels{nearestInOne, nearestInAll, anyInOne, anyInAll};
}

}  // namespace steradian
