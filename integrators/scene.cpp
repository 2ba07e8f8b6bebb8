#include "steradian/integrators/scene.h"

#include "steradian/integrators/scene_hash.h"

namespace steradian {
namespace {

std::shared_ptr<const SceneDescription> validated(SceneDescription description) {
  validate(description).throwIfErrors(ErrorKind::Scene);
  return std::make_shared<const SceneDescription>(std::move(description));
}

}  // namespace

Scene::Scene(SceneDescription description, const SceneSettings& settings)
    : description_(validated(std::move(description))),
      hash_(sceneHash(*description_)),
      geometry_(description_, settings.geometry),
      materials_(*description_),
      lights_(*description_, geometry_.bounds(), settings.lights) {}

}  // namespace steradian
