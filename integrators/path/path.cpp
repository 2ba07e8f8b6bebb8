#include "steradian/integrators/path/path.h"

#include <fmt/format.h>

#include <bit>

#include "steradian/integrators/path/path_context.h"
#include "steradian/integrators/path/path_loop.h"
#include "steradian/integrators/path/wide_path.h"

namespace steradian {
namespace {

/// Traces the paths of one scene one at a time.
class ScalarPathTracer final : public PreparedSampleIntegrator {
 public:
  ScalarPathTracer(const Scene& scene, const PathSettings& settings) : context_(scene, settings) {}

  PixelSample evaluate(const Ray<float>& ray, const Sampler<float>& sampler, PathCounts& counts) const override {
    SceneQueries queries(context_.scene(), counts);
    return tracePath(context_.plan(), queries, ray, sampler);
  }

 private:
  PathContext context_;
};

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
  if (settings.reuse < 1 || settings.reuse > PathSettings::kMaxReuse || !std::has_single_bit(settings.reuse)) {
    wrong.error({}, fmt::format("reuse must be 1, 2, 4, 8, 16 or 32, not {}", settings.reuse));
  }
  if (settings.reuse > 1 && settings.scatterPdf != ScatterPdf::Bsdf) wrong.error({}, "reuse needs scatter-pdf bsdf");
  wrong.throwIfErrors(ErrorKind::Usage);
}

void PathIntegrator::requireUsable(const ExecutionSettings& execution) const {
  Diagnostics wrong;
  check(execution, wrong);
  if (settings_.reuse > 1 && execution.width == 1) wrong.error({}, "reuse needs width 0, 4, 8 or 16");
  wrong.throwIfErrors(ErrorKind::Usage);
}

std::unique_ptr<const PreparedIntegrator> PathIntegrator::prepare(const Scene& scene,
                                                                  const ExecutionSettings& execution) const {
  requireUsable(execution);
  if (settings_.reuse > 1 && (!scene.volumes().empty() || scene.geometry().dependsOnTime())) {
    throw Error(ErrorKind::Usage,
                "paths are not reused in scenes with media, nested bodies or motion: leave out reuse");
  }
  if (execution.width == 1) return std::make_unique<ScalarPathTracer>(scene, settings_);
  return std::make_unique<WidePathTracer>(scene, settings_, execution);
}

}  // namespace steradian
