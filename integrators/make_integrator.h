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

/// The integrator that a spec `name{:key=value}` asks for. Throws Error (Usage) with everything that is wrong with it.
std::unique_ptr<Integrator> makeIntegrator(std::string_view spec);

}  // namespace steradian
