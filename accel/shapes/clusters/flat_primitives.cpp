#include "steradian/accel/shapes/clusters/flat_primitives.h"

#include <algorithm>

namespace steradian {

bool FlatPrimitives::fits(const SceneDescription& scene, std::span<const Id> shapes) {
  std::size_t count = 0;
  for (const Id shape : shapes) {
    const ShapeGeometry& geometry = scene.shapes[shape].geometry;
    if (std::holds_alternative<CustomShapeSet>(geometry)) return false;
    count += primitiveCount(geometry);
  }
  return count > 0 && count <= kMaxCount;
}

FlatPrimitives::FlatPrimitives(const SceneDescription& scene, std::span<const Id> shapes) {
  std::vector<Id> sorted(shapes.begin(), shapes.end());
  std::sort(sorted.begin(), sorted.end());
  for (const Id id : sorted) {
    const ShapeDescription& shape = scene.shapes[id];
    LeafKinds::forEach([&]<class Leaf>() {
      const auto* set = setOf<Leaf>(shape.geometry);
      if (!set) return;
      for (std::size_t i = 0; i < primitiveCount(shape.geometry); ++i) {
        add<Leaf>(Leaf::at(*set, i));
        PointRecord& record = records_.back();
        record.shape = id;
        record.primitive = static_cast<std::uint32_t>(i);
        record.material = shape.primitiveMaterials.empty() ? shape.material : shape.primitiveMaterials[i];
      }
    });
  }
}

template <class Leaf>
void FlatPrimitives::add(const typename Leaf::Shape& shape) {
  constexpr std::uint32_t kind = LeafKinds::indexOf<Leaf>();
  Of<Leaf>& shapes = std::get<Member<Leaf>>(shapes_).shapes;
  const auto entry = static_cast<std::uint32_t>(records_.size());
  if (runs_.empty() || runs_.back().kind != kind)
    runs_.push_back({kind, entry, entry, static_cast<std::uint32_t>(shapes.size())});
  runs_.back().end = entry + 1;
  shapes.push_back(Leaf::flat(shape));
  fillRecord<Leaf>(records_.emplace_back(), shape);
  kinds_ |= bitOf(records_.back());
}

}  // namespace steradian
