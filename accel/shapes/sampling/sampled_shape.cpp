#include "steradian/accel/shapes/sampling/sampled_shape.h"

#include "steradian/accel/shapes/sampling/box_sampling.h"
#include "steradian/accel/shapes/sampling/disk_sampling.h"
#include "steradian/accel/shapes/sampling/quad_sampling.h"
#include "steradian/accel/shapes/sampling/sphere_sampling.h"
#include "steradian/accel/shapes/sampling/triangle_sampling.h"

namespace steradian {
namespace {

using SharedTransformed = std::shared_ptr<const TransformedShape>;

// Plain shapes have free functions, a transformed one has members: this calls either.
template <class Plain, class Moved>
auto visitShape(const SampledShape::Shape& shape, const Plain& plain, const Moved& moved) {
  return std::visit(
      [&]<class S>(const S& s) {
        if constexpr (std::is_same_v<S, SharedTransformed>) {
          return moved(*s);
        } else {
          return plain(s);
        }
      },
      shape);
}

// Two vectors are perpendicular, or of one length, to 1e-5.
constexpr float kShapeTolerance = 1e-5f;
bool perpendicular(Vec3f a, Vec3f b) { return absDot(a, b) <= kShapeTolerance * length(a) * length(b); }
bool sameLength(Vec3f a, Vec3f b) { return absolute(length(a) - length(b)) <= kShapeTolerance * length(a); }

bool mirrors(const Matrix& m) {
  const Vec3f x{m[0][0], m[0][1], m[0][2]}, y{m[1][0], m[1][1], m[1][2]}, z{m[2][0], m[2][1], m[2][2]};
  return dot(x, cross(y, z)) < 0.0f;
}

template <class S>
SampledShape fallback(const S& shape, const Matrix& m) {
  return SampledShape(std::make_shared<const TransformedShape>(shape, m));
}

SampledShape move(const Quad<float>& quad, const Matrix& m) {
  const Vec3f corner = transformPoint(m, quad.corner), u = transformVector(m, quad.u), v = transformVector(m, quad.v);
  // A mirror turns u x v to the inner side; exchanging the edges turns it back.
  return SampledShape(mirrors(m) ? Quad<float>{corner, v, u} : Quad<float>{corner, u, v});
}
SampledShape move(const Triangle<float>& t, const Matrix& m) {
  const Vec3f a = transformPoint(m, t.a), b = transformPoint(m, t.b), c = transformPoint(m, t.c);
  return SampledShape(mirrors(m) ? Triangle<float>{a, c, b} : Triangle<float>{a, b, c});
}
SampledShape move(const Sphere<float>& sphere, const Matrix& m) {
  const Vec3f x = transformVector(m, Vec3f{1.0f, 0.0f, 0.0f}), y = transformVector(m, Vec3f{0.0f, 1.0f, 0.0f});
  const Vec3f z = transformVector(m, Vec3f{0.0f, 0.0f, 1.0f});
  const bool similar =
      perpendicular(x, y) && perpendicular(y, z) && perpendicular(z, x) && sameLength(x, y) && sameLength(x, z);
  if (!similar) return fallback(sphere, m);
  return SampledShape(Sphere<float>{transformPoint(m, sphere.center), sphere.radius * length(x)});
}
SampledShape move(const Disk<float>& disk, const Matrix& m) {
  const Frame<float> axes = Frame<float>::fromZ(disk.normal);
  const Vec3f x = transformVector(m, axes.x), y = transformVector(m, axes.y);
  if (!(perpendicular(x, y) && sameLength(x, y))) return fallback(disk, m);
  const Vec3f normal = normalize(cross(x, y));
  return SampledShape(
      Disk<float>{transformPoint(m, disk.center), mirrors(m) ? -normal : normal, disk.radius * length(x)});
}
SampledShape move(const Box<float>& box, const Matrix& m) {
  const Vec3f x = transformVector(m, box.axes.x), y = transformVector(m, box.axes.y);
  const Vec3f z = transformVector(m, box.axes.z);
  if (!(perpendicular(x, y) && perpendicular(y, z) && perpendicular(z, x))) return fallback(box, m);
  const Vec3f unitX = normalize(x), unitZ = normalize(cross(x, y));
  return SampledShape(Box<float>{transformPoint(m, box.center),
                                 {box.half.x * length(x), box.half.y * length(y), box.half.z * length(z)},
                                 {unitX, cross(unitZ, unitX), unitZ}});
}

}  // namespace

float SampledShape::area() const {
  return visitShape(
      shape_, [](const auto& s) { return steradian::area(s); }, [](const auto& s) { return s.area(); });
}

PositionSample<float> SampledShape::samplePosition(Vec2f u, float time) const {
  return visitShape(
      shape_, [&](const auto& s) { return steradian::samplePosition(s, u); },
      [&](const auto& s) { return s.samplePosition(u, time); });
}

float SampledShape::pdfPosition(Vec3f position, float time) const {
  return visitShape(
      shape_, [](const auto& s) { return steradian::pdfPosition(s); },
      [&](const auto& s) { return s.pdfPosition(position, time); });
}

DirectionSample<float> SampledShape::sampleDirection(Vec3f from, Vec2f u, float time) const {
  return visitShape(
      shape_, [&](const auto& s) { return steradian::sampleDirection(s, from, u); },
      [&](const auto& s) { return s.sampleDirection(from, u, time); });
}

float SampledShape::pdfDirection(Vec3f from, Vec3f wi, float time) const {
  return visitShape(
      shape_, [&](const auto& s) { return steradian::pdfDirection(s, from, wi); },
      [&](const auto& s) { return s.pdfDirection(from, wi, time); });
}

Vec3f SampledShape::normalAt(Vec3f position, float time) const {
  return visitShape(
      shape_, [&](const auto& s) { return steradian::normalAt(s, position); },
      [&](const auto& s) { return s.normalAt(position, time); });
}

SampledShape transformed(const SampledShape& shape, const Matrix& localToWorld) {
  return visitShape(
      shape.shape(), [&](const auto& s) { return move(s, localToWorld); },
      [&](const TransformedShape& s) {
        if (!s.motions().empty()) return inMotion(shape, MovingTransform({localToWorld, localToWorld}));
        const Matrix whole = s.localToWorld() * localToWorld;
        return std::visit([&](const auto& local) { return move(local, whole); }, s.local());
      });
}

SampledShape inMotion(const SampledShape& shape, const MovingTransform& motion) {
  const auto moving = [](const TransformedShape::Local& local, std::vector<MovingTransform> motions) {
    return SampledShape(std::make_shared<const TransformedShape>(local, std::move(motions)));
  };
  return visitShape(
      shape.shape(), [&](const auto& s) { return moving(s, {motion}); },
      [&](const TransformedShape& s) {
        std::vector<MovingTransform> motions = s.motions();
        if (motions.empty()) motions.emplace_back(Motion{s.localToWorld(), s.localToWorld()});
        motions.push_back(motion);
        return moving(s.local(), std::move(motions));
      });
}

}  // namespace steradian
