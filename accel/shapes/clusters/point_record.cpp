#include "steradian/accel/shapes/clusters/point_record.h"

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "steradian/accel/shapes/primitives/shape_at.h"

namespace steradian {
namespace {

void fill(PointRecord& record, PointKind kind, std::initializer_list<Vec3f> numbers) {
  float* to = record.numbers.data();
  for (const Vec3f v : numbers) {
    *to++ = v.x;
    *to++ = v.y;
    *to++ = v.z;
  }
  record.kind = static_cast<std::uint32_t>(kind);
}

}  // namespace

void fillRecord(PointRecord& record, const Quad<float>& q) {
  const ShapePoint<float> on = shapePoint(q, {}, {});
  if (!AlignedQuad::of(q)) return fill(record, PointKind::Quad, {q.corner, q.u, q.v, on.error, on.normal});
  const Vec3f opposite = q.corner + q.u + q.v;
  fill(record, PointKind::AlignedQuad, {minimum(q.corner, opposite), maximum(q.corner, opposite), on.error, on.normal});
}
void fillRecord(PointRecord& record, const AlignedQuad& q) { fillRecord(record, q.quad()); }
void fillRecord(PointRecord& record, const Sphere<float>& s) {
  fill(record, PointKind::Sphere, {s.center, {s.radius, 0.0f, 0.0f}});
}
void fillRecord(PointRecord& record, const MovingSphere<float>& s) {
  fill(record, PointKind::MovingSphere, {s.center, s.move, {s.radius, 0.0f, 0.0f}});
}
void fillRecord(PointRecord& record, const UprightBox<float>& b) {
  fill(record, PointKind::UprightBox, {b.center, b.half, {b.axes.cosine, b.axes.sine, 0.0f}});
}
void fillRecord(PointRecord& record, const TurnedBox& turned) {
  const Box<float> b = boxOf(turned);
  fill(record, PointKind::TurnedBox, {b.center, b.half, b.axes.x, b.axes.y, b.axes.z});
}
void fillRecord(PointRecord& record, const Disk<float>& d) {
  fill(record, PointKind::Disk, {d.center, d.normal, {d.radius, 0.0f, 0.0f}});
}
void fillRecord(PointRecord& record, const Triangle<float>& t) {
  const ShapePoint<float> on = shapePoint(t, {}, {});
  fill(record, PointKind::Triangle, {t.a, t.b, t.c, on.error, on.normal});
}

bool haveRecords(const SceneDescription& scene, std::span<const Id> shapes) {
  return std::all_of(shapes.begin(), shapes.end(), [&](Id shape) {
    const ShapeGeometry& geometry = scene.shapes[shape].geometry;
    const auto* mesh = std::get_if<TriangleMesh>(&geometry);
    return !std::holds_alternative<CustomShapeSet>(geometry) && (mesh == nullptr || mesh->normals.empty());
  });
}

bool recordsKnowUv(const SceneDescription& scene, std::span<const Id> shapes) {
  return std::all_of(shapes.begin(), shapes.end(), [&](Id shape) {
    const auto* mesh = std::get_if<TriangleMesh>(&scene.shapes[shape].geometry);
    return mesh == nullptr || mesh->uvs.empty();
  });
}

}  // namespace steradian
