#pragma once
/// Geometry of directions in the local frame, whose z axis is the shading normal.
#include "steradian/core/sampling/warp.h"

namespace STERADIAN_API steradian {

/// Both directions lie on one side of the surface, and neither in it.
template <class F>
inline MaskOf<F> sameSide(Vec3<F> a, Vec3<F> b) {
  return a.z * b.z > F(0.0f);
}

/// The mirror image of wo about the normal.
template <class F>
inline Vec3<F> mirrored(Vec3<F> wo) {
  return {-wo.x, -wo.y, wo.z};
}

/// A direction of density |cos| / pi on the side of the surface that wo is on.
template <class F>
inline Vec3<F> cosineAboutSide(Vec3<F> wo, Vec2<F> u) {
  const Vec3<F> upper = CosineHemisphere<F>::sample(u);
  return {upper.x, upper.y, copySign(upper.z, wo.z)};
}

}  // namespace steradian
