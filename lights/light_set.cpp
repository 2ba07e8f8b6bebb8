#include "steradian/lights/light_set.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace steradian {
namespace {

/// Radius of the sphere about the bounds; some length for an empty scene, so that a sky keeps its power.
float radiusOf(const Bounds3& bounds) { return bounds.empty() ? 1.0f : maximum(0.5f * length(bounds.extent()), 1e-6f); }

/// A direction may have any length in the description.
DistantLight prepared(const DistantLight& light) { return {normalize(light.direction), light.irradiance}; }

}  // namespace

LightSet::LightSet(const SceneDescription& scene, const Bounds3& sceneBounds, LightSetSettings settings)
    : LightSet(std::make_shared<const AreaLights>(scene), scene, sceneBounds, settings) {}

LightSet::LightSet(const LightSet& other, const SceneDescription& scene, const Bounds3& sceneBounds,
                   LightSetSettings settings)
    : LightSet(other.areas_, scene, sceneBounds, settings) {}

LightSet::LightSet(std::shared_ptr<const AreaLights> areas, const SceneDescription& scene, const Bounds3& sceneBounds,
                   LightSetSettings settings)
    : areas_(std::move(areas)), skies_(scene, settings.sampleSkies, settings.sampleImageSkies) {
  std::vector<Weighed> weighed;
  listAreas(scene, settings.sampleAreas, weighed);
  listOthers(scene, radiusOf(sceneBounds), weighed);
  std::vector<float> weights;
  weights.reserve(weighed.size());
  for (const Weighed& w : weighed) weights.push_back(w.weight);
  selection_ = LightSelection(weights);
  for (std::size_t i = 0; i < weighed.size(); ++i) info_[weighed[i].entry].probability += selection_.probability(i);
}

void LightSet::listAreas(const SceneDescription& scene, bool sampled, std::vector<Weighed>& weighed) {
  std::vector<std::size_t> entryOfShape(scene.shapes.size(), kNone);
  for (std::size_t i = 0; i < areas_->size(); ++i) {
    const ShapeDescription& shape = scene.shapes[areas_->shapeOf(i)];
    std::size_t& entry = entryOfShape[areas_->shapeOf(i)];
    if (entry == kNone) {
      entry = info_.size();
      info_.push_back({primitiveName(shape.geometry), shape.name, 0, {}, 0.0f});
    }
    const Rgb power = (*areas_)[i].power();
    ++info_[entry].count;
    info_[entry].power += power;
    weighed.push_back({entry, sampled ? luminance(power) : 0.0f});
  }
}

void LightSet::listOthers(const SceneDescription& scene, float sceneRadius, std::vector<Weighed>& weighed) {
  const auto addDirac = [&](const auto& light, const char* kind, const std::string& name) {
    Rgb power;
    if constexpr (std::is_same_v<std::decay_t<decltype(light)>, DistantLight>) {
      power = powerOf(light, sceneRadius);
    } else {
      power = powerOf(light);
    }
    diracs_.push_back(light);
    weighed.push_back({info_.size(), luminance(power)});
    info_.push_back({kind, name, 1, power, 0.0f});
  };
  for (const LightDescription& light : scene.lights) {
    if (const auto* point = std::get_if<PointLight>(&light.model)) addDirac(*point, "point", light.name);
    if (const auto* spot = std::get_if<SpotLight>(&light.model)) addDirac(PreparedSpot(*spot), "spot", light.name);
    if (const auto* far = std::get_if<DistantLight>(&light.model)) addDirac(prepared(*far), "distant", light.name);
  }
  if (!hasSky()) return;
  weighed.push_back({info_.size(), luminance(skies_.sampledPower(sceneRadius))});
  info_.push_back({"sky", "", 1, skies_.power(sceneRadius), 0.0f});
}

Emission<float> LightSet::emission(const ScatterPoint<float>& from, const Ray<float>& ray,
                                   const SurfacePoint<float>& hit) const {
  if (!hit.valid) return skyEmission(from, ray.direction);
  const auto index = areas_->find(hit);
  if (!index) return {};
  const float probability = selection_.probability(*index);
  if (probability == 0.0f) return {(*areas_)[*index].radiance(ray.direction, hit.geometricNormal), 0.0f};
  Emission<float> found = (*areas_)[*index].emission(from, ray.direction, hit.geometricNormal);
  found.pdf *= probability;
  return found;
}

Rgb LightSet::radiance(const Ray<float>& ray, const SurfacePoint<float>& hit) const {
  if (!hit.valid) return skies_.radiance(ray.direction);
  const auto index = areas_->find(hit);
  return index ? (*areas_)[*index].radiance(ray.direction, hit.geometricNormal) : Rgb{};
}

}  // namespace steradian
