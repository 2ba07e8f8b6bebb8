#include "steradian/lights/light_set.h"

#include <algorithm>
#include <utility>

namespace steradian {
namespace {

/// Radius of the sphere about the bounds; some length for an empty scene, so that a sky keeps its power.
float radiusOf(const Bounds3& bounds) { return bounds.empty() ? 1.0f : maximum(0.5f * length(bounds.extent()), 1e-6f); }

/// A direction may have any length in the description.
DistantLight prepared(const DistantLight& light) { return {normalize(light.direction), light.irradiance}; }

}  // namespace

LightSet::Lights::Lights(const SceneDescription& scene, float radius) : areas(scene), sceneRadius(radius) {
  std::vector<std::uint32_t> infoOfShape(scene.shapes.size(), kNone);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const ShapeDescription& shape = scene.shapes[areas.shapeOf(i)];
    std::uint32_t& entry = infoOfShape[areas.shapeOf(i)];
    if (entry == kNone) {
      entry = static_cast<std::uint32_t>(info.size());
      info.push_back({primitiveName(shape.geometry), shape.name, 0, {}, 0.0f});
    }
    const Rgb watts = areas[i].power();
    ++info[entry].count;
    info[entry].power += watts;
    infoOf.push_back(entry);
    power.push_back(luminance(watts));
  }
  for (const LightDescription& light : scene.lights) {
    if (const auto* point = std::get_if<PointLight>(&light.model))
      add(*point, {"point", light.name, 1, powerOf(*point), 0.0f});
    if (const auto* description = std::get_if<SpotLight>(&light.model)) {
      const PreparedSpot spot(*description);
      add(spot, {"spot", light.name, 1, powerOf(spot), 0.0f});
    }
    if (const auto* distant = std::get_if<DistantLight>(&light.model))
      add(prepared(*distant), {"distant", light.name, 1, powerOf(*distant, radius), 0.0f});
  }
}

void LightSet::Lights::add(const DiracLight& light, LightInfo of) {
  diracs.push_back(light);
  infoOf.push_back(static_cast<std::uint32_t>(info.size()));
  power.push_back(luminance(of.power));
  info.push_back(std::move(of));
}

LightSet::LightSet(const SceneDescription& scene, const Bounds3& sceneBounds, LightSetSettings settings)
    : LightSet(std::make_shared<const Lights>(scene, radiusOf(sceneBounds)),
               Skies(scene, settings.sampleSkies, settings.sampleImageSkies), settings) {}

LightSet::LightSet(const LightSet& lights, LightSetSettings settings)
    : LightSet(lights.lights_, Skies(lights.skies_, settings.sampleSkies, settings.sampleImageSkies), settings) {}

LightSet::LightSet(std::shared_ptr<const Lights> lights, Skies skies, LightSetSettings settings)
    : lights_(std::move(lights)), skies_(std::move(skies)), info_(lights_->info) {
  std::vector<float> weights = lights_->power;
  if (!settings.sampleAreas) std::fill_n(weights.begin(), lights_->areas.size(), 0.0f);
  std::vector<std::uint32_t> infoOf = lights_->infoOf;
  if (hasSky()) {
    weights.push_back(luminance(skies_.sampledPower(lights_->sceneRadius)));
    infoOf.push_back(static_cast<std::uint32_t>(info_.size()));
    info_.push_back({"sky", "", 1, skies_.power(lights_->sceneRadius), 0.0f});
  }
  selection_ = LightSelection(weights);
  for (std::size_t i = 0; i < weights.size(); ++i) info_[infoOf[i]].probability += selection_.probability(i);
}

Emission<float> LightSet::emission(const ScatterPoint<float>& from, const Ray<float>& ray,
                                   const SurfacePoint<float>& hit) const {
  if (!hit.valid) return skyEmission(from, ray.direction);
  const auto index = areas().find(hit);
  if (!index) return {};
  const float probability = selection_.probability(*index);
  if (probability == 0.0f) return {areas()[*index].radiance(ray.direction, hit.geometricNormal), 0.0f};
  Emission<float> found = areas()[*index].emission(from, ray.direction, hit.geometricNormal);
  found.pdf *= probability;
  return found;
}

Rgb LightSet::radiance(const Ray<float>& ray, const SurfacePoint<float>& hit) const {
  if (!hit.valid) return skies_.radiance(ray.direction);
  const auto index = areas().find(hit);
  return index ? areas()[*index].radiance(ray.direction, hit.geometricNormal) : Rgb{};
}

}  // namespace steradian
