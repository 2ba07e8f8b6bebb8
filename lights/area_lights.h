#pragma once
/// All area lights of a scene: one per emitting primitive, and per instance of it.
#include <optional>
#include <vector>

#include "steradian/core/scene/placements.h"
#include "steradian/lights/area_light.h"

namespace STERADIAN_API steradian {

class AreaLights {
 public:
  /// Lights in the flattened order of shapes (see core/scene/placements.h), and for each in the order of its
  /// primitives. Throws Error (Scene) for emitting custom shapes.
  explicit AreaLights(const SceneDescription& scene);

  std::size_t size() const { return lights_.size(); }
  const AreaLight& operator[](std::size_t i) const { return lights_[i]; }
  /// The SceneDescription::shapes index of a light.
  Id shapeOf(std::size_t i) const { return shapes_[i]; }

  /// The light that a ray has hit, if the surface emits.
  std::optional<std::size_t> find(const SurfacePoint<float>& hit) const;

 private:
  void add(const SceneDescription& scene, const ShapePlacement& placed);

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

}  // namespace steradian
