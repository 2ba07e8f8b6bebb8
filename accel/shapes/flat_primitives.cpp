#include "steradian/accel/shapes/flat_primitives.h"

#include <algorithm>
#include <array>

#include "steradian/accel/shapes/shape_at.h"

namespace steradian {
namespace {

/// A set of boxes is upright as a whole or not at all, as its clusters are.
bool isUpright(const BoxSet& set) {
  for (std::size_t i = 0; i < set.centerX.size(); ++i) {
    if (!isUpright(set, i)) return false;
  }
  return true;
}

}  // namespace

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

FlatPrimitives::FlatPrimitives(const SceneDescription& scene, std::span<const Id> shapes) {
  std::vector<Id> sorted(shapes.begin(), shapes.end());
  std::sort(sorted.begin(), sorted.end());
  std::size_t count = 0;
  for (const Id shape : sorted) count += primitiveCount(scene.shapes[shape].geometry);
  values_.resize(kRows * count);
  kinds_.reserve(count);
  for (const Id id : sorted) {
    const ShapeDescription& shape = scene.shapes[id];
    for (std::size_t i = 0; i < primitiveCount(shape.geometry); ++i) {
      add(shape.geometry, i);
      shape_.push_back(id);
      primitive_.push_back(static_cast<std::uint32_t>(i));
      material_.push_back(shape.primitiveMaterials.empty() ? shape.material : shape.primitiveMaterials[i]);
    }
  }
}

void FlatPrimitives::add(Kind kind, std::size_t index, std::span<const float> values) {
  const auto entry = static_cast<std::uint32_t>(kinds_.size());
  const std::size_t count = values_.size() / kRows;
  for (std::size_t row = 0; row < values.size(); ++row) values_[row * count + entry] = values[row];
  kinds_.push_back(static_cast<std::uint32_t>(kind));
  if (std::find(present_.begin(), present_.end(), kind) == present_.end()) present_.push_back(kind);
  if (runs_.empty() || runs_.back().kind != kind)
    runs_.push_back({kind, entry, entry, static_cast<std::uint32_t>(index)});
  runs_.back().end = entry + 1;
}

void FlatPrimitives::add(const ShapeGeometry& geometry, std::size_t primitive) {
  const auto keep = [&](Kind kind, auto& shapes, const auto& shape, std::initializer_list<Vec3f> vectors, float last) {
    std::vector<float> values;
    for (const Vec3f v : vectors) values.insert(values.end(), {v.x, v.y, v.z});
    if (values.size() < kRows) values.push_back(last);
    shapes.push_back(shape);
    add(kind, shapes.size() - 1, values);
  };
  if (const auto* set = std::get_if<QuadSet>(&geometry)) {
    const Quad<float> q = quadAt(*set, primitive);
    keep(Kind::Quad, quads_, q, {q.corner, q.u, q.v}, 0.0f);
  } else if (const auto* balls = std::get_if<SphereSet>(&geometry)) {
    const Sphere<float> s = sphereAt(*balls, primitive);
    keep(Kind::Sphere, spheres_, s, {s.center}, s.radius);
  } else if (const auto* boxes = std::get_if<BoxSet>(&geometry)) {
    const Box<float> b = boxAt(*boxes, primitive);
    if (isUpright(*boxes)) {
      keep(Kind::UprightBox, uprightBoxes_, uprightBoxAt(*boxes, primitive),
           {b.center, b.half, b.axes.x, b.axes.y, b.axes.z}, 0.0f);
    } else {
      keep(Kind::TurnedBox, turnedBoxes_, b, {b.center, b.half, b.axes.x, b.axes.y, b.axes.z}, 0.0f);
    }
  } else if (const auto* disks = std::get_if<DiskSet>(&geometry)) {
    const Disk<float> d = diskAt(*disks, primitive);
    keep(Kind::Disk, disks_, d, {d.center, d.normal}, d.radius);
  } else if (const auto* mesh = std::get_if<TriangleMesh>(&geometry)) {
    const Triangle<float> t = triangleAt(*mesh, primitive);
    keep(Kind::Triangle, triangles_, t, {t.a, t.b, t.c}, 0.0f);
  }
}

}  // namespace steradian
