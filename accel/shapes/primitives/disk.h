#pragma once
/// Flat circular disk and its leaf kernel.
#include "steradian/accel/shapes/primitives/shape_hit.h"

namespace STERADIAN_API steradian {

template <class F>
struct Disk {
  Vec3<F> center;
  Vec3<F> normal;  ///< unit length
  F radius;        ///< > 0; scene units
};

/// Hit from either side, rim included. u and v are 0: the surface point finds them from the position.
template <class F>
ShapeHit<F> intersect(const Disk<F>& disk, const Ray<F>& ray) {
  const Vec3<F> f = ray.origin - disk.center;
  // A parallel ray divides by zero: t is infinite or NaN, and fails a comparison below.
  const F t = -dot(f, disk.normal) / dot(ray.direction, disk.normal);
  const Vec3<F> offset = f + ray.direction * t;
  const MaskOf<F> inside = lengthSquared(offset) <= disk.radius * disk.radius;
  const MaskOf<F> valid = inside & (t > ray.tMin) & (t < ray.tMax);
  return {valid, t, F(0.0f), F(0.0f)};
}

}  // namespace steradian
