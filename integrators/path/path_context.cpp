#include "steradian/integrators/path/path_context.h"

#include <algorithm>

namespace steradian {
namespace {

PathPlan planFor(const Scene& scene, const PathSettings& settings) {
  return {
      .strategy = settings.strategy,
      .scatterPdf = settings.scatterPdf,
      // Random numbers have dimensions for kMaxDepth bounces; a scene may ask for more, meaning "no limit".
      .maxDepth =
          std::min(settings.maxDepth.value_or(static_cast<std::uint32_t>(scene.description().defaults.maxDepth)),
                   PathSettings::kMaxDepth),
      .lightSamples = settings.lightSamples,
      .rouletteStart = settings.rouletteStart,
      .rouletteStrength = settings.rouletteStrength,
      .reuse = settings.reuse,
      .targetWeight = 0.0f,
      .lights = &scene.lights(),
      .diracLights = &scene.lights(),
      .targets = nullptr,
  };
}

/// The scene's lights, sampled by other settings.
LightSet resampled(const Scene& scene, LightSetSettings settings) { return LightSet(scene.lights(), settings); }

}  // namespace

PathContext::PathContext(const Scene& scene, const PathSettings& settings)
    : scene_(scene), plan_(planFor(scene, settings)) {
  const Strategy strategy = settings.strategy;
  if (strategy != Strategy::Mis) {
    diracLights_.emplace(resampled(scene, {.sampleAreas = false, .sampleSkies = false, .sampleImageSkies = false}));
    plan_.lights = plan_.diracLights = &*diracLights_;
  }
  if (strategy == Strategy::Light) {
    allLights_.emplace(resampled(scene, {.sampleAreas = true, .sampleSkies = true}));
    plan_.lights = &*allLights_;
  }
  const bool mixes = strategy == Strategy::Mixture;
  if (mixes || strategy == Strategy::Mis) {
    const auto unnamed = mixes ? TargetSet::Unnamed::FlaggedOrLights : TargetSet::Unnamed::FlaggedNonEmitters;
    targets_.emplace(scene.description(), scene.lights().areas(), settings.targets, unnamed);
    plan_.targets = &*targets_;
    plan_.targetWeight = targets_->empty() ? 0.0f : settings.targetWeight.value_or(mixes ? 0.5f : 0.25f);
  }
}

}  // namespace steradian
