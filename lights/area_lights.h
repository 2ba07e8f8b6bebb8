#pragma once
/// All area lights of a scene: one per emitting primitive, and per instance of it.
#include <optional>
#include <vector>

#include "steradian/lights/area_light.h"

namespace STERADIAN_API steradian {

class AreaLights {
 public:
  /// Lights in the order of shapes placed directly, then of instances; within each, of primitives. Throws Error (Scene)
  /// for emitting custom shapes.
  explicit AreaLights(const SceneDescription& scene);

  std::size_t size() const { return lights_.size(); }
  const AreaLight& operator[](std::size_t i) const { return lights_[i]; }
  /// The SceneDescription::shapes index of a light.
  Id shapeOf(std::size_t i) const { return shapes_[i]; }

  /// Which of them a ray has hit, if any. The instance is the flattened one (see SurfacePoint).
  std::optional<std::size_t> find(const SurfacePoint<float>& hit) const;

 private:
  void add(const SceneDescription& scene, Id shape, const InstanceSet* instances, std::size_t copy);

  struct InstancedShape {
    Id instance, shape;
    std::uint32_t first;
    auto operator<=>(const InstancedShape&) const = default;
  };

  std::vector<AreaLight> lights_;
  std::vector<Id> shapes_;
  std::vector<bool> emits_;                ///< per shape
  std::vector<std::uint32_t> first_;       ///< per shape placed directly: its first light
  std::vector<InstancedShape> instanced_;  ///< sorted
};

/// Which shapes of a description belong to groups: they appear only through instances.
std::vector<bool> shapesInGroups(const SceneDescription& scene);

}  // namespace steradian
