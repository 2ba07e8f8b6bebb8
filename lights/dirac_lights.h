#pragma once
/// Lights without area: point, spot, distant. No ray can hit them, so only light sampling finds them; their samples
/// have pdf kDirac.
#include "steradian/core/scene/description.h"
#include "steradian/core/transport/scattering.h"

namespace STERADIAN_API steradian {

namespace detail {
/// A sample of a point of intensity I: the weight is I / d^2.
template <class F>
LightSample<F> pointSample(Vec3f position, const Spectrum<F>& intensity, Vec3<F> from) {
  const Vec3<F> offset = broadcast<F>(position) - from;
  const F squared = lengthSquared(offset);
  const MaskOf<F> apart = squared > F(0.0f);
  const F distance = squareRoot(squared);
  const F safe = select(apart, distance, F(1.0f));
  return {intensity * (F(1.0f) / (safe * safe)), offset * (F(1.0f) / safe), distance,
          select(apart, F(kDirac), F(0.0f))};
}
}  // namespace detail

/// The sample of a point light: weight in W m^-2, as if the light were the only one.
template <class F>
LightSample<F> sampleLight(const PointLight& light, Vec3<F> from) {
  return detail::pointSample(light.position, broadcast<F>(light.intensity), from);
}

/// A spot light with its angles turned to cosines.
struct PreparedSpot {
  explicit PreparedSpot(const SpotLight& light);

  /// The fraction of the full intensity at this cosine with the axis: smoothstep, 3 t^2 - 2 t^3, between the two
  /// cosines.
  template <class F>
  F falloff(F cosine) const {
    const F t = clamp((cosine - F(cosOuter)) * F(inverseWidth), F(0.0f), F(1.0f));
    return t * t * (F(3.0f) - F(2.0f) * t);
  }

  Vec3f position, axis;  ///< axis: unit, the way the light travels
  Rgb intensity;
  float cosInner, cosOuter, inverseWidth;
};

/// The sample of a spot light; weight in W m^-2.
template <class F>
LightSample<F> sampleLight(const PreparedSpot& light, Vec3<F> from) {
  LightSample<F> s = detail::pointSample(light.position, broadcast<F>(light.intensity), from);
  const F share = light.falloff(-dot(s.wi, broadcast<F>(light.axis)));
  s.weight *= share;
  s.pdf = select(share > F(0.0f), s.pdf, F(0.0f));
  return s;
}

/// The sample of a distant light, whose direction must be a unit vector; weight in W m^-2.
template <class F>
LightSample<F> sampleLight(const DistantLight& light, Vec3<F>) {
  return {broadcast<F>(light.irradiance), broadcast<F>(-light.direction), F(kInfinity), F(kDirac)};
}

/// Total power in W per channel; of a distant light, that which enters the bounding sphere of the scene.
Rgb powerOf(const PointLight& light);
Rgb powerOf(const PreparedSpot& light);
Rgb powerOf(const DistantLight& light, float sceneRadius);

}  // namespace steradian
