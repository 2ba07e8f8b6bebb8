#pragma once
/// The instruction sets that hot code is compiled for.
///
/// Code that takes the time of a render is in files named *_kernels.isa.cpp, with the templates that they instantiate.
/// Each is compiled once per instruction set and offers one table of functions, in the namespace of that set: a
/// constant such as avx2::filmKernels, which filmKernels(Isa) in film_kernels.cpp finds. All other names in such an
/// object are local to it (cmake/SteradianIsa.cmake), so that no function compiled for one set can stand in for that of
/// another when a program is linked. All other code is compiled for the baseline. The bits of a picture are the same
/// with every set.
///
/// Where the build is for one target alone (STERADIAN_ARCH, or a processor other than x86-64) there is only the
/// baseline: that target.
#include <span>
#include <string_view>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

enum class Isa {
  Baseline,  ///< what all other code is compiled for: x86-64 with SSE2, or the target that the build was configured for
  Avx2,      ///< x86-64-v3
  Avx512     ///< x86-64-v4
};

/// Those that this build has code for, narrow to wide.
std::span<const Isa> compiledIsas();
/// Whether the build has code for it and this processor runs it; requireUsable throws Error (Usage) otherwise.
bool isUsable(Isa isa);
void requireUsable(Isa isa);
/// The widest usable one.
Isa bestIsa();

/// "baseline", "avx2", "avx512". Throws Error (Usage) for any other name.
Isa isaOf(std::string_view name);
std::string_view nameOf(Isa isa);

}  // namespace steradian
