#pragma once
/// A scene that can be rendered.
#include <cstdint>
#include <memory>

#include "steradian/accel/geometry.h"
#include "steradian/core/scene/description.h"
#include "steradian/core/transport/ray_offset.h"
#include "steradian/integrators/volumes/volumes.h"
#include "steradian/lights/light_set.h"
#include "steradian/materials/material_set.h"

namespace STERADIAN_API steradian {

struct SceneSettings {
  GeometrySettings geometry;  ///< `isa`: the instruction set of queries; that of renders: RenderSettings::execution
  LightSetSettings lights;    ///< of Scene::lights()
};

/// Built from a description; immutable, so that any number of renders may share it. It cannot be moved, because
/// prepared integrators refer to it.
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
  const Volumes& volumes() const { return volumes_; }
  /// The closed shapes that a camera ray starts in: those that the camera is in. (If a lens lies in a shape only in
  /// part, its centre decides.)
  InteriorStack interiorAtStart(const Ray<float>& cameraRay) const {
    return cameraMoves_ ? interiorAt(cameraRay.origin, cameraRay.time) : cameraInterior_;
  }
  /// The closed shapes that a point is inside of: those that a ray from there to infinity leaves without having entered
  /// them. The shape that it leaves first counts as entered last.
  InteriorStack interiorAt(Vec3f position, float time) const;

  struct FirstSurface {
    SurfacePoint<float> point;  ///< its distance is that from the origin of the ray asked for
    float outsideEta = 1.0f;    ///< see Boundary
    InteriorStack interior;     ///< the closed shapes that the ray is inside of when it arrives there
  };
  /// The first surface that stops a ray which starts inside of the shapes `interior` (see Boundary::isReal). Media do
  /// not count.
  FirstSurface firstSurface(Ray<float> ray, const InteriorStack& interior) const;
  /// See scene_hash.h.
  std::uint64_t hash() const { return hash_; }

 private:
  std::shared_ptr<const SceneDescription> description_;
  std::uint64_t hash_;
  Geometry geometry_;
  MaterialSet materials_;
  LightSet lights_;
  Volumes volumes_;
  bool cameraMoves_ = false;  ///< camera rays may start in different bodies
  InteriorStack cameraInterior_;
};

/// The point of a surface, as somewhere to gather light at.
template <class F>
ScatterPoint<F> scatterPoint(const SurfacePoint<F>& surface, F time) {
  return {surface.position, surface.positionError, surface.geometricNormal, time};
}

}  // namespace steradian
