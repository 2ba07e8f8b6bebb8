#pragma once
/// Surface points of several rays at once: what the points on a primitive need, in a record to gather from.
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "steradian/accel/shapes/clusters/leaf_kinds.h"
#include "steradian/core/transport/surface_point.h"

namespace STERADIAN_API steradian {

/// The leaf kind computes the point (Leaf::point). Vertex data of meshes and transforms of instances are applied
/// afterwards (accel/surface_points.h).
struct PointRecord {
  PointNumbers numbers;
  std::uint32_t kind;  ///< LeafKinds::indexOf
  std::uint32_t shape, primitive, material;
};
static_assert(sizeof(PointRecord) == 20 * sizeof(float));

/// Numbers and kind of a primitive's record; ids are for the caller to fill in.
template <class Leaf>
void fillRecord(PointRecord& record, const typename Leaf::Shape& shape) {
  if constexpr (requires { Leaf::pointsLike(shape); }) {
    if (const auto other = Leaf::pointsLike(shape)) return fillRecord<typename Leaf::PointsLike>(record, *other);
  }
  Leaf::writePoint(record.numbers, shape);
  record.kind = LeafKinds::indexOf<Leaf>();
}

/// As in Hit.
template <class F>
struct RecordHit {
  MaskOf<F> valid{false};
  F t{kInfinity};
  UintOf<F> record{0u};  ///< number of the primitive's record
  F u{0.0f}, v{0.0f};
  bool parametersKnown = false;  ///< u and v are set; else points compute them again
};

/// Kinds of records as bits.
using PointKinds = std::uint32_t;
inline PointKinds bitOf(const PointRecord& record) { return 1u << record.kind; }

/// The points that these rays hit, without instance; lanes without a hit are not valid. `kinds`: of all the records
/// that are hit. `withUv`: points have uv; the parameters of the hits must be known.
template <class F>
SurfacePoint<F> surfacePoint(const PointRecord* records, PointKinds kinds, const Ray<F>& ray, const RecordHit<F>& hit,
                             bool withUv) {
  const UintOf<F> offset = hit.record * UintOf<F>(static_cast<std::uint32_t>(sizeof(PointRecord) / sizeof(float)));
  const auto ids = gather4(&records->kind, offset);
  const PointRows<F> rowsOf(records->numbers.data(), offset);
  const ShapeHit<F> found{hit.valid, hit.t, hit.u, hit.v};
  SurfacePoint<F> point;
  point.valid = hit.valid;
  point.distance = hit.t;
  LeafKinds::forEach([&]<class Leaf>() {
    constexpr std::uint32_t kind = LeafKinds::indexOf<Leaf>();
    if (!(kinds & (1u << kind))) return;
    const MaskOf<F> mine = hit.valid & (ids[0] == UintOf<F>(kind));
    if (!any(mine)) return;
    Vec2<F> uv;
    const ShapePoint<F> on = Leaf::point(rowsOf, ray, found, hit.parametersKnown, withUv ? &uv : nullptr);
    point.position = select(mine, on.position, point.position);
    point.positionError = select(mine, on.error, point.positionError);
    point.geometricNormal = select(mine, on.normal, point.geometricNormal);
    if (withUv) point.uv = select(mine, uv, point.uv);
  });
  point.shadingNormal = point.geometricNormal;
  point.shape = ids[1];
  point.primitive = ids[2];
  point.material = ids[3];
  return point;
}

}  // namespace steradian
