#pragma once
/// Sphere and its leaf kernel.
#include "steradian/accel/shapes/primitives/shape_hit.h"

namespace STERADIAN_API steradian {

template <class F>
struct Sphere {
  Vec3<F> center;
  F radius;  ///< > 0; scene units
};

/// Nearest hit beyond tMin, from outside or inside. u and v are 0: the surface point finds them from the position.
///
/// The discriminant comes from the perpendicular distance of the centre to the ray, which does not cancel for large
/// spheres nearby or small ones far away; the two roots from one of them and their product (Haines, Guenther &
/// Akenine-Moeller 2019, "Precision improvements for ray/sphere intersection", Ray Tracing Gems, ch. 7).
template <class F>
ShapeHit<F> intersect(const Sphere<F>& sphere, const Ray<F>& ray) {
  const Vec3<F> f = ray.origin - sphere.center;
  const F radiusSquared = sphere.radius * sphere.radius;
  const F invA = F(1.0f) / lengthSquared(ray.direction);
  const F b = -dot(f, ray.direction);
  const Vec3<F> perpendicular = f + ray.direction * (b * invA);
  const F reach = radiusSquared - lengthSquared(perpendicular);  // squared half chord
  const F halfChord = safeSqrt(reach * lengthSquared(ray.direction));
  const F q = b + copySign(halfChord, b);
  const F first = (lengthSquared(f) - radiusSquared) / q;
  const F second = q * invA;
  const F near = minimum(first, second), far = maximum(first, second);
  const F t = select(near > ray.tMin, near, far);
  const MaskOf<F> valid = (reach >= F(0.0f)) & (t > ray.tMin) & (t < ray.tMax);
  return {valid, t, F(0.0f), F(0.0f)};
}

}  // namespace steradian
