#pragma once
/// Rays and points between the space of a shape or an instance and the world.
///
/// M is a Matrix, or AffineLanes<F>: lanes compute what single rays do, to the bit.
#include "steradian/accel/shapes/primitives/shape_point.h"
#include "steradian/core/base/api.h"
#include "steradian/core/math/transform.h"
#include "steradian/core/transport/surface_point.h"

namespace STERADIAN_API steradian {

namespace detail {
/// |m| |p| + |translation|: what the rounding errors of transformPoint scale with.
template <class M, class F>
Vec3<F> transformMagnitudes(const M& m, Vec3<F> p) {
  const auto component = [&](int j) {
    return absolute(F(m[0][j]) * p.x) + absolute(F(m[1][j]) * p.y) + absolute(F(m[2][j]) * p.z) + absolute(F(m[3][j]));
  };
  return {component(0), component(1), component(2)};
}
template <class M, class F>
Vec3<F> transformedError(const M& m, Vec3<F> error) {
  const auto component = [&](int j) {
    return absolute(F(m[0][j])) * error.x + absolute(F(m[1][j])) * error.y + absolute(F(m[2][j])) * error.z;
  };
  return {component(0), component(1), component(2)};
}
}  // namespace detail

/// A point of a shape's or instance's space in the world. `inverse` is the inverse of `localToWorld`.
template <class M, class F>
SurfacePoint<F> transformed(const SurfacePoint<F>& local, const M& localToWorld, const M& inverse) {
  SurfacePoint<F> world = local;
  world.position = transformPoint(localToWorld, local.position);
  // The errors of this transform, and of the next query's transform back by an inverse with a rounding of its own.
  const Vec3<F> back = detail::transformMagnitudes(inverse, world.position) * F(kReachError);
  world.positionError = detail::transformedError(localToWorld, local.positionError + back) +
                        detail::transformMagnitudes(localToWorld, local.position) * F(kPlaceError);
  world.geometricNormal = normalize(transformNormal(inverse, local.geometricNormal));
  world.shadingNormal = faceForward(normalize(transformNormal(inverse, local.shadingNormal)), world.geometricNormal);
  return world;
}

/// The ray in a shape's or instance's space; its direction is not normalised, so that t means the same.
template <class M, class F>
Ray<F> transformed(const Ray<F>& ray, const M& worldToLocal) {
  Ray<F> local = ray;
  local.origin = transformPoint(worldToLocal, ray.origin);
  local.direction = transformVector(worldToLocal, ray.direction);
  return local;
}

}  // namespace steradian
