#pragma once
/// Geometry of directions in the local frame, whose z axis is the shading normal.
#include "steradian/core/sampling/warp.h"

namespace STERADIAN_API steradian {

/// Both directions are strictly on the same side of the surface.
template <class F>
inline MaskOf<F> sameHemisphere(Vec3<F> a, Vec3<F> b) {
  return a.z * b.z > F(0.0f);
}

/// The direction of ideal specular reflection: wo reflected about the normal.
template <class F>
inline Vec3<F> mirrored(Vec3<F> wo) {
  return {-wo.x, -wo.y, wo.z};
}

/// A direction in the hemisphere of wo, with the pdf |cos| / pi.
template <class F>
inline Vec3<F> sampleCosineHemisphere(Vec3<F> wo, Vec2<F> u) {
  const Vec3<F> upper = CosineHemisphere<F>::sample(u);
  return {upper.x, upper.y, copySign(upper.z, wo.z)};
}

}  // namespace steradian
