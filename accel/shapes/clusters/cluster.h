#pragma once
/// Clusters: up to 8 primitives of one kind, laid out for one ray against all of them.
///
/// A cluster is the leaf of our hierarchies. Its lanes are ordered by (shape, primitive), so that of equally near hits
/// the one in the lowest lane is reported; unused lanes hold NaN, which is never hit.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <limits>

#include "steradian/accel/shapes/clusters/leaf.h"
#include "steradian/core/transport/surface_point.h"

namespace STERADIAN_API steradian {

/// Primitives of a cluster that are tested against a ray at once.
using LeafLanes = Lanes<std::min(kNativeWidth, kClusterSize)>;

/// The nearest hit so far of one ray, and which primitive it is on.
struct LeafHit {
  float t = kInfinity;
  float u = 0.0f, v = 0.0f;
  std::uint32_t shape = kNone, primitive = kNone, instance = kNone;
  std::uint32_t place = kNone;  ///< cluster * kClusterSize + lane; kNone for what is in no cluster

  bool found() const { return shape != kNone; }
};

template <class Leaf>
struct alignas(64) Cluster {
  ClusterRow row[Leaf::rows];
  std::uint32_t shape[kClusterSize];      ///< index into SceneDescription::shapes; kNone: unused lane
  std::uint32_t primitive[kClusterSize];  ///< index inside that shape's set

  Cluster() {
    for (auto& values : row) std::fill(std::begin(values), std::end(values), std::numeric_limits<float>::quiet_NaN());
    std::fill(std::begin(shape), std::end(shape), kNone);
    std::fill(std::begin(primitive), std::end(primitive), kNone);
  }
  void put(int i, const typename Leaf::Shape& value, std::uint32_t shapeId, std::uint32_t primitiveId) {
    Leaf::put(row, i, value);
    shape[i] = shapeId;
    primitive[i] = primitiveId;
  }
};

/// One ray in every lane.
template <class F>
Ray<F> broadcastRay(const Ray<float>& ray) {
  return {broadcast<F>(ray.origin), broadcast<F>(ray.direction), F(ray.tMax), F(ray.time), F(ray.tMin)};
}

/// The order of hits at equal distance: by shape, then primitive, then instance. The first is reported.
inline bool comesFirst(const LeafHit& a, const LeafHit& b) {
  if (a.shape != b.shape) return a.shape < b.shape;
  return a.primitive != b.primitive ? a.primitive < b.primitive : a.instance < b.instance;
}

/// Updates `best` if the candidate is a hit and nearer, or equally near and comes first.
inline void keepFirst(const LeafHit& candidate, LeafHit& best) {
  if (candidate.found() && (candidate.t < best.t || (candidate.t == best.t && comesFirst(candidate, best))))
    best = candidate;
}
/// The tMax with which a query still finds hits at t, which is > 0.
inline float justBeyond(float t) { return floatOf(bitsOf(t) + 1u); }

/// Updates `best` if the cluster has a nearer hit, or an equally near one of smaller id. `instance` is the one that
/// holds the cluster, or kNone; `number` the cluster's. The kernel tests against ray.tMax, not best.t, so that
/// successive kernels do not wait for each other's results: 10 to 40 % faster.
template <class Leaf, class F>
void intersectCluster(const Cluster<Leaf>& cluster, std::uint32_t number, const Ray<F>& ray, std::uint32_t instance,
                      LeafHit& best) {
  constexpr int width = widthOf<F>;
  static_assert(width <= kClusterSize);
  for (int first = 0; first < kClusterSize; first += width) {
    if (cluster.shape[first] == kNone) break;
    const ShapeHit<F> hit = Leaf::intersect(cluster.row, first, ray);
    std::uint32_t hits = laneBits(hit.valid);
    if (hits == 0) continue;
    float t[width], u[width], v[width];
    store(t, hit.t);
    store(u, hit.u);
    store(v, hit.v);
    // Few lanes are hit: a loop over them beats a reduction of the vector (measured).
    int nearest = std::countr_zero(hits);
    for (hits &= hits - 1; hits != 0; hits &= hits - 1) {
      const int i = std::countr_zero(hits);
      nearest = t[i] < t[nearest] ? i : nearest;
    }
    if (t[nearest] > best.t) continue;
    const auto i = static_cast<std::uint32_t>(first + nearest);
    const LeafHit candidate{t[nearest],
                            u[nearest],
                            v[nearest],
                            cluster.shape[i],
                            cluster.primitive[i],
                            instance,
                            number * kClusterSize + i};
    if (candidate.t < best.t || comesFirst(candidate, best)) best = candidate;
  }
}

/// Is anything hit at all?
template <class Leaf, class F>
bool clusterOccludes(const Cluster<Leaf>& cluster, const Ray<F>& ray) {
  static_assert(widthOf<F> <= kClusterSize);
  MaskOf<F> hit(false);
  for (int i = 0; i < kClusterSize; i += widthOf<F>) {
    if (cluster.shape[i] == kNone) break;
    hit |= Leaf::intersect(cluster.row, i, ray).valid;
  }
  return any(hit);
}

}  // namespace steradian
