#pragma once
/// A primitive that emits: constant radiance, from the side of its outward normal or from both.
#include "steradian/accel/shapes/sampled_shape.h"
#include "steradian/core/description.h"
#include "steradian/core/ray_offset.h"

namespace steradian {

class AreaLight {
 public:
  AreaLight(SampledShape shape, const SurfaceEmission& emission);

  /// A direction to the light, as if it were the only one. No sample where its black side is seen. The distance stops
  /// short of the emitter by the rounding errors of both ends.
  LightSample<float> sample(const ScatterPoint<float>& from, Vec2f u) const;

  /// Radiance that leaves along -direction from a point with this outward normal, and the density of sample().
  Emission<float> emission(const ScatterPoint<float>& from, Vec3f direction, Vec3f normal) const;

  /// Radiance alone.
  Rgb radiance(Vec3f direction, Vec3f normal) const {
    return twoSided_ || dot(direction, normal) < 0.0f ? radiance_ : Rgb{};
  }

  /// W per channel, of both sides if both emit.
  Rgb power() const;

  const SampledShape& shape() const { return shape_; }

 private:
  SampledShape shape_;
  Rgb radiance_;
  Vec3f flatNormal_;  ///< of a flat shape, else zero
  float size_;        ///< about its diameter: what rounding errors on it scale with, beside its coordinates
  bool flat_, twoSided_;
};

}  // namespace steradian
