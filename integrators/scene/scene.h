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
  const Volumes& volumes() const { return volumes_; }
  /// The closed shapes that a camera ray starts in. (Those that the camera is in; a lens is taken to be in them with
  /// its whole area.)
  InteriorStack interiorAtStart(const Ray<float>& cameraRay) const {
    return cameraMoves_ ? interiorAt(cameraRay.origin, cameraRay.time) : cameraInterior_;
  }
  /// The closed shapes that a point is inside of, by what a ray from there to infinity leaves without having entered
  /// it; those that it leaves first were entered last.
  InteriorStack interiorAt(Vec3f position, float time) const;

  struct FirstSurface {
    SurfacePoint<float> point;  ///< its distance is that from the origin of the ray asked for
    float outsideEta = 1.0f;    ///< see Boundary
    InteriorStack interior;     ///< that the ray is inside of where it arrives
  };
  /// The first surface that is one to a ray that starts inside of `interior`; media are left aside.
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
