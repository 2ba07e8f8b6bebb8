#pragma once
/// What a leaf kernel returns.
///
/// `intersect(shape, ray)` is a free function per shape, generic over lanes: lanes over primitives with one ray in all
/// of them, or lanes over rays with one primitive. It finds the nearest hit with ray.tMin < t < ray.tMax. The ray's
/// direction may have any length (rays enter instances unnormalised); t counts in multiples of it. Origin and
/// direction must be finite. A primitive that is all NaN is never hit: clusters fill unused lanes with it.
#include "steradian/core/math/ray.h"

namespace STERADIAN_API steradian {

template <class F>
struct ShapeHit {
  MaskOf<F> valid{false};
  F t{kInfinity};      ///< distance along the ray; only meaningful where valid
  F u{0.0f}, v{0.0f};  ///< parameters, each shape's own (see there); only meaningful where valid
};

}  // namespace steradian
