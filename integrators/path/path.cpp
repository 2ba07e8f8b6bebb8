#include "steradian/integrators/path/path.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "steradian/integrators/path/wide_path.h"

namespace steradian {
namespace {

PathPlan planFor(const Scene& scene, const PathSettings& settings) {
  return {
      .strategy = settings.strategy,
      .scatterPdf = settings.scatterPdf,
      // Dimensions are counted up to kMaxDepth bounces; a scene may ask for more, meaning "no limit".
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

/// A set of lights of this scene that samples others than the scene's own does.
LightSet lightsOf(const Scene& scene, LightSetSettings settings) {
  return LightSet(scene.description(), scene.geometry().bounds(), settings);
}

}  // namespace

PathIntegrator::PathIntegrator(const PathSettings& settings) : settings_(settings) {
  Diagnostics wrong;
  const auto share = [&](const char* name, float value) {
    if (!(value >= 0.0f && value <= 1.0f)) wrong.error({}, fmt::format("{} must be in [0, 1], not {}", name, value));
  };
  const auto count = [&](const char* name, std::uint32_t value, std::uint32_t low, std::uint32_t high) {
    if (value < low || value > high) {
      wrong.error({}, fmt::format("{} must be from {} to {}, not {}", name, low, high, value));
    }
  };
  count("the number of light samples", settings.lightSamples, 1, PathSettings::kMaxLightSamples);
  count("the start of roulette", settings.rouletteStart, 0, PathSettings::kMaxDepth);
  count("the largest depth", settings.maxDepth.value_or(0), 0, PathSettings::kMaxDepth);
  share("the strength of roulette", settings.rouletteStrength);
  share("the weight of targets", settings.targetWeight.value_or(0.0f));
  constexpr std::array<std::uint32_t, 5> widths{0, 1, 4, 8, 16};
  if (std::find(widths.begin(), widths.end(), settings.width) == widths.end()) {
    wrong.error({}, fmt::format("the width must be 1, 4, 8 or 16, or 0 for the widest, not {}", settings.width));
  }
  if (settings.reuse < 1 || settings.reuse > PathSettings::kMaxReuse || !std::has_single_bit(settings.reuse)) {
    wrong.error({}, fmt::format("reuse must be 1, 2, 4, 8, 16 or 32, not {}", settings.reuse));
  }
  if (settings.reuse > 1 && (settings.width == 1 || settings.scatterPdf != ScatterPdf::Bsdf)) {
    wrong.error({}, "reuse needs width 0, 4, 8 or 16 and scatter-pdf bsdf");
  }
  wrong.throwIfErrors(ErrorKind::Usage);
}

std::unique_ptr<const Integrator> PathIntegrator::prepare(const Scene& scene) const {
  if (settings_.reuse > 1 && (!scene.volumes().empty() || scene.geometry().dependsOnTime())) {
    throw Error(ErrorKind::Usage,
                "paths are not reused in scenes with media, nested bodies or motion: leave out reuse");
  }
  if (settings_.width == 1) return std::make_unique<PathTracer>(scene, settings_);
  const std::uint32_t width = settings_.width == 0 ? nativeWidth(scene.geometry().isa()) : settings_.width;
  return std::make_unique<WidePathTracer>(scene, settings_, width);
}

void PathIntegrator::renderPass(const RenderJob& job, PassRange pass, Film& film) const {
  prepare(job.scene)->renderPass(job, pass, film);
}

PathTracer::PathTracer(const Scene& scene, const PathSettings& settings) : plan_(planFor(scene, settings)) {
  const Strategy strategy = settings.strategy;
  if (strategy != Strategy::Mis) {
    diracLights_ = lightsOf(scene, {.sampleAreas = false, .sampleSkies = false, .sampleImageSkies = false});
    plan_.lights = plan_.diracLights = &*diracLights_;
  }
  if (strategy == Strategy::Light) {
    lights_ = lightsOf(scene, {.sampleAreas = true, .sampleSkies = true});
    plan_.lights = &*lights_;
  }
  const bool mixes = strategy == Strategy::Mixture;
  if (mixes || strategy == Strategy::Mis) {
    const auto unnamed = mixes ? TargetSet::Unnamed::FlaggedOrLights : TargetSet::Unnamed::FlaggedButLights;
    targets_.emplace(scene.description(), settings.targets, unnamed);
    plan_.targets = &*targets_;
    plan_.targetWeight = targets_->empty() ? 0.0f : settings.targetWeight.value_or(mixes ? 0.5f : 0.25f);
  }
}

Rgb PathTracer::radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const {
  PathCounts counts;
  return evaluate(scene, ray, sampler, counts).radiance;
}

PixelSample PathTracer::evaluate(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler,
                                 PathCounts& counts) const {
  SceneQueries queries(scene, counts);
  return tracePath(plan_, queries, ray, sampler);
}

}  // namespace steradian
