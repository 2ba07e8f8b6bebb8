#include "steradian/integrators/flight.h"

#include "steradian/core/warp.h"

namespace steradian {
namespace {

float channelOf(Rgb c, int channel) { return channel == 0 ? c.r : channel == 1 ? c.g : c.b; }
float sum(Rgb c) { return c.r + c.g + c.b; }

/// Whether a surface lies in the boundary that the ray passed before: as near as rounding can tell.
bool coincide(const SurfacePoint<float>& met, const Ray<float>& ray, float passed, Vec3f passedError) {
  const Vec3f error = met.positionError + passedError;
  const float cosine = maximum(absDot(met.geometricNormal, ray.direction), 1e-3f);
  return (met.distance - passed) * cosine <= 4.0f * (error.x + error.y + error.z);
}

}  // namespace

Flight::Flight(Rgb throughput, Vec2f random) {
  const float total = sum(throughput);
  choice_ = total > 0.0f ? throughput * (1.0f / total) : grey(1.0f / 3.0f);
  channel_ = random.y < choice_.r ? 0 : random.y < choice_.r + choice_.g ? 1 : 2;
  depthLeft_ = ExponentialFlight<float>{1.0f}.sample(random.x);
}

/// `left` over the density that a flight in any of the channels has.
Rgb Flight::shareOf(Rgb left) const {
  const float density = sum(choice_ * left);
  return density > 0.0f ? left * (1.0f / density) : Rgb{};
}

bool Flight::advance(const Volumes& volumes, const SurfacePoint<float>& met, Ray<float>& ray, Bodies& bodies) {
  const float length = (met.valid ? met.distance : kInfinity) - ray.tMin;
  if (const Medium* medium = volumes.medium(bodies)) {
    if (!isBlack(medium->emission)) emitted_ += passed_ * shareOf(left_) * medium->emitted(length);
    if (medium->scatters()) {
      const float rate = channelOf(medium->extinction, channel_);
      const float scattered = rate > 0.0f ? depthLeft_ / rate : kInfinity;
      if (scattered < length) {
        left_ *= medium->transmittance(scattered);
        const float density = sum(choice_ * medium->extinction * left_);
        weight_ = density > 0.0f ? passed_ * medium->scattering * left_ * (1.0f / density) : Rgb{};
        distance_ = ray.tMin + scattered;
        position_ = ray.at(distance_);
        scatteredBy_ = medium;
        return false;
      }
      depthLeft_ = maximum(depthLeft_ - (rate > 0.0f ? rate * length : 0.0f), 0.0f);
      left_ *= medium->transmittance(length);
    } else {
      passed_ *= medium->transmittance(length);
    }
  }
  weight_ = passed_ * shareOf(left_);
  distance_ = met.distance;
  if (!met.valid) return false;
  const Boundary boundary = volumes.boundary(met, ray.direction, bodies);
  outsideEta_ = boundary.outsideEta;
  if (boundary.isReal) {
    // A wall in a boundary comes first, however rounding has it: what is scattered there starts on this side of both.
    if (crossings_ > 0 && coincide(met, ray, ray.tMin, passedError_)) bodies = before_;
    return false;
  }
  before_ = bodies;
  passedError_ = met.positionError;
  volumes.cross(met, ray.direction, bodies);
  ray.tMin = met.distance;
  if (++crossings_ < kMostCrossings) return true;
  weight_ = {};
  return false;
}

bool LightWay::advance(const Volumes& volumes, const SurfacePoint<float>& met, Ray<float>& ray, Bodies& bodies) {
  if (const Medium* medium = volumes.medium(bodies)) {
    transmittance_ *= medium->transmittance((met.valid ? met.distance : ray.tMax) - ray.tMin);
  }
  if (!met.valid) return false;
  if (volumes.boundary(met, ray.direction, bodies).isReal || ++crossings_ == kMostCrossings) {
    transmittance_ = {};
    return false;
  }
  volumes.cross(met, ray.direction, bodies);
  ray.tMin = met.distance;
  return !isBlack(transmittance_);
}

}  // namespace steradian
