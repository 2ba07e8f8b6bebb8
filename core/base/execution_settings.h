#pragma once
/// What a user may choose about how code is executed: it affects speed only, never the picture.
#include <cstdint>

#include "steradian/core/base/api.h"
#include "steradian/core/base/diagnostics.h"
#include "steradian/core/base/isa.h"

namespace STERADIAN_API steradian {

/// With which instructions a render runs, and how many paths it traces at once. Threads are not part of it: they are
/// those of the caller's tbb::task_arena. Queries about the geometry have an instruction set of their own, which is
/// chosen when the scene is built (GeometrySettings::isa).
struct ExecutionSettings {
  /// Instruction set of the kernels; must be usable on this processor (core/base/isa.h).
  Isa isa = bestIsa();
  /// Paths that one thread traces at once: 1, 4, 8 or 16; 0: as many as an instruction of `isa` holds floats.
  /// Integrators of a single width ignore it.
  std::uint32_t width = 0;
};

/// Adds what is wrong with the settings to `wrong`.
void check(const ExecutionSettings& settings, Diagnostics& wrong);
/// Throws Error (Usage) with everything that is wrong with the settings.
void requireUsable(const ExecutionSettings& settings);

}  // namespace steradian
