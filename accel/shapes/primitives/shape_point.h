#pragma once
/// The point of a shape that a ray hit, re-projected onto the surface, with bounds of its rounding errors.
///
/// `shapePoint(shape, ray, hit)` is a free function per shape, generic over lanes; `hit` is what its kernel returned
/// for this ray. `uvOf` says where on the shape that is, in [0, 1]^2 (see SurfacePoint::uv). The error covers the
/// position's rounding and that of the next query from there, so that rays spawned by core/transport/ray_offset.h do
/// not hit the primitive they leave.
#include "steradian/accel/shapes/primitives/aligned_quad.h"
#include "steradian/accel/shapes/primitives/box.h"
#include "steradian/accel/shapes/primitives/disk.h"
#include "steradian/accel/shapes/primitives/moving_sphere.h"
#include "steradian/accel/shapes/primitives/quad.h"
#include "steradian/accel/shapes/primitives/sphere.h"
#include "steradian/accel/shapes/primitives/triangle.h"

namespace STERADIAN_API steradian {

template <class F>
struct ShapePoint {
  Vec3<F> position;  ///< in the space of the ray, scene units
  Vec3<F> error;     ///< per component: |true - computed| is at most this
  Vec3<F> normal;    ///< unit, outward
};

/// Errors by the number of roundings that a coordinate of a corner or centre undergoes, and by that of an edge or
/// radius, here and in the next query's kernel together. (With 2 and 8 one ray in 5000 still hits the box that it
/// leaves.)
inline constexpr float kPlaceError = gammaBound(3);
inline constexpr float kReachError = gammaBound(12);

template <class F>
ShapePoint<F> shapePoint(const Sphere<F>& sphere, const Ray<F>& ray, const ShapeHit<F>& hit) {
  const Vec3<F> normal = normalize(ray.origin - sphere.center + ray.direction * hit.t);
  const Vec3<F> reach = normal * sphere.radius;
  return {sphere.center + reach,
          absolute(sphere.center) * F(kPlaceError) + absolute(reach) * F(kPlaceError + kReachError), normal};
}

template <class F>
ShapePoint<F> shapePoint(const MovingSphere<F>& sphere, const Ray<F>& ray, const ShapeHit<F>& hit) {
  return shapePoint(sphere.at(ray.time), ray, hit);
}

/// `normal`: that of the point. The angle about y, from -x to +z, and that from the pole below ("The Next Week" 4.4).
template <class F>
Vec2<F> sphereUv(Vec3<F> normal) {
  const F phi = arcTan2(-normal.z, normal.x) + F(kPi);
  return {clamp(phi * F(kInvTwoPi), F(0.0f), F(1.0f)), arcCos(-normal.y) * F(kInvPi)};
}

template <class F>
Vec2<F> quadUv(const ShapeHit<F>& hit) {
  return {clamp(hit.u, F(0.0f), F(1.0f)), clamp(hit.v, F(0.0f), F(1.0f))};
}
template <class F>
Vec3<F> positionOf(const Quad<F>& quad, const ShapeHit<F>& hit) {
  const Vec2<F> uv = quadUv(hit);
  return quad.corner + quad.u * uv.x + quad.v * uv.y;
}
template <class F>
ShapePoint<F> shapePoint(const Quad<F>& quad, const Ray<F>&, const ShapeHit<F>& hit) {
  return {positionOf(quad, hit),
          absolute(quad.corner) * F(kPlaceError) + (absolute(quad.u) + absolute(quad.v)) * F(kReachError),
          normalize(cross(quad.u, quad.v))};
}

/// Of an AlignedQuad from `low` to `high`: exactly in its plane.
template <class F>
Vec3<F> positionBetween(Vec3<F> low, Vec3<F> high, const Ray<F>& ray, F t) {
  const Vec3<F> p = ray.at(t);
  return {clamp(p.x, low.x, high.x), clamp(p.y, low.y, high.y), clamp(p.z, low.z, high.z)};
}

template <class F>
ShapePoint<F> shapePoint(const Disk<F>& disk, const Ray<F>& ray, const ShapeHit<F>& hit) {
  Vec3<F> offset = ray.origin - disk.center + ray.direction * hit.t;
  offset -= disk.normal * dot(offset, disk.normal);
  const F reach = disk.radius * F(kReachError);
  return {disk.center + offset, absolute(disk.center) * F(kPlaceError) + Vec3<F>{reach, reach, reach}, disk.normal};
}

/// Angle about the normal, and distance from the centre over the radius.
template <class F>
Vec2<F> uvOf(const Disk<F>& disk, Vec3<F> position) {
  const Vec3<F> local = Frame<F>::fromZ(disk.normal).toLocal(position - disk.center);
  const F angle = arcTan2(local.y, local.x) * F(kInvTwoPi);
  const F reach = squareRoot(local.x * local.x + local.y * local.y);
  return {select(angle < F(0.0f), angle + F(1.0f), angle), minimum(reach / disk.radius, F(1.0f))};
}

/// u and v of the hit are barycentric.
template <class F>
Vec2<F> triangleUv(const ShapeHit<F>& hit) {
  const F u = clamp(hit.u, F(0.0f), F(1.0f));
  return {u, clamp(hit.v, F(0.0f), F(1.0f) - u)};
}
template <class F>
Vec3<F> positionOf(const Triangle<F>& t, const ShapeHit<F>& hit) {
  const Vec2<F> uv = triangleUv(hit);
  return t.a * (F(1.0f) - uv.x - uv.y) + t.b * uv.x + t.c * uv.y;
}
/// The normal is that of the plane.
template <class F>
ShapePoint<F> shapePoint(const Triangle<F>& t, const Ray<F>&, const ShapeHit<F>& hit) {
  const Vec3<F> ab = t.b - t.a, ac = t.c - t.a;
  return {positionOf(t, hit),
          (absolute(t.a) + absolute(t.b) + absolute(t.c)) * F(0.5f * kPlaceError) +
              (absolute(ab) + absolute(ac)) * F(kReachError),
          normalize(cross(ab, ac))};
}

/// The point of a box in its own frame, and which face it is on.
template <class F>
struct BoxPlace {
  Vec3<F> local;  ///< relative to the centre, along the axes
  F face;         ///< 0 to 5 (see box.h)
};
template <class F, class Axes>
BoxPlace<F> boxPlace(const OrientedBox<F, Axes>& box, const Ray<F>& ray, F t) {
  // The query's kernel once more. In an instance this ray differs from Embree's in the last bits, so the search starts
  // half-way to the hit, which tells whether the ray enters or leaves there.
  Ray<F> again = ray;
  again.tMin = maximum(ray.tMin, F(0.5f) * t);
  const F face = crossBox(box, again).face();
  const Vec3<F> h = box.half;
  const Vec3<F> p = box.axes.toLocal(ray.origin - box.center) + box.axes.toLocal(ray.direction) * t;
  return {{clamp(p.x, -h.x, h.x), clamp(p.y, -h.y, h.y), clamp(p.z, -h.z, h.z)}, face};
}
/// -1 for the faces of even number, 1 for the others.
template <class F>
F boxSide(F face) {
  return F(2.0f) * (face - F(2.0f) * floorOf(F(0.5f) * face)) - F(1.0f);
}

template <class F, class Axes>
ShapePoint<F> shapePoint(const OrientedBox<F, Axes>& box, const BoxPlace<F>& place) {
  const F side = boxSide(place.face), zero(0.0f);
  const MaskOf<F> isX = place.face < F(2.0f), isZ = place.face >= F(4.0f), isY = !(isX | isZ);
  const Vec3<F> h = box.half;
  const Vec3<F> local{select(isX, side * h.x, place.local.x), select(isY, side * h.y, place.local.y),
                      select(isZ, side * h.z, place.local.z)};
  const Vec3<F> outward{select(isX, side, zero), select(isY, side, zero), select(isZ, side, zero)};
  return {box.center + box.axes.toWorld(local),
          absolute(box.center) * F(kPlaceError) + reachOf(box.axes, h) * F(kReachError), box.axes.toWorld(outward)};
}
template <class F, class Axes>
ShapePoint<F> shapePoint(const OrientedBox<F, Axes>& box, const Ray<F>& ray, const ShapeHit<F>& hit) {
  return shapePoint(box, boxPlace(box, ray, hit.t));
}

/// Along the edges of the face.
template <class F, class Axes>
Vec2<F> uvOf(const OrientedBox<F, Axes>& box, const BoxPlace<F>& place) {
  const auto along = [](F at, F half) { return (at + half) / (F(2.0f) * half); };
  const F x = along(place.local.x, box.half.x), y = along(place.local.y, box.half.y),
          z = along(place.local.z, box.half.z);
  const MaskOf<F> positive = boxSide(place.face) > F(0.0f), isX = place.face < F(2.0f), isZ = place.face >= F(4.0f);
  const F turnedZ = select(positive, F(1.0f) - z, z);
  return {select(isX, turnedZ, select(isZ, select(positive, x, F(1.0f) - x), x)), select(isX | isZ, y, turnedZ)};
}

}  // namespace steradian
