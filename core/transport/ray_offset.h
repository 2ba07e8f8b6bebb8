#pragma once
/// Ray origins that avoid self-intersection, by error bounds and not by an epsilon.
#include "steradian/core/math/ray.h"
#include "steradian/core/transport/scattering.h"

namespace STERADIAN_API steradian {

/// `position` moved along the normal, to the side that `direction` leaves by, out of its error bound: by the bound
/// projected on the normal (Pharr, Jakob & Humphreys, "Physically Based Rendering", 4th ed., 6.8.6), and by what the
/// sum rounds off, taken in advance. No branches: this runs for every ray. A free point (zero normal) stays where it
/// is.
template <class F>
Vec3<F> offsetOrigin(Vec3<F> position, Vec3<F> positionError, Vec3<F> normal, Vec3<F> direction) {
  // Half an ulp of each coordinate may be lost; the smallest normal number moves points that are exact.
  const Vec3<F> bound = positionError + absolute(position) * F(0x1p-23f);
  const F reach = dot(absolute(normal), bound) + F(0x1p-126f);
  return position + normal * copySign(reach, dot(direction, normal));
}

/// The ray that leaves a point; tMax as for LightSample::distance.
template <class F>
Ray<F> spawnRay(const ScatterPoint<F>& from, Vec3<F> direction, F tMax) {
  return {offsetOrigin(from.position, from.positionError, from.geometricNormal, direction), direction, tMax, from.time};
}

}  // namespace steradian
