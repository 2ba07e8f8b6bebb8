#pragma once
/// A scene that can be rendered.
#include <cstdint>
#include <memory>

#include "steradian/accel/geometry.h"
#include "steradian/core/description.h"
#include "steradian/core/ray_offset.h"
#include "steradian/lights/light_set.h"
#include "steradian/materials/material_set.h"

namespace steradian {

struct SceneSettings {
  GeometrySettings geometry;
  LightSetSettings lights;  ///< of Scene::lights()
};

/// Built from a description; immutable, so that any number of renders may share it. It stays where it is: integrators
/// refer to it.
class Scene {
 public:
  /// Builds with the threads of the caller's tbb::task_arena. Throws Error: Scene with everything that is wrong with
  /// the description (see validate()), Memory.
  explicit Scene(SceneDescription description, const SceneSettings& settings = {});
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  const SceneDescription& description() const { return *description_; }
  const Geometry& geometry() const { return geometry_; }
  const MaterialSet& materials() const { return materials_; }
  const LightSet& lights() const { return lights_; }
  /// See scene_hash.h.
  std::uint64_t hash() const { return hash_; }

 private:
  std::shared_ptr<const SceneDescription> description_;
  std::uint64_t hash_;
  Geometry geometry_;
  MaterialSet materials_;
  LightSet lights_;
};

/// The point of a surface, as somewhere to gather light at.
template <class F>
ScatterPoint<F> scatterPoint(const SurfacePoint<F>& surface, F time) {
  return {surface.position, surface.positionError, surface.geometricNormal, time};
}

}  // namespace steradian
