#pragma once
/// Clusters: up to 8 primitives of one kind, laid out for one ray against all of them.
///
/// A cluster is the leaf of our hierarchies. Its lanes are ordered by (shape, primitive), so that the lowest lane among
/// equally near hits is the one that wins; unused lanes hold NaN, which is never hit.
#include <algorithm>
#include <bit>
#include <cstdint>
#include <iterator>
#include <limits>

#include "steradian/accel/shapes/primitives/aligned_quad.h"
#include "steradian/accel/shapes/primitives/box.h"
#include "steradian/accel/shapes/primitives/disk.h"
#include "steradian/accel/shapes/primitives/moving_sphere.h"
#include "steradian/accel/shapes/primitives/quad.h"
#include "steradian/accel/shapes/primitives/sphere.h"
#include "steradian/accel/shapes/primitives/triangle.h"
#include "steradian/core/transport/surface_point.h"

namespace STERADIAN_API steradian {

inline constexpr int kClusterSize = 8;
/// Primitives of a cluster that one ray meets at once.
using LeafLanes = Lanes<std::min(kNativeWidth, kClusterSize)>;

/// The nearest hit so far of one ray, and who it is.
struct LeafHit {
  float t = kInfinity;
  float u = 0.0f, v = 0.0f;
  std::uint32_t shape = kNone, primitive = kNone, instance = kNone;
  std::uint32_t place = kNone;  ///< cluster * kClusterSize + lane; of custom shapes kNone

  bool found() const { return shape != kNone; }
};

/// Rows of a cluster: one float of each primitive side by side.
using ClusterRow = float[kClusterSize];

// --- Leaf kinds: how a primitive is kept in the rows, and met -----------------------------------------------------

struct SphereLeaf {
  static constexpr int rows = 4;
  using Shape = Sphere<float>;

  static void put(ClusterRow* to, int i, const Shape& s) {
    const float values[rows] = {s.center.x, s.center.y, s.center.z, s.radius};
    for (int r = 0; r < rows; ++r) to[r][i] = values[r];
  }
  static Shape get(const ClusterRow* c, int i) { return {{c[0][i], c[1][i], c[2][i]}, c[3][i]}; }
  template <class F>
  static ShapeHit<F> meet(const ClusterRow* c, int i, const Ray<F>& ray) {
    const Sphere<F> sphere{{load<F>(c[0] + i), load<F>(c[1] + i), load<F>(c[2] + i)}, load<F>(c[3] + i)};
    return intersect(sphere, ray);
  }
};

struct MovingSphereLeaf {
  static constexpr int rows = 7;
  using Shape = MovingSphere<float>;

  static void put(ClusterRow* to, int i, const Shape& s) {
    const float values[rows] = {s.center.x, s.center.y, s.center.z, s.move.x, s.move.y, s.move.z, s.radius};
    for (int r = 0; r < rows; ++r) to[r][i] = values[r];
  }
  static Shape get(const ClusterRow* c, int i) {
    return {{c[0][i], c[1][i], c[2][i]}, {c[3][i], c[4][i], c[5][i]}, c[6][i]};
  }
  template <class F>
  static ShapeHit<F> meet(const ClusterRow* c, int i, const Ray<F>& ray) {
    const MovingSphere<F> sphere{{load<F>(c[0] + i), load<F>(c[1] + i), load<F>(c[2] + i)},
                                 {load<F>(c[3] + i), load<F>(c[4] + i), load<F>(c[5] + i)},
                                 load<F>(c[6] + i)};
    return intersect(sphere, ray);
  }
};

struct QuadLeaf {
  static constexpr int rows = 9;
  using Shape = Quad<float>;

  static void put(ClusterRow* to, int i, const Shape& q) {
    const float values[rows] = {q.corner.x, q.corner.y, q.corner.z, q.u.x, q.u.y, q.u.z, q.v.x, q.v.y, q.v.z};
    for (int r = 0; r < rows; ++r) to[r][i] = values[r];
  }
  static Shape get(const ClusterRow* c, int i) {
    return {{c[0][i], c[1][i], c[2][i]}, {c[3][i], c[4][i], c[5][i]}, {c[6][i], c[7][i], c[8][i]}};
  }
  template <class F>
  static ShapeHit<F> meet(const ClusterRow* c, int i, const Ray<F>& ray) {
    const Quad<F> quad{{load<F>(c[0] + i), load<F>(c[1] + i), load<F>(c[2] + i)},
                       {load<F>(c[3] + i), load<F>(c[4] + i), load<F>(c[5] + i)},
                       {load<F>(c[6] + i), load<F>(c[7] + i), load<F>(c[8] + i)}};
    return intersect(quad, ray);
  }
};

struct AlignedQuadLeaf {
  static constexpr int rows = 6;  ///< corner and edges of AlignedQuad, and which axes: 2 * that of the normal + 1 if v
                                  ///< lies along the next one after it
  using Shape = AlignedQuad;

  static void put(ClusterRow* to, int i, const Shape& q) {
    const int code = 2 * q.axis[2] + (q.axis[1] == (q.axis[2] + 1) % 3 ? 1 : 0);
    const float values[rows] = {q.corner[0], q.corner[1], q.corner[2], q.edge[0], q.edge[1], static_cast<float>(code)};
    for (int r = 0; r < rows; ++r) to[r][i] = values[r];
  }
  static Shape get(const ClusterRow* c, int i) {
    const int code = static_cast<int>(c[5][i]), normal = code / 2, next = (normal + 1) % 3, last = (normal + 2) % 3;
    const bool swapped = code % 2 != 0;
    return {{swapped ? last : next, swapped ? next : last, normal},
            {c[0][i], c[1][i], c[2][i]},
            {c[3][i], c[4][i]},
            {1.0f / c[3][i], 1.0f / c[4][i]}};
  }
  template <class F>
  static ShapeHit<F> meet(const ClusterRow* c, int i, const Ray<F>& ray) {
    const F code = load<F>(c[5] + i), one(1.0f);
    const MaskOf<F> isX = code < F(2.0f), isY = (code >= F(2.0f)) & (code < F(4.0f));
    const MaskOf<F> swapped = (code == F(1.0f)) | (code == F(3.0f)) | (code == F(5.0f));
    // The components of a vector along u, v and the normal.
    const auto along = [&](const Vec3<F>& v) {
      const F next = select(isX, v.y, select(isY, v.z, v.x)), last = select(isX, v.z, select(isY, v.x, v.y));
      return std::array<F, 3>{select(swapped, last, next), select(swapped, next, last),
                              select(isX, v.x, select(isY, v.y, v.z))};
    };
    const std::array<F, 3> d = along(ray.direction);
    return crossAlignedQuad<F>({load<F>(c[0] + i), load<F>(c[1] + i), load<F>(c[2] + i)},
                               {one / load<F>(c[3] + i), one / load<F>(c[4] + i)}, along(ray.origin), {d[0], d[1]},
                               reciprocalOfComponent(d[2]), ray.tMin, ray.tMax);
  }
};

struct DiskLeaf {
  static constexpr int rows = 7;
  using Shape = Disk<float>;

  static void put(ClusterRow* to, int i, const Shape& d) {
    const float values[rows] = {d.center.x, d.center.y, d.center.z, d.normal.x, d.normal.y, d.normal.z, d.radius};
    for (int r = 0; r < rows; ++r) to[r][i] = values[r];
  }
  static Shape get(const ClusterRow* c, int i) {
    return {{c[0][i], c[1][i], c[2][i]}, {c[3][i], c[4][i], c[5][i]}, c[6][i]};
  }
  template <class F>
  static ShapeHit<F> meet(const ClusterRow* c, int i, const Ray<F>& ray) {
    const Disk<F> disk{{load<F>(c[0] + i), load<F>(c[1] + i), load<F>(c[2] + i)},
                       {load<F>(c[3] + i), load<F>(c[4] + i), load<F>(c[5] + i)},
                       load<F>(c[6] + i)};
    return intersect(disk, ray);
  }
};

struct TriangleLeaf {
  static constexpr int rows = 9;
  using Shape = Triangle<float>;

  static void put(ClusterRow* to, int i, const Shape& t) {
    const float values[rows] = {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z};
    for (int r = 0; r < rows; ++r) to[r][i] = values[r];
  }
  static Shape get(const ClusterRow* c, int i) {
    return {{c[0][i], c[1][i], c[2][i]}, {c[3][i], c[4][i], c[5][i]}, {c[6][i], c[7][i], c[8][i]}};
  }
  template <class F>
  static ShapeHit<F> meet(const ClusterRow* c, int i, const Ray<F>& ray) {
    const Triangle<F> triangle{{load<F>(c[0] + i), load<F>(c[1] + i), load<F>(c[2] + i)},
                               {load<F>(c[3] + i), load<F>(c[4] + i), load<F>(c[5] + i)},
                               {load<F>(c[6] + i), load<F>(c[7] + i), load<F>(c[8] + i)}};
    return intersect(triangle, ray);
  }
};

/// Boxes turned about y, or not at all: two floats of orientation, and half the work.
struct UprightBoxLeaf {
  static constexpr int rows = 8;
  using Shape = UprightBox<float>;

  static void put(ClusterRow* to, int i, const Shape& b) {
    const float values[rows] = {b.center.x, b.center.y, b.center.z,    b.half.x,
                                b.half.y,   b.half.z,   b.axes.cosine, b.axes.sine};
    for (int r = 0; r < rows; ++r) to[r][i] = values[r];
  }
  static Shape get(const ClusterRow* c, int i) {
    return {{c[0][i], c[1][i], c[2][i]}, {c[3][i], c[4][i], c[5][i]}, {c[6][i], c[7][i]}};
  }
  template <class F>
  static ShapeHit<F> meet(const ClusterRow* c, int i, const Ray<F>& ray) {
    const UprightBox<F> box{{load<F>(c[0] + i), load<F>(c[1] + i), load<F>(c[2] + i)},
                            {load<F>(c[3] + i), load<F>(c[4] + i), load<F>(c[5] + i)},
                            {load<F>(c[6] + i), load<F>(c[7] + i)}};
    const BoxCrossing<F> crossing = crossBox(box, ray);
    return {crossing.valid, crossing.t, F(0.0f), F(0.0f)};
  }
};

/// Boxes in any orientation, by a unit quaternion.
struct TurnedBoxLeaf {
  static constexpr int rows = 10;
  using Shape = TurnedBox;

  static void put(ClusterRow* to, int i, const Shape& b) {
    const float values[rows] = {b.center.x, b.center.y, b.center.z, b.half.x, b.half.y, b.half.z, b.w, b.x, b.y, b.z};
    for (int r = 0; r < rows; ++r) to[r][i] = values[r];
  }
  static Shape get(const ClusterRow* c, int i) {
    return {{c[0][i], c[1][i], c[2][i]}, {c[3][i], c[4][i], c[5][i]}, c[6][i], c[7][i], c[8][i], c[9][i]};
  }
  template <class F>
  static ShapeHit<F> meet(const ClusterRow* c, int i, const Ray<F>& ray) {
    const Box<F> box{{load<F>(c[0] + i), load<F>(c[1] + i), load<F>(c[2] + i)},
                     {load<F>(c[3] + i), load<F>(c[4] + i), load<F>(c[5] + i)},
                     axesOfQuaternion(load<F>(c[6] + i), load<F>(c[7] + i), load<F>(c[8] + i), load<F>(c[9] + i))};
    const BoxCrossing<F> crossing = crossBox(box, ray);
    return {crossing.valid, crossing.t, F(0.0f), F(0.0f)};
  }
};

// --- The cluster ------------------------------------------------------------------------------------------------

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

/// Who wins at equal distance: the smaller shape, then primitive, then instance.
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

/// Updates `best` if the cluster has a nearer hit, or an equally near one of smaller id. `instance` is the one that the
/// cluster is met in, or kNone; `number` the cluster's. The kernel keeps to ray.tMax, not to best.t: kernels that
/// follow one another then do not wait for each other's result, which is worth 10 to 40 %.
template <class Leaf, class F>
void meetNearest(const Cluster<Leaf>& cluster, std::uint32_t number, const Ray<F>& ray, std::uint32_t instance,
                 LeafHit& best) {
  constexpr int width = widthOf<F>;
  static_assert(width <= kClusterSize);
  for (int first = 0; first < kClusterSize; first += width) {
    if (cluster.shape[first] == kNone) break;
    const ShapeHit<F> hit = Leaf::meet(cluster.row, first, ray);
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
bool meetAny(const Cluster<Leaf>& cluster, const Ray<F>& ray) {
  static_assert(widthOf<F> <= kClusterSize);
  MaskOf<F> hit(false);
  for (int i = 0; i < kClusterSize; i += widthOf<F>) {
    if (cluster.shape[i] == kNone) break;
    hit |= Leaf::meet(cluster.row, i, ray).valid;
  }
  return any(hit);
}

}  // namespace steradian
