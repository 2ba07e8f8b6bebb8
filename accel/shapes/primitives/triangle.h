#pragma once
/// Triangle and its leaf kernel.
#include "steradian/accel/shapes/primitives/shape_hit.h"

namespace STERADIAN_API steradian {

template <class F>
struct Triangle {
  Vec3<F> a, b, c;  ///< counter-clockwise seen from outside: the normal is along (b - a) x (c - a)
};

/// Hit from either side, edges included; u and v are the barycentric coordinates of b and c.
///
/// The side of each edge is decided by a Pluecker product that only changes sign, bit for bit, when the two vertices
/// swap: triangles that share an edge agree on which of them a ray passes, so meshes of our own leaves do not leak.
template <class F>
ShapeHit<F> intersect(const Triangle<F>& triangle, const Ray<F>& ray) {
  const Vec3<F> a = triangle.a - ray.origin, b = triangle.b - ray.origin, c = triangle.c - ray.origin;
  const Vec3<F> bc = c - b, ca = a - c, ab = b - a;
  const F sideA = dot(cross(bc, b + c), ray.direction);
  const F sideB = dot(cross(ca, c + a), ray.direction);
  const F sideC = dot(cross(ab, a + b), ray.direction);
  const F zero(0.0f);
  const MaskOf<F> inside =
      ((sideA >= zero) & (sideB >= zero) & (sideC >= zero)) | ((sideA <= zero) & (sideB <= zero) & (sideC <= zero));
  const F scale = F(1.0f) / (sideA + sideB + sideC);
  const Vec3<F> normal = cross(ab, ca);
  // An edge-on ray divides zero by zero or has an infinite t: it fails a comparison.
  const F t = dot(normal, a) / dot(normal, ray.direction);
  const MaskOf<F> valid = inside & (t > ray.tMin) & (t < ray.tMax);
  return {valid, t, sideB * scale, sideC * scale};
}

}  // namespace steradian
