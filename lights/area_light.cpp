#include "steradian/lights/area_light.h"

#include <utility>

#include "steradian/core/ray_offset.h"

namespace steradian {
namespace {

/// Bound of the error of a distance between two points whose coordinates are at most so large: a point of the emitter
/// and the ray's origin take some ten roundings each, the leaf kernels as many again.
float distanceError(const ScatterPoint<float>& from, float magnitude) {
  const Vec3f e = from.positionError;
  // The origin leaves its surface by up to the error of its position.
  return gammaBound(32) * magnitude + 2.0f * (e.x + e.y + e.z);
}

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

LightSample<float> AreaLight::sample(const ScatterPoint<float>& from, Vec2f u) const {
  const DirectionSample<float> s = shape_.sampleDirection(from.position, u);
  if (s.pdf == 0.0f) return {};
  const Vec3f position = from.position + s.wi * s.distance;
  const Vec3f normal = flat_ ? flatNormal_ : shape_.normalAt(position);
  const float cosine = -dot(s.wi, normal);
  if (cosine <= 0.0f && !twoSided_) return {};
  // A point on the emitter itself is off it by rounding only, and seems to see it; the shadow ray would start behind
  // it. Where the ray's origin is not on the side that the point was, there is no sample.
  const Vec3f origin = offsetOrigin(from.position, from.positionError, from.geometricNormal, s.wi);
  if ((s.distance * cosine + dot(origin - from.position, normal)) * cosine <= 0.0f) return {};
  const float magnitude = maxComponent(absolute(position)) + maxComponent(absolute(from.position)) + size_;
  // Along a grazing ray the error grows; below the limit next to no light is carried.
  const float shortened = s.distance - distanceError(from, magnitude) / maximum(absolute(cosine), 1e-3f);
  return {radiance_ * (1.0f / s.pdf), s.wi, maximum(shortened, 0.5f * s.distance), s.pdf};
}

Emission<float> AreaLight::emission(const ScatterPoint<float>& from, Vec3f direction, Vec3f normal) const {
  const Rgb seen = radiance(direction, normal);
  if (isBlack(seen)) return {};
  return {seen, shape_.pdfDirection(from.position, direction)};
}

Rgb AreaLight::power() const { return radiance_ * (kPi * shape_.area() * (twoSided_ ? 2.0f : 1.0f)); }

}  // namespace steradian
