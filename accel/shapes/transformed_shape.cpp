#include "steradian/accel/shapes/transformed_shape.h"

#include "steradian/accel/shapes/box_sampling.h"
#include "steradian/accel/shapes/disk_sampling.h"
#include "steradian/accel/shapes/sphere_sampling.h"

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
float areaUnder(const Box<float>& box, const Stretch& stretch) {
  const Vec3f h = box.half;
  return 8.0f * (h.y * h.z * stretch(box.axes.x) + h.z * h.x * stretch(box.axes.y) + h.x * h.y * stretch(box.axes.z));
}

}  // namespace

TransformedShape::TransformedShape(const Local& local, const Matrix& localToWorld)
    : local_(local),
      matrix_(localToWorld),
      inverse_(localToWorld.inverse()),
      determinant_(linearDeterminant(localToWorld)),
      area_(std::visit([&](const auto& s) { return areaUnder(s, [&](Vec3f n) { return stretch(n); }); }, local)) {}

float TransformedShape::stretch(Vec3f localNormal) const {
  return determinant_ * length(transformNormal(inverse_, localNormal));
}

PositionSample<float> TransformedShape::samplePosition(Vec2f u) const {
  const PositionSample<float> p = std::visit([&](const auto& s) { return steradian::samplePosition(s, u); }, local_);
  return {transformPoint(matrix_, p.position), normalize(transformNormal(inverse_, p.normal)),
          p.pdf / stretch(p.normal)};
}

float TransformedShape::pdfPosition(Vec3f position) const {
  const Vec3f p = transformPoint(inverse_, position);
  return std::visit([&](const auto& s) { return steradian::pdfPosition(s) / stretch(steradian::normalAt(s, p)); },
                    local_);
}

Vec3f TransformedShape::normalAt(Vec3f position) const {
  const Vec3f p = transformPoint(inverse_, position);
  const Vec3f n = std::visit([&](const auto& s) { return steradian::normalAt(s, p); }, local_);
  return normalize(transformNormal(inverse_, n));
}

DirectionSample<float> TransformedShape::sampleDirection(Vec3f from, Vec2f u) const {
  const Vec3f viewer = transformPoint(inverse_, from);
  const auto s = std::visit([&](const auto& shape) { return steradian::sampleDirection(shape, viewer, u); }, local_);
  const Vec3f w = transformVector(matrix_, s.wi);
  const float scale = length(w);
  return sampleIf(s.pdf > 0.0f, w / scale, s.pdf * (scale * scale * scale / determinant_), s.distance * scale);
}

float TransformedShape::pdfDirection(Vec3f from, Vec3f wi) const {
  const Vec3f viewer = transformPoint(inverse_, from), w = transformVector(inverse_, wi);
  const float scale = 1.0f / length(w);  // |M w'| of the local unit direction w'
  const float local =
      std::visit([&](const auto& shape) { return steradian::pdfDirection(shape, viewer, w * scale); }, local_);
  return densityIf<float>(local > 0.0f, local * (scale * scale * scale / determinant_));
}

}  // namespace steradian
