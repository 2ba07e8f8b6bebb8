#include "steradian/lights/area_lights.h"

#include <algorithm>

#include "steradian/accel/shapes/sampling/sampled_shape_at.h"

namespace steradian {

AreaLights::AreaLights(const SceneDescription& scene)
    : emits_(scene.shapes.size(), false), first_(scene.shapes.size(), kNone) {
  for (Id shape = 0; shape < scene.shapes.size(); ++shape) emits_[shape] = scene.shapes[shape].emission != kNone;
  Placements(scene).forEachShape([&](const ShapePlacement& placed) {
    if (!emits_[placed.shape]) return;
    const auto first = static_cast<std::uint32_t>(lights_.size());
    if (placed.instance) {
      instanced_.push_back({placed.instance->index, placed.shape, first});
    } else {
      first_[placed.shape] = first;
    }
    add(scene, placed);
  });
  std::sort(instanced_.begin(), instanced_.end());
}

void AreaLights::add(const SceneDescription& scene, const ShapePlacement& placed) {
  const ShapeDescription& description = scene.shapes[placed.shape];
  const SurfaceEmission& emission = scene.emissions[description.emission];
  const std::size_t count = primitiveCount(description.geometry);
  for (std::size_t primitive = 0; primitive < count; ++primitive) {
    lights_.emplace_back(sampledShapeOf(description, primitive, placed.instance), emission);
    shapes_.push_back(placed.shape);
  }
}

std::optional<std::size_t> AreaLights::find(const SurfacePoint<float>& hit) const {
  if (hit.shape >= emits_.size() || !emits_[hit.shape]) return std::nullopt;
  if (hit.instance == kNone) return first_[hit.shape] + hit.primitive;
  const auto found = std::lower_bound(instanced_.begin(), instanced_.end(), InstancedShape{hit.instance, hit.shape, 0});
  return found->first + hit.primitive;
}

}  // namespace steradian
