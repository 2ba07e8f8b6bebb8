#pragma once
/// The direct-light strategies of the path integrator, against one another and against known values.
#include "steradian/integrators/path/path.h"
#include "steradian/tests/integrators/estimate.h"

namespace steradian::test {

inline constexpr Strategy kStrategies[]{Strategy::Mis, Strategy::Bsdf, Strategy::Light, Strategy::Mixture};

inline PathSettings with(Strategy strategy, ScatterPdf pdf = ScatterPdf::Bsdf) {
  PathSettings settings;
  settings.strategy = strategy;
  settings.scatterPdf = pdf;
  return settings;
}

/// All strategies against `mis`, in pictures of `size` x `size` pixels; each has random numbers of its own.
void expectStrategiesAgree(const SceneDescription& description, std::uint32_t samplesPerPixel, int size = 24);

/// Every strategy finds this mean luminance.
void expectRadiance(const SceneDescription& description, double expected);

}  // namespace steradian::test
