#pragma once
/// Where several rays meet primitives of any kinds: what the points on a primitive need, in a record to gather.
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "steradian/accel/shapes/clusters/leaf_shape.h"
#include "steradian/accel/shapes/primitives/shape_point.h"
#include "steradian/core/transport/surface_point.h"

namespace STERADIAN_API steradian {

/// What the numbers of a record mean.
enum class PointKind : std::uint32_t { Quad, AlignedQuad, Sphere, MovingSphere, UprightBox, TurnedBox, Disk, Triangle };

struct PointRecord {
  /// Those of the shape, and behind those of quads and triangles the error and the normal of all their points. Aligned
  /// quads have their lowest and highest corner.
  std::array<float, 16> numbers;
  std::uint32_t kind;  ///< PointKind
  std::uint32_t shape, primitive, material;
};
static_assert(sizeof(PointRecord) == 20 * sizeof(float));

/// Whether all of these shapes have records: all but custom ones and meshes with normals of their own.
bool haveRecords(const SceneDescription& scene, std::span<const Id> shapes);
/// Whether points by records can have uv: no mesh has uv of its own.
bool recordsKnowUv(const SceneDescription& scene, std::span<const Id> shapes);

/// Numbers and kind of a primitive's record; ids are for the caller to fill in.
void fillRecord(PointRecord& record, const Quad<float>& quad);
void fillRecord(PointRecord& record, const AlignedQuad& quad);
void fillRecord(PointRecord& record, const Sphere<float>& sphere);
void fillRecord(PointRecord& record, const MovingSphere<float>& sphere);
void fillRecord(PointRecord& record, const UprightBox<float>& box);
void fillRecord(PointRecord& record, const TurnedBox& box);
void fillRecord(PointRecord& record, const Disk<float>& disk);
void fillRecord(PointRecord& record, const Triangle<float>& triangle);

/// As in Hit.
template <class F>
struct RecordHit {
  MaskOf<F> valid{false};
  F t{kInfinity};
  UintOf<F> record{0u};  ///< number of the primitive's record
  F u{0.0f}, v{0.0f};    ///< for points with uv
};

/// Kinds of records as bits.
using PointKinds = std::uint32_t;
inline PointKinds bitOf(const PointRecord& record) { return 1u << record.kind; }

/// The points that these rays hit, without instance; lanes without a hit are not valid. `kinds`: of all the records
/// that are hit. `withUv`: points have uv; hits have u and v.
template <class F>
SurfacePoint<F> surfacePoint(const PointRecord* records, PointKinds kinds, const Ray<F>& ray, const RecordHit<F>& hit,
                             bool withUv);

namespace detail {
/// `uv`: where to put it, or null. `offset`: of the record, in floats.
template <class F>
ShapePoint<F> pointOf(PointKind kind, const PointRecord* records, const UintOf<F>& offset, const Ray<F>& ray,
                      const RecordHit<F>& hit, Vec2<F>* uv) {
  const auto numbers = [&](std::size_t i) { return gather4(records->numbers.data() + i, offset); };
  const ShapeHit<F> found{hit.valid, hit.t, hit.u, hit.v};
  const auto ball = [&](const Sphere<F>& sphere) {
    const ShapePoint<F> on = shapePoint(sphere, ray, found);
    if (uv) *uv = sphereUv(on.normal);
    return on;
  };
  const auto box = [&](const auto& turned) {
    const BoxPlace<F> place = boxPlace(turned, ray, hit.t);
    if (uv) *uv = uvOf(turned, place);
    return shapePoint(turned, place);
  };
  const auto a = numbers(0);
  const Vec3<F> first{a[0], a[1], a[2]};
  if (kind == PointKind::Sphere) return ball({first, a[3]});
  const auto b = numbers(4);
  const Vec3<F> second{a[3], b[0], b[1]};
  if (kind == PointKind::UprightBox) return box(UprightBox<F>{first, second, {b[2], b[3]}});
  if (kind == PointKind::MovingSphere) return ball(MovingSphere<F>{first, second, b[2]}.at(ray.time));
  if (kind == PointKind::Disk) {
    const Disk<F> disk{first, second, b[2]};
    const ShapePoint<F> on = shapePoint(disk, ray, found);
    if (uv) *uv = uvOf(disk, on.position);
    return on;
  }
  const auto c = numbers(8);
  const Vec3<F> third{b[2], b[3], c[0]}, fourth{c[1], c[2], c[3]};
  if (kind == PointKind::AlignedQuad) {
    if (uv) *uv = quadUv(found);
    return {positionBetween(first, second, ray, hit.t), third, fourth};
  }
  const auto d = numbers(12);
  const Vec3<F> fifth{d[0], d[1], d[2]};
  if (kind == PointKind::TurnedBox) return box(Box<F>{first, second, {third, fourth, fifth}});
  // The kernel once more, for the parameters.
  if (kind == PointKind::Triangle) {
    const Triangle<F> triangle{first, second, third};
    const ShapeHit<F> again = intersect(triangle, ray);
    if (uv) *uv = triangleUv(again);
    return {positionOf(triangle, again), fourth, fifth};
  }
  const Quad<F> quad{first, second, third};
  const ShapeHit<F> again = intersect(quad, ray);
  if (uv) *uv = quadUv(again);
  return {positionOf(quad, again), fourth, fifth};
}
}  // namespace detail

template <class F>
SurfacePoint<F> surfacePoint(const PointRecord* records, PointKinds kinds, const Ray<F>& ray, const RecordHit<F>& hit,
                             bool withUv) {
  const UintOf<F> offset = hit.record * UintOf<F>(static_cast<std::uint32_t>(sizeof(PointRecord) / sizeof(float)));
  const auto ids = gather4(&records->kind, offset);
  SurfacePoint<F> point;
  point.valid = hit.valid;
  point.distance = hit.t;
  for (; kinds != 0; kinds &= kinds - 1) {
    const auto kind = static_cast<std::uint32_t>(std::countr_zero(kinds));
    const MaskOf<F> mine = hit.valid & (ids[0] == UintOf<F>(kind));
    if (!any(mine)) continue;
    Vec2<F> uv;
    const ShapePoint<F> on =
        detail::pointOf(static_cast<PointKind>(kind), records, offset, ray, hit, withUv ? &uv : nullptr);
    point.position = select(mine, on.position, point.position);
    point.positionError = select(mine, on.error, point.positionError);
    point.geometricNormal = select(mine, on.normal, point.geometricNormal);
    if (withUv) point.uv = select(mine, uv, point.uv);
  }
  point.shadingNormal = point.geometricNormal;
  point.shape = ids[1];
  point.primitive = ids[2];
  point.material = ids[3];
  return point;
}

}  // namespace steradian
