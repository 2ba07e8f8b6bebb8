#pragma once
/// Integrators by name.
#include <memory>
#include <span>
#include <string_view>

#include "steradian/integrators/integrator_spec.h"
#include "steradian/integrators/render/integrator.h"

namespace STERADIAN_API steradian {

/// All integrators with their keys, for --help.
std::span<const IntegratorInfo> integratorRegistry();

/// What a spec asks for.
struct IntegratorChoice {
  std::unique_ptr<const Integrator> integrator;  ///< never null
  ExecutionSettings execution;                   ///< what to render with: RenderSettings::execution
};

/// The integrator that a spec `name{:key=value}` asks for. `execution` is passed on, but the key `width` of `path`
/// takes the place of its width. Throws Error (Usage) with everything that is wrong with the spec, or with the
/// execution settings.
IntegratorChoice makeIntegrator(std::string_view spec, const ExecutionSettings& execution = {});

}  // namespace steradian
