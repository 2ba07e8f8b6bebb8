#include "steradian/accel/shapes/clusters/flat_primitives.h"

#include <algorithm>

#include "steradian/accel/shapes/primitives/shape_at.h"

namespace steradian {

bool FlatPrimitives::holds(const SceneDescription& scene, std::span<const Id> shapes) {
  std::size_t count = 0;
  for (const Id shape : shapes) count += primitiveCount(scene.shapes[shape].geometry);
  return count > 0 && count <= kMost && haveRecords(scene, shapes);
}

FlatPrimitives::FlatPrimitives(const SceneDescription& scene, std::span<const Id> shapes) {
  std::vector<Id> sorted(shapes.begin(), shapes.end());
  std::sort(sorted.begin(), sorted.end());
  for (const Id id : sorted) {
    const ShapeDescription& shape = scene.shapes[id];
    const LeafShapes leaves(shape.geometry);
    for (std::size_t i = 0; i < primitiveCount(shape.geometry); ++i) {
      add(leaves[i]);
      PointRecord& record = records_.back();
      record.shape = id;
      record.primitive = static_cast<std::uint32_t>(i);
      record.material = shape.primitiveMaterials.empty() ? shape.material : shape.primitiveMaterials[i];
    }
  }
}

template <class Shape>
void FlatPrimitives::add(PointKind kind, std::vector<Shape>& shapes, const Shape& shape) {
  const auto entry = static_cast<std::uint32_t>(records_.size());
  if (runs_.empty() || runs_.back().kind != kind)
    runs_.push_back({kind, entry, entry, static_cast<std::uint32_t>(shapes.size())});
  runs_.back().end = entry + 1;
  shapes.push_back(shape);
}

void FlatPrimitives::add(const LeafShape& shape) {
  struct Visitor {
    FlatPrimitives& self;
    void operator()(const Quad<float>& q) const { self.add(PointKind::Quad, self.quads_, q); }
    void operator()(const AlignedQuad& q) const { self.add(PointKind::AlignedQuad, self.alignedQuads_, q); }
    void operator()(const Sphere<float>& s) const { self.add(PointKind::Sphere, self.spheres_, s); }
    void operator()(const MovingSphere<float>& s) const { self.add(PointKind::MovingSphere, self.movingSpheres_, s); }
    void operator()(const UprightBox<float>& b) const { self.add(PointKind::UprightBox, self.uprightBoxes_, b); }
    void operator()(const TurnedBox& b) const { self.add(PointKind::TurnedBox, self.turnedBoxes_, boxOf(b)); }
    void operator()(const Disk<float>& d) const { self.add(PointKind::Disk, self.disks_, d); }
    void operator()(const Triangle<float>& t) const { self.add(PointKind::Triangle, self.triangles_, t); }
  };
  std::visit(Visitor{*this}, shape);
  PointRecord& record = records_.emplace_back();
  std::visit([&](const auto& s) { fillRecord(record, s); }, shape);
  kinds_ |= bitOf(record);
}

}  // namespace steradian
