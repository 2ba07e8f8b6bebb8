#pragma once
/// Acceleration structures side by side.
#include "steradian/apps/bench/options.h"

namespace steradian::bench {

/// Rays of whole renders, recorded and traced again by each of the structures that the scene can have, on one thread:
/// single rays, several at once where they are flat, and Embree's packets of 8. Throws as runRenders() does.
void runStructures(const BenchOptions& options);

}  // namespace steradian::bench
