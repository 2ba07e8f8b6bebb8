#include "steradian/integrators/volumes/flight.h"

namespace steradian {
namespace {

/// Whether a surface lies in the one that the ray passed before, at tMin: as near as rounding can tell.
bool coincide(const SurfacePoint<float>& met, const Ray<float>& ray, Vec3f passedError) {
  const Vec3f error = met.positionError + passedError;
  const float cosine = maximum(absDot(met.geometricNormal, ray.direction), 1e-3f);
  return (met.distance - ray.tMin) * cosine <= 4.0f * (error.x + error.y + error.z);
}

}  // namespace

bool Crossings::pass(const Volumes& volumes, const SurfacePoint<float>& met, Ray<float>& ray, Bodies& bodies) {
  const Boundary boundary = volumes.boundary(met, ray.direction, bodies);
  outsideEta_ = boundary.outsideEta;
  if (boundary.isReal) {
    // A wall in a boundary comes first, however rounding has it: what is scattered there starts on this side of both.
    if (count_ > 0 && coincide(met, ray, error_)) bodies = before_;
    return false;
  }
  before_ = bodies;
  error_ = met.positionError;
  volumes.cross(met, ray.direction, bodies);
  ray.tMin = met.distance;
  return ++count_ < kMost;
}

}  // namespace steradian
