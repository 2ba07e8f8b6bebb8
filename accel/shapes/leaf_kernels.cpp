#include "steradian/accel/shapes/leaf_kernels.h"

#include <algorithm>
#include <array>
#include <bit>

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

/// Calls visit(first, met, distance) for the clusters first, first + 1, ... in lanes of which the ray may meet some:
/// those in the mask, no nearer than `distance` (Kay & Kajiya 1986). The bounds are wide enough for rounding.
template <class Visit>
void forEachMet(const Clusters& clusters, const Ray<F>& ray, const Visit& visit) {
  const F rx = reciprocalOfComponent(ray.direction.x), ry = reciprocalOfComponent(ray.direction.y),
          rz = reciprocalOfComponent(ray.direction.z);
  std::uint32_t first = 0;
  for (const Clusters::BoundsBlock& block : clusters.bounds) {
    for (int i = 0; i < kClusterSize; i += kNativeWidth, first += kNativeWidth) {
      const F lowX = (load<F>(block.lowX + i) - ray.origin.x) * rx,
              highX = (load<F>(block.highX + i) - ray.origin.x) * rx;
      const F lowY = (load<F>(block.lowY + i) - ray.origin.y) * ry,
              highY = (load<F>(block.highY + i) - ray.origin.y) * ry;
      const F lowZ = (load<F>(block.lowZ + i) - ray.origin.z) * rz,
              highZ = (load<F>(block.highZ + i) - ray.origin.z) * rz;
      const F near =
          maximum(maximum(minimum(lowX, highX), minimum(lowY, highY)), maximum(minimum(lowZ, highZ), ray.tMin));
      const F far =
          minimum(minimum(maximum(lowX, highX), maximum(lowY, highY)), minimum(maximum(lowZ, highZ), ray.tMax));
      std::uint32_t met = laneBits(near <= far);
      const std::uint32_t left = clusters.end.back() - first;
      if (left < kNativeWidth) met &= (1u << left) - 1u;
      if (met != 0 && !visit(first, met, near)) return;
      if (left <= kNativeWidth) return;
    }
  }
}

/// Of the clusters that the ray may meet, the nearest ones first, until one has a hit before all others.
void nearestInMet(const Clusters& clusters, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
  const Ray<F> lanes = broadcastRay<F>(ray);
  struct Candidate {
    float distance;
    std::uint32_t cluster;
  };
  constexpr std::size_t most = 64;
  std::array<Candidate, most> candidates;  // by distance
  std::size_t count = 0;
  const auto meet = [&] {
    for (std::size_t i = 0; i < count && candidates[i].distance <= best.t; ++i) {
      nearestInOne(clusters, candidates[i].cluster, ray, lanes, instance, best);
    }
    count = 0;
  };
  forEachMet(clusters, lanes, [&](std::uint32_t first, std::uint32_t met, F near) {
    float distance[kNativeWidth];
    store(distance, near);
    for (; met != 0; met &= met - 1) {
      const int i = std::countr_zero(met);
      if (distance[i] > best.t) continue;
      if (count == most) meet();
      std::size_t place = count++;
      for (; place > 0 && candidates[place - 1].distance > distance[i]; --place)
        candidates[place] = candidates[place - 1];
      candidates[place] = {distance[i], first + static_cast<std::uint32_t>(i)};
    }
    return true;
  });
  meet();
}

bool anyInMet(const Clusters& clusters, const Ray<float>& ray) {
  const Ray<F> lanes = broadcastRay<F>(ray);
  bool hit = false;
  forEachMet(clusters, lanes, [&](std::uint32_t first, std::uint32_t met, F) {
    for (; met != 0 && !hit; met &= met - 1) {
      hit = anyInOne(clusters, first + static_cast<std::uint32_t>(std::countr_zero(met)), ray, lanes);
    }
    return !hit;
  });
  return hit;
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
