#pragma once
/// Sphere that moves along a line while the shutter is open ("The Next Week", 2.3), and its leaf kernel.
#include "steradian/accel/shapes/primitives/sphere.h"

namespace STERADIAN_API steradian {

template <class F>
struct MovingSphere {
  Vec3<F> center;  ///< at time 0
  Vec3<F> move;    ///< to where it is at time 1
  F radius;        ///< > 0; scene units

  /// The sphere at that time. Queries and surface points use the same bits, so its rounding needs no error bound.
  Sphere<F> at(F time) const { return {center + move * time, radius}; }
};

template <class F>
ShapeHit<F> intersect(const MovingSphere<F>& sphere, const Ray<F>& ray) {
  return intersect(sphere.at(ray.time), ray);
}

}  // namespace steradian
