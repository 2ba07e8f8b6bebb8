#include "steradian/lights/area_light.h"

#include <utility>

namespace steradian {
namespace {

/// The normal is the same everywhere. (A disk that became an ellipse is flat too, but rare.)
bool isFlat(const SampledShape::Shape& shape) {
  return std::holds_alternative<PreparedQuad<float>>(shape) || std::holds_alternative<Triangle<float>>(shape) ||
         std::holds_alternative<Disk<float>>(shape);
}

}  // namespace

AreaLight::AreaLight(SampledShape shape, const SurfaceEmission& emission)
    : shape_(std::move(shape)),
      radiance_(emission.radiance),
      size_(squareRoot(shape_.area())),
      flat_(isFlat(shape_.shape())),
      twoSided_(emission.twoSided) {
  if (flat_) flatNormal_ = shape_.normalAt({});
}

Emission<float> AreaLight::emission(const ScatterPoint<float>& from, Vec3f direction, Vec3f normal) const {
  const Rgb seen = radiance(direction, normal);
  if (isBlack(seen)) return {};
  return {seen, shape_.pdfDirection(from.position, direction, from.time)};
}

Rgb AreaLight::power() const { return radiance_ * (kPi * shape_.area() * (twoSided_ ? 2.0f : 1.0f)); }

}  // namespace steradian
