#pragma once
/// A primitive that emits constant radiance, from the side of its outward normal or from both. A moving light is
/// sampled and found where it is at the time of the path.
#include "steradian/accel/shapes/sampling/sampled_shape_lanes.h"
#include "steradian/core/scene/description.h"
#include "steradian/core/transport/ray_offset.h"

namespace STERADIAN_API steradian {

class AreaLight {
 public:
  AreaLight(SampledShape shape, const SurfaceEmission& emission);

  /// A direction to the light, as if it were the only one. No sample (pdf 0) where only its black side is seen. The
  /// distance ends before the emitter, by the rounding errors of both ends, so that the shadow ray does not hit it.
  template <class F>
  LightSample<F> sample(const ScatterPoint<F>& from, Vec2<F> u) const;

  /// Radiance that leaves along -direction from a point with this outward normal, and the pdf of `direction` under
  /// sample(from).
  Emission<float> emission(const ScatterPoint<float>& from, Vec3f direction, Vec3f normal) const;

  /// Radiance alone.
  Rgb radiance(Vec3f direction, Vec3f normal) const {
    return twoSided_ || dot(direction, normal) < 0.0f ? radiance_ : Rgb{};
  }

  /// W per channel, of both sides if both emit. If the area changes over time, that at time 1/2.
  Rgb power() const;

  const SampledShape& shape() const { return shape_; }

 private:
  SampledShape shape_;
  Rgb radiance_;
  Vec3f flatNormal_;  ///< of a flat shape, else zero
  float size_;        ///< about its diameter: what rounding errors on it scale with, beside its coordinates
  bool flat_, twoSided_;
};

namespace detail {
/// Bound of the error of a distance between two points whose coordinates are at most `magnitude`: computing the point
/// on the emitter and the ray's origin takes some ten roundings each, and intersecting as many again.
template <class F>
F distanceError(const ScatterPoint<F>& from, F magnitude) {
  const Vec3<F> e = from.positionError;
  // The origin leaves its surface by up to the error of its position.
  return F(gammaBound(32)) * magnitude + F(2.0f) * (e.x + e.y + e.z);
}
}  // namespace detail

template <class F>
LightSample<F> AreaLight::sample(const ScatterPoint<F>& from, Vec2<F> u) const {
  const DirectionSample<F> s = sampleDirection(shape_, from.position, u, from.time);
  const Vec3<F> position = from.position + s.wi * s.distance;
  const Vec3<F> normal = flat_ ? broadcast<F>(flatNormal_) : normalAt(shape_, position, from.time);
  const F cosine = -dot(s.wi, normal);
  // If `from` lies on the emitter itself, rounding errors make it seem to see the emitter, and the shadow ray would
  // start behind it. So there is no sample where the offset origin and `from` are on different sides of the emitter.
  const Vec3<F> origin = offsetOrigin(from.position, from.positionError, from.geometricNormal, s.wi);
  const MaskOf<F> behind = (s.distance * cosine + dot(origin - from.position, normal)) * cosine <= F(0.0f);
  const MaskOf<F> seen = (s.pdf > F(0.0f)) & !behind & (MaskOf<F>(twoSided_) | (cosine > F(0.0f)));
  const F magnitude = maxComponent(absolute(position)) + maxComponent(absolute(from.position)) + F(size_);
  // The error grows along grazing rays; below this limit of the cosine hardly any light is emitted.
  const F shortened = s.distance - detail::distanceError(from, magnitude) / maximum(absolute(cosine), F(1e-3f));
  const Spectrum<F> weight = broadcast<F>(radiance_) * (F(1.0f) / s.pdf);
  return {select(seen, weight, grey(F(0.0f))), s.wi, maximum(shortened, F(0.5f) * s.distance),
          select(seen, s.pdf, F(0.0f))};
}

}  // namespace steradian
