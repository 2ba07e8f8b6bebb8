#include "steradian/accel/shapes/leaf_kernels.h"

#include <algorithm>

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

void nearestInOne(const Clusters& clusters, std::uint32_t cluster, const Ray<float>& ray, std::uint32_t instance,
                  LeafHit& best) {
  if (!clusters.visit(cluster, [&](const auto& c) { meetNearest(c, broadcastRay<F>(ray), instance, best); })) {
    nearestInCustom(clusters.customOf(cluster), ray, instance, best);
  }
}

void nearestInAll(const Clusters& clusters, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
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

bool anyInOne(const Clusters& clusters, std::uint32_t cluster, const Ray<float>& ray) {
  bool hit = false;
  if (clusters.visit(cluster, [&](const auto& c) { hit = meetAny(c, broadcastRay<F>(ray)); })) return hit;
  return anyInCustom(clusters.customOf(cluster), ray);
}

bool anyInAll(const Clusters& clusters, const Ray<float>& ray) {
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
