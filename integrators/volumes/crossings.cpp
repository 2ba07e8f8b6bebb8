#include "steradian/integrators/volumes/crossings.h"

namespace steradian {
namespace {

/// Whether a surface lies in the one that the ray passed before, at tMin: as near as rounding can tell.
bool coincide(const SurfacePoint<float>& at, const Ray<float>& ray, Vec3f passedError) {
  const Vec3f error = at.positionError + passedError;
  const float cosine = maximum(absDot(at.geometricNormal, ray.direction), 1e-3f);
  return (at.distance - ray.tMin) * cosine <= 4.0f * (error.x + error.y + error.z);
}

}  // namespace

bool Crossings::pass(const Volumes& volumes, const SurfacePoint<float>& at, Ray<float>& ray, InteriorStack& interior) {
  const Boundary boundary = volumes.boundary(at, ray.direction, interior);
  outsideEta_ = boundary.outsideEta;
  if (boundary.isReal) {
    // A wall in a boundary comes first, however rounding has it: what is scattered there starts on this side of both.
    if (count_ > 0 && coincide(at, ray, error_)) interior = before_;
    return false;
  }
  before_ = interior;
  error_ = at.positionError;
  volumes.cross(at, ray.direction, interior);
  ray.tMin = at.distance;
  return ++count_ < kMaxCount;
}

}  // namespace steradian
