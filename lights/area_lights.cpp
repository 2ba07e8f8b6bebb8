#include "steradian/lights/area_lights.h"

#include <algorithm>

#include "steradian/accel/shapes/sampling/sampled_shape_at.h"

namespace steradian {

std::vector<bool> shapesInGroups(const SceneDescription& scene) {
  std::vector<bool> inGroup(scene.shapes.size(), false);
  for (const Group& group : scene.groups) {
    for (const Id shape : group.shapes) inGroup[shape] = true;
  }
  return inGroup;
}

AreaLights::AreaLights(const SceneDescription& scene)
    : emits_(scene.shapes.size(), false), first_(scene.shapes.size(), kNone) {
  const std::vector<bool> inGroup = shapesInGroups(scene);
  for (Id shape = 0; shape < scene.shapes.size(); ++shape) {
    emits_[shape] = scene.shapes[shape].emission != kNone;
    if (!emits_[shape] || inGroup[shape]) continue;
    first_[shape] = static_cast<std::uint32_t>(lights_.size());
    add(scene, shape, nullptr, 0);
  }
  Id instance = 0;
  for (const InstanceSet& set : scene.instances) {
    for (std::size_t copy = 0; copy < set.transforms.size(); ++copy) {
      for (const Id shape : scene.groups[set.group].shapes) {
        if (!emits_[shape]) continue;
        instanced_.push_back({instance, shape, static_cast<std::uint32_t>(lights_.size())});
        add(scene, shape, &set, copy);
      }
      ++instance;
    }
  }
  std::sort(instanced_.begin(), instanced_.end());
}

void AreaLights::add(const SceneDescription& scene, Id shape, const InstanceSet* instances, std::size_t copy) {
  const ShapeDescription& description = scene.shapes[shape];
  const SurfaceEmission& emission = scene.emissions[description.emission];
  const std::size_t count = primitiveCount(description.geometry);
  for (std::size_t primitive = 0; primitive < count; ++primitive) {
    lights_.emplace_back(sampledShapeOf(description, primitive, instances, copy), emission);
    shapes_.push_back(shape);
  }
}

std::optional<std::size_t> AreaLights::find(const SurfacePoint<float>& hit) const {
  if (hit.shape >= emits_.size() || !emits_[hit.shape]) return std::nullopt;
  if (hit.instance == kNone) return first_[hit.shape] + hit.primitive;
  const auto found = std::lower_bound(instanced_.begin(), instanced_.end(), InstancedShape{hit.instance, hit.shape, 0});
  return found->first + hit.primitive;
}

}  // namespace steradian
