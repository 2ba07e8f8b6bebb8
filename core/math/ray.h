#pragma once
/// A ray: the points origin + t direction with tMin < t < tMax, at a time of the shutter.
#include "steradian/core/math/vec.h"

namespace STERADIAN_API steradian {

template <class F>
struct Ray {
  Vec3<F> origin;
  Vec3<F> direction;  ///< unit length
  F tMax{kInfinity};  ///< scene units; +inf for a ray, just below the distance for a shadow segment
  F time{0.0f};       ///< in [0, 1): fraction of the shutter interval
  F tMin{0.0f};       ///< 0: origins are offset off their surface, no global epsilon

  Vec3<F> at(F t) const { return origin + direction * t; }
};

template <class F>
Ray<float> lane(const Ray<F>& r, int i) {
  return {lane(r.origin, i), lane(r.direction, i), lane(r.tMax, i), lane(r.time, i), lane(r.tMin, i)};
}
template <class F>
void setLane(Ray<F>& r, int i, const Ray<float>& value) {
  setLane(r.origin, i, value.origin);
  setLane(r.direction, i, value.direction);
  setLane(r.tMax, i, value.tMax);
  setLane(r.time, i, value.time);
  setLane(r.tMin, i, value.tMin);
}

/// False for rays that must not reach a kernel or a hierarchy: not finite, without a direction, or empty.
template <class F>
MaskOf<F> isUsable(const Ray<F>& ray) {
  const Vec3<F> o = absolute(ray.origin), d = absolute(ray.direction);
  const F length = d.x + d.y + d.z;
  return isFinite(o.x + o.y + o.z + length) & (length > F(0.0f)) & (ray.tMin >= F(0.0f)) & (ray.tMax > ray.tMin);
}

}  // namespace steradian
