#pragma once
/// The point of a shape that a ray met, re-projected onto the surface, with bounds of its rounding errors.
///
/// `shapePoint(shape, ray, hit)` is a free function per shape, generic over lanes; `hit` is what its kernel returned
/// for this ray. The error covers the position's rounding and that of the next query from there, so that rays spawned
/// by core/ray_offset.h do not meet the primitive they leave.
#include "steradian/accel/shapes/aligned_quad.h"
#include "steradian/accel/shapes/box.h"
#include "steradian/accel/shapes/disk.h"
#include "steradian/accel/shapes/moving_sphere.h"
#include "steradian/accel/shapes/quad.h"
#include "steradian/accel/shapes/sphere.h"
#include "steradian/accel/shapes/triangle.h"

namespace steradian {

template <class F>
struct ShapePoint {
  Vec3<F> position;  ///< in the space of the ray, scene units
  Vec3<F> error;     ///< per component: |true - computed| is at most this
  Vec3<F> normal;    ///< unit, outward
};

/// Roundings that a coordinate of a shape's corner or centre goes through, and one that an edge or radius does, here
/// and in the next query's kernel together. (With 2 and 8 one ray in 5000 still meets the box that it leaves.)
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

template <class F>
Vec3<F> positionOf(const Quad<F>& quad, const ShapeHit<F>& hit) {
  const F s = clamp(hit.u, F(0.0f), F(1.0f)), t = clamp(hit.v, F(0.0f), F(1.0f));
  return quad.corner + quad.u * s + quad.v * t;
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

/// u and v of the hit are barycentric.
template <class F>
Vec3<F> positionOf(const Triangle<F>& t, const ShapeHit<F>& hit) {
  const F u = clamp(hit.u, F(0.0f), F(1.0f)), v = clamp(hit.v, F(0.0f), F(1.0f) - u), w = F(1.0f) - u - v;
  return t.a * w + t.b * u + t.c * v;
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
  // The query's kernel once more. In an instance this ray is not Embree's to the last bit: whether it enters or leaves
  // is decided half-way.
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

}  // namespace steradian
