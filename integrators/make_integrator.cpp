#include "steradian/integrators/make_integrator.h"

#include <array>
#include <limits>
#include <utility>

#include "steradian/integrators/auxiliary/aov.h"
#include "steradian/integrators/path/path.h"

namespace steradian {
namespace {

constexpr std::array<std::string_view, 4> kStrategies{"bsdf", "light", "mis", "mixture"};
constexpr std::array<std::string_view, 4> kScatterPdfs{"bsdf", "cosine", "hemisphere", "sphere"};

constexpr std::array kPathKeys{
    IntegratorKey{"strategy", "mis", "how light is found: bsdf|light|mis|mixture"},
    IntegratorKey{"max-depth", "the scene's", "bounces; 0: emission only"},
    IntegratorKey{"light-samples", "1", "shadow rays per vertex"},
    IntegratorKey{"scatter-pdf", "bsdf", "what proposes scattered directions: bsdf|cosine|hemisphere|sphere"},
    IntegratorKey{"roulette-start", "4", "bounces before paths may be ended by chance"},
    IntegratorKey{"roulette-strength", "0.4", "0: never end them; 1: survival as probable as the path is bright"},
    IntegratorKey{"target-weight", "0.5", "mixture, mis (there 0.25): probability of a target; 1 loses other light"},
    IntegratorKey{"targets", "the scene's", "mixture, mis: names of shapes, or lights; separated by commas"},
    IntegratorKey{"reuse", "1", "2, 4, 8, 16 or 32 neighbours share paths: less noise, but correlated pixels"},
    IntegratorKey{"width", "0", "paths traced at once: 1, 4, 8 or 16; 0: as many as pay here"},
};
constexpr std::array kOcclusionKeys{
    IntegratorKey{"distance", "inf", "what is farther does not occlude; scene units"},
};
constexpr std::array kRegistry{
    IntegratorInfo{"path", "path tracing with four strategies for direct light", kPathKeys},
    IntegratorInfo{"normals", "(n + 1) / 2 of the normal that faces the camera", {}},
    IntegratorInfo{"albedo", "the colour of materials", {}},
    IntegratorInfo{"depth", "distance from the camera", {}},
    IntegratorInfo{"ambient-occlusion", "how open the hemisphere above each point is", kOcclusionKeys},
};

PathSettings readPathSettings(IntegratorSpec& spec) {
  PathSettings settings;
  spec.read("strategy", settings.strategy, kStrategies);
  spec.read("max-depth", settings.maxDepth, 0u, PathSettings::kMaxDepth);
  spec.read("light-samples", settings.lightSamples, 1u, PathSettings::kMaxLightSamples);
  spec.read("scatter-pdf", settings.scatterPdf, kScatterPdfs);
  spec.read("roulette-start", settings.rouletteStart, 0u, PathSettings::kMaxDepth);
  spec.read("roulette-strength", settings.rouletteStrength, 0.0f, 1.0f);
  spec.read("target-weight", settings.targetWeight, 0.0f, 1.0f);
  spec.read("targets", settings.targets);
  spec.read("reuse", settings.reuse, 1u, PathSettings::kMaxReuse);
  if (settings.strategy != Strategy::Mixture && settings.strategy != Strategy::Mis) {
    for (const std::string_view key : {"target-weight", "targets"}) spec.refuse(key, "needs strategy=mis or mixture");
  }
  return settings;
}

}  // namespace

std::span<const IntegratorInfo> integratorRegistry() { return kRegistry; }

IntegratorChoice makeIntegrator(std::string_view text, const ExecutionSettings& given) {
  IntegratorSpec spec(text);
  const IntegratorInfo* info = spec.find(kRegistry);
  const std::string_view name = info == nullptr ? std::string_view() : info->name;
  PathSettings path;
  ExecutionSettings execution = given;
  float distance = kInfinity;
  if (name == "path") {
    path = readPathSettings(spec);
    spec.read("width", execution.width, 0u, 16u);
  }
  if (name == "ambient-occlusion") spec.read("distance", distance, std::numeric_limits<float>::min(), kInfinity);
  spec.throwIfWrong();
  if (name != "path") requireUsable(execution);

  if (name == "normals") return {std::make_unique<NormalIntegrator>(), execution};
  if (name == "albedo") return {std::make_unique<AlbedoIntegrator>(), execution};
  if (name == "depth") return {std::make_unique<DepthIntegrator>(), execution};
  if (name == "ambient-occlusion") return {std::make_unique<AmbientOcclusionIntegrator>(distance), execution};
  auto integrator = std::make_unique<PathIntegrator>(path);
  integrator->requireUsable(execution);
  return {std::move(integrator), execution};
}

}  // namespace steradian
