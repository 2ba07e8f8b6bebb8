#include "steradian/accel/shapes/flat_primitives.h"

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "steradian/accel/shapes/shape_at.h"

namespace steradian {

bool FlatPrimitives::holds(const SceneDescription& scene, std::span<const Id> shapes) {
  std::size_t count = 0;
  const bool known = std::all_of(shapes.begin(), shapes.end(), [&](Id shape) {
    const ShapeGeometry& geometry = scene.shapes[shape].geometry;
    count += primitiveCount(geometry);
    const auto* mesh = std::get_if<TriangleMesh>(&geometry);
    return !std::holds_alternative<CustomShapeSet>(geometry) && (mesh == nullptr || mesh->normals.empty());
  });
  return known && count > 0;
}

FlatPrimitives::FlatPrimitives(const SceneDescription& scene, std::span<const Id> shapes, bool toMeet) {
  std::vector<Id> sorted(shapes.begin(), shapes.end());
  std::sort(sorted.begin(), sorted.end());
  firstOf_.resize(scene.shapes.size());
  std::size_t count = 0;
  for (const Id id : sorted) count += primitiveCount(scene.shapes[id].geometry);
  few_ = toMeet && count <= kMost;
  ids_.reserve(count);
  numbers_.reserve(kNumbers * count);
  for (const Id id : sorted) {
    const ShapeDescription& shape = scene.shapes[id];
    firstOf_[id] = static_cast<std::uint32_t>(ids_.size());
    // As in clusters, a set goes through a special kernel as a whole or not at all.
    const auto* quads = std::get_if<QuadSet>(&shape.geometry);
    const auto* boxes = std::get_if<BoxSet>(&shape.geometry);
    const auto* balls = std::get_if<SphereSet>(&shape.geometry);
    const bool special = (quads && areAligned(*quads)) || (boxes && areUpright(*boxes)) || (balls && areMoving(*balls));
    const auto* mesh = std::get_if<TriangleMesh>(&shape.geometry);
    knowsUv_ = knowsUv_ && (mesh == nullptr || mesh->uvs.empty());
    for (std::size_t i = 0; i < primitiveCount(shape.geometry); ++i) {
      add(shape.geometry, i, special);
      ids_.back().shape = id;
      ids_.back().primitive = static_cast<std::uint32_t>(i);
      ids_.back().material = shape.primitiveMaterials.empty() ? shape.material : shape.primitiveMaterials[i];
    }
  }
}

template <class Shape>
void FlatPrimitives::add(Kind kind, std::vector<Shape>& shapes, const Shape& shape) {
  if (!few_) return;
  const auto entry = static_cast<std::uint32_t>(ids_.size());
  if (runs_.empty() || runs_.back().kind != kind)
    runs_.push_back({kind, entry, entry, static_cast<std::uint32_t>(shapes.size())});
  runs_.back().end = entry + 1;
  shapes.push_back(shape);
}

void FlatPrimitives::describe(Kind pointKind, std::initializer_list<Vec3f> numbers) {
  ids_.push_back({static_cast<std::uint32_t>(pointKind), kNone, kNone, kNone});
  for (const Vec3f v : numbers) numbers_.insert(numbers_.end(), {v.x, v.y, v.z});
  numbers_.resize(kNumbers * ids_.size());
  if (std::find(present_.begin(), present_.end(), pointKind) == present_.end()) present_.push_back(pointKind);
}

void FlatPrimitives::add(const ShapeGeometry& geometry, std::size_t primitive, bool special) {
  if (const auto* quads = std::get_if<QuadSet>(&geometry)) {
    const Quad<float> q = quadAt(*quads, primitive);
    const std::optional<AlignedQuad> alignedQuad = AlignedQuad::of(q);
    if (special) {
      add(Kind::AlignedQuad, alignedQuads_, *alignedQuad);
    } else {
      add(Kind::Quad, quads_, q);
    }
    const ShapePoint<float> on = shapePoint(q, {}, {});
    if (alignedQuad) {
      const Vec3f opposite = q.corner + q.u + q.v;
      describe(Kind::AlignedQuad, {minimum(q.corner, opposite), maximum(q.corner, opposite), on.error, on.normal});
    } else {
      describe(Kind::Quad, {q.corner, q.u, q.v, on.error, on.normal});
    }
  } else if (const auto* balls = std::get_if<SphereSet>(&geometry)) {
    if (special) {
      const MovingSphere<float> s = movingSphereAt(*balls, primitive);
      add(Kind::MovingSphere, movingSpheres_, s);
      describe(Kind::MovingSphere, {s.center, s.move, {s.radius, 0.0f, 0.0f}});
    } else {
      const Sphere<float> s = sphereAt(*balls, primitive);
      add(Kind::Sphere, spheres_, s);
      describe(Kind::Sphere, {s.center, {s.radius, 0.0f, 0.0f}});
    }
  } else if (const auto* boxes = std::get_if<BoxSet>(&geometry)) {
    if (special) {
      const UprightBox<float> b = uprightBoxAt(*boxes, primitive);
      add(Kind::UprightBox, uprightBoxes_, b);
      describe(Kind::UprightBox, {b.center, b.half, {b.axes.cosine, b.axes.sine, 0.0f}});
    } else {
      const Box<float> b = boxAt(*boxes, primitive);
      add(Kind::TurnedBox, turnedBoxes_, b);
      describe(Kind::TurnedBox, {b.center, b.half, b.axes.x, b.axes.y, b.axes.z});
    }
  } else if (const auto* disks = std::get_if<DiskSet>(&geometry)) {
    const Disk<float> d = diskAt(*disks, primitive);
    add(Kind::Disk, disks_, d);
    describe(Kind::Disk, {d.center, d.normal, {d.radius, 0.0f, 0.0f}});
  } else if (const auto* mesh = std::get_if<TriangleMesh>(&geometry)) {
    const Triangle<float> t = triangleAt(*mesh, primitive);
    add(Kind::Triangle, triangles_, t);
    const ShapePoint<float> on = shapePoint(t, {}, {});
    describe(Kind::Triangle, {t.a, t.b, t.c, on.error, on.normal});
  }
}

}  // namespace steradian
