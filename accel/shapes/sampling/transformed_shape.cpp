#include "steradian/accel/shapes/sampling/transformed_shape.h"

#include "steradian/accel/shapes/sampling/box_sampling.h"
#include "steradian/accel/shapes/sampling/disk_sampling.h"
#include "steradian/accel/shapes/sampling/sphere_sampling.h"
#include "steradian/accel/shapes/sampling/triangle_sampling.h"

namespace steradian {
namespace {

float linearDeterminant(const Matrix& m) {
  const Vec3f x{m[0][0], m[0][1], m[0][2]}, y{m[1][0], m[1][1], m[1][2]}, z{m[2][0], m[2][1], m[2][2]};
  return absolute(dot(x, cross(y, z)));
}

// Area by a function stretch(unit normal): the sphere's by midpoints of equal solid angle.
template <class Stretch>
float areaUnder(const Sphere<float>& sphere, const Stretch& stretch) {
  const int rings = 64, sectors = 128;
  double sum = 0.0;
  for (int i = 0; i < rings; ++i) {
    for (int j = 0; j < sectors; ++j) {
      const Vec2f u{(static_cast<float>(i) + 0.5f) / rings, (static_cast<float>(j) + 0.5f) / sectors};
      sum += static_cast<double>(stretch(UniformSphere<float>::sample(u)));
    }
  }
  return area(sphere) * static_cast<float>(sum / (rings * sectors));
}
template <class Stretch>
float areaUnder(const Disk<float>& disk, const Stretch& stretch) {
  return area(disk) * stretch(disk.normal);
}
template <class Stretch>
float areaUnder(const Quad<float>& quad, const Stretch& stretch) {
  return area(quad) * stretch(normalAt(quad, Vec3f{}));
}
template <class Stretch>
float areaUnder(const Triangle<float>& triangle, const Stretch& stretch) {
  return area(triangle) * stretch(normalAt(triangle, Vec3f{}));
}
template <class Stretch>
float areaUnder(const Box<float>& box, const Stretch& stretch) {
  const Vec3f h = box.half;
  return 8.0f * (h.y * h.z * stretch(box.axes.x) + h.z * h.x * stretch(box.axes.y) + h.x * h.y * stretch(box.axes.z));
}

Matrix product(const std::vector<MovingTransform>& motions, float time) {
  Matrix whole = motions.front().at(time);
  for (std::size_t i = 1; i < motions.size(); ++i) whole = whole * motions[i].at(time);
  return whole;
}

}  // namespace

TransformedShape::Place::Place(const Matrix& localToWorld)
    : matrix(localToWorld), inverse(affineInverse(localToWorld)), determinant(linearDeterminant(localToWorld)) {}

float TransformedShape::Place::stretch(Vec3f localNormal) const {
  return determinant * length(transformNormal(inverse, localNormal));
}

TransformedShape::TransformedShape(const Local& local, const Matrix& localToWorld)
    : local_(local), still_(localToWorld), area_(areaIn(still_)) {}

TransformedShape::TransformedShape(const Local& local, std::vector<MovingTransform> motions)
    : local_(local), motions_(std::move(motions)), still_(product(motions_, 0.5f)), area_(areaIn(still_)) {}

TransformedShape::Place TransformedShape::placeAt(float time) const {
  return motions_.empty() ? still_ : Place(product(motions_, time));
}

float TransformedShape::areaIn(const Place& place) const {
  return std::visit([&](const auto& s) { return areaUnder(s, [&](Vec3f n) { return place.stretch(n); }); }, local_);
}

PositionSample<float> TransformedShape::samplePosition(Vec2f u, float time) const {
  const Place place = placeAt(time);
  const PositionSample<float> p = std::visit([&](const auto& s) { return steradian::samplePosition(s, u); }, local_);
  return {transformPoint(place.matrix, p.position), normalize(transformNormal(place.inverse, p.normal)),
          p.pdf / place.stretch(p.normal)};
}

float TransformedShape::pdfPosition(Vec3f position, float time) const {
  const Place place = placeAt(time);
  const Vec3f p = transformPoint(place.inverse, position);
  return std::visit([&](const auto& s) { return steradian::pdfPosition(s) / place.stretch(steradian::normalAt(s, p)); },
                    local_);
}

Vec3f TransformedShape::normalAt(Vec3f position, float time) const {
  const Place place = placeAt(time);
  const Vec3f p = transformPoint(place.inverse, position);
  const Vec3f n = std::visit([&](const auto& s) { return steradian::normalAt(s, p); }, local_);
  return normalize(transformNormal(place.inverse, n));
}

DirectionSample<float> TransformedShape::sampleDirection(Vec3f from, Vec2f u, float time) const {
  const Place place = placeAt(time);
  const Vec3f viewer = transformPoint(place.inverse, from);
  const auto s = std::visit([&](const auto& shape) { return steradian::sampleDirection(shape, viewer, u); }, local_);
  const Vec3f w = transformVector(place.matrix, s.wi);
  const float scale = length(w);
  return sampleIf(s.pdf > 0.0f, w / scale, s.pdf * (scale * scale * scale / place.determinant), s.distance * scale);
}

float TransformedShape::pdfDirection(Vec3f from, Vec3f wi, float time) const {
  const Place place = placeAt(time);
  const Vec3f viewer = transformPoint(place.inverse, from), w = transformVector(place.inverse, wi);
  const float scale = 1.0f / length(w);  // |M w'| of the local unit direction w'
  const float local =
      std::visit([&](const auto& shape) { return steradian::pdfDirection(shape, viewer, w * scale); }, local_);
  return densityIf<float>(local > 0.0f, local * (scale * scale * scale / place.determinant));
}

}  // namespace steradian
