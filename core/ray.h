#pragma once
/// A ray: the points origin + t direction with tMin < t < tMax, at a time of the shutter.
#include "steradian/core/vec.h"

namespace steradian {

template <class F>
struct Ray {
  Vec3<F> origin;
  Vec3<F> direction;  ///< unit length
  F tMax{kInfinity};  ///< scene units; +inf for a ray, just below the distance for a shadow segment
  F time{0.0f};       ///< in [0, 1): fraction of the shutter interval
  F tMin{0.0f};       ///< 0: origins are offset off their surface, no global epsilon

  Vec3<F> at(F t) const { return origin + direction * t; }
};

}  // namespace steradian
