#pragma once
/// The point where a ray hit a surface. Geometry, materials and lights refer to one another only by the plain ids in
/// here.
#include <cstdint>

#include "steradian/core/math/vec.h"

namespace STERADIAN_API steradian {

/// The id of nothing: no material, light, instance, ...
inline constexpr std::uint32_t kNone = 0xffffffffu;

/// What the ray query returns: enough to compute the surface point later, for the rays that need it.
template <class F>
struct Hit {
  MaskOf<F> valid{false};
  F t{kInfinity};          ///< distance along the ray, scene units
  F u{0.0f}, v{0.0f};      ///< parameters of the primitive (quad: along its edges; triangle: barycentric of 2nd, 3rd)
  UintOf<F> shape{kNone};  ///< index into SceneDescription::shapes
  UintOf<F> primitive{kNone};  ///< index inside that shape's set
  UintOf<F> instance{kNone};   ///< index of the flattened instance, or kNone for a shape placed directly
  UintOf<F> place{kNone};      ///< where the geometry stores the primitive: for its own use
};

template <class F>
struct SurfacePoint {
  MaskOf<F> valid{false};
  Vec3<F> position;         ///< on the surface, re-projected; scene units
  Vec3<F> positionError;    ///< per component: |true - computed| is at most this (see core/transport/ray_offset.h)
  Vec3<F> geometricNormal;  ///< unit, outward: not turned towards the ray
  Vec3<F> shadingNormal;    ///< unit, same side as the geometric normal
  Vec2<F> uv;               ///< surface parameters in [0, 1]^2 (the books' u, v for spheres and quads)
  F distance{0.0f};         ///< from the ray's origin
  UintOf<F> shape{kNone}, primitive{kNone}, instance{kNone};
  UintOf<F> material{kNone};  ///< index into SceneDescription::materials
};

template <class F>
SurfacePoint<float> lane(const SurfacePoint<F>& p, int i) {
  return {lane(p.valid, i),         lane(p.position, i), lane(p.positionError, i), lane(p.geometricNormal, i),
          lane(p.shadingNormal, i), lane(p.uv, i),       lane(p.distance, i),      lane(p.shape, i),
          lane(p.primitive, i),     lane(p.instance, i), lane(p.material, i)};
}
template <class F>
void setLane(SurfacePoint<F>& p, int i, const SurfacePoint<float>& value) {
  setLane(p.valid, i, value.valid);
  setLane(p.position, i, value.position);
  setLane(p.positionError, i, value.positionError);
  setLane(p.geometricNormal, i, value.geometricNormal);
  setLane(p.shadingNormal, i, value.shadingNormal);
  setLane(p.uv, i, value.uv);
  setLane(p.distance, i, value.distance);
  setLane(p.shape, i, value.shape);
  setLane(p.primitive, i, value.primitive);
  setLane(p.instance, i, value.instance);
  setLane(p.material, i, value.material);
}

}  // namespace steradian
