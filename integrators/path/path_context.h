#pragma once
/// What the path integrator prepares for one scene.
#include <optional>

#include "steradian/core/base/api.h"
#include "steradian/integrators/path/path_settings.h"
#include "steradian/integrators/scene/scene.h"
#include "steradian/lights/light_set.h"
#include "steradian/lights/target_set.h"

namespace STERADIAN_API steradian {

/// The settings as they apply to one scene: everything that the user left open is decided.
struct PathPlan {
  Strategy strategy;
  ScatterPdf scatterPdf;
  std::uint32_t maxDepth, lightSamples, rouletteStart;
  float rouletteStrength;
  std::uint32_t reuse = 1;      ///< see PathSettings
  float targetWeight;           ///< probability of aiming at a target; 0 where there is no target
  const LightSet* lights;       ///< sampled at vertices, and asked for the emission that rays find
  const LightSet* diracLights;  ///< sampled at vertices where PathVertex::lightSampled is false
  const TargetSet* targets;     ///< null where targetWeight is 0
};

/// The plan, and the sets of lights and targets that it points to. The area lights are those of the scene's own set;
/// sets that sample other lights share them.
class PathContext {
 public:
  /// The scene must outlive this. Throws Error (Usage) for a target that is neither a shape of the scene nor "lights".
  PathContext(const Scene& scene, const PathSettings& settings);
  PathContext(const PathContext&) = delete;  // the plan points into it
  PathContext& operator=(const PathContext&) = delete;

  const Scene& scene() const { return scene_; }
  const PathPlan& plan() const { return plan_; }

 private:
  const Scene& scene_;
  std::optional<LightSet> allLights_, diracLights_;  ///< only where the strategy needs other sets than the scene's
  std::optional<TargetSet> targets_;
  PathPlan plan_;
};

}  // namespace steradian
