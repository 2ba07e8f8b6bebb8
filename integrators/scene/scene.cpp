#include "steradian/integrators/scene/scene.h"

#include <algorithm>
#include <vector>

#include "steradian/accel/shapes/primitives/shape_at.h"
#include "steradian/core/scene/placements.h"
#include "steradian/integrators/scene/scene_hash.h"
#include "steradian/integrators/volumes/crossings.h"

namespace steradian {
namespace {

std::shared_ptr<const SceneDescription> validated(SceneDescription description) {
  validate(description).throwIfErrors(ErrorKind::Scene);
  return std::make_shared<const SceneDescription>(std::move(description));
}

/// Whether a closed shape may move.
bool interiorsMove(const SceneDescription& scene) {
  return Placements(scene).anyInstanceMoves() ||
         std::any_of(scene.shapes.begin(), scene.shapes.end(), [](const ShapeDescription& shape) {
           if (!shape.interior) return false;
           const auto* spheres = std::get_if<SphereSet>(&shape.geometry);
           return shape.motion || std::holds_alternative<CustomShapeSet>(shape.geometry) ||
                  (spheres && areMoving(*spheres));
         });
}

}  // namespace

Scene::Scene(SceneDescription description, const SceneSettings& settings)
    : description_(validated(std::move(description))),
      hash_(sceneHash(*description_)),
      geometry_(description_, settings.geometry),
      materials_(*description_),
      lights_(*description_, geometry_.bounds(), settings.lights),
      volumes_(*description_) {
  if (volumes_.empty()) return;
  cameraMoves_ = std::holds_alternative<OrthographicCamera>(description_->camera) || interiorsMove(*description_);
  const Vec3f camera = std::visit([](const auto& c) { return c.lookFrom; }, description_->camera);
  if (!cameraMoves_) cameraInterior_ = interiorAt(camera, 0.0f);
}

Scene::FirstSurface Scene::firstSurface(Ray<float> ray, const InteriorStack& interior) const {
  FirstSurface first{{}, 1.0f, interior};
  for (std::uint32_t i = 0; i < Crossings::kMaxCount; ++i) {
    first.point = geometry_.surfacePoint(ray, geometry_.intersect(ray));
    if (!first.point.valid) return first;
    const Boundary boundary = volumes_.boundary(first.point, ray.direction, first.interior);
    first.outsideEta = boundary.outsideEta;
    if (boundary.isReal) return first;
    volumes_.cross(first.point, ray.direction, first.interior);
    ray.tMin = first.point.distance;
  }
  first.point = {};
  return first;
}

InteriorStack Scene::interiorAt(Vec3f position, float time) const {
  std::vector<SurfacePoint<float>> entered, left;
  const auto isSameInterior = [&](const SurfacePoint<float>& a, const SurfacePoint<float>& b) {
    return volumes_.isSameInterior(a, b);
  };
  // Any direction will do; this one is along no wall that people build.
  Ray<float> ray{position, normalize(Vec3f{0.2718f, 0.8642f, 0.4235f}), kInfinity, time};
  for (std::uint32_t i = 0; i < Crossings::kMaxCount; ++i) {
    const Hit<float> hit = geometry_.intersect(ray);
    if (!hit.valid) break;
    const SurfacePoint<float> at = geometry_.surfacePoint(ray, hit);
    if (volumes_.isClosed(at.shape)) {
      const auto same =
          std::find_if(entered.begin(), entered.end(), [&](const auto& e) { return isSameInterior(e, at); });
      if (dot(ray.direction, at.geometricNormal) < 0.0f) {
        entered.push_back(at);
      } else if (same != entered.end()) {
        entered.erase(same);
      } else {
        left.push_back(at);
      }
    }
    ray.tMin = at.distance;
  }
  InteriorStack interior;
  for (auto at = left.rbegin(); at != left.rend(); ++at) volumes_.cross(*at, -at->geometricNormal, interior);
  return interior;
}

}  // namespace steradian
