#include "steradian/lights/dirac_lights.h"

#include <cmath>

namespace steradian {
namespace {

float cosineOfDegrees(float angle) {
  return static_cast<float>(std::cos(static_cast<double>(angle) * 0.017453292519943295));
}

}  // namespace

PreparedSpot::PreparedSpot(const SpotLight& light)
    : position(light.position),
      axis(normalize(light.direction)),
      intensity(light.intensity),
      cosInner(cosineOfDegrees(minimum(light.innerAngle, light.outerAngle))),
      cosOuter(cosineOfDegrees(light.outerAngle)),
      // Equal angles: a sharp rim, as steep as floats can tell.
      inverseWidth(1.0f / maximum(cosInner - cosOuter, 1e-7f)) {}

Rgb powerOf(const PointLight& light) { return light.intensity * kFourPi; }

// The smoothstep has the mean 1/2 over its interval of cosines.
Rgb powerOf(const PreparedSpot& light) {
  return light.intensity * (kTwoPi * ((1.0f - light.cosInner) + 0.5f * (light.cosInner - light.cosOuter)));
}

Rgb powerOf(const DistantLight& light, float sceneRadius) {
  return light.irradiance * (kPi * sceneRadius * sceneRadius);
}

}  // namespace steradian
