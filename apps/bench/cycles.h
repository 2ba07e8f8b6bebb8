#pragma once
/// The same scenes by us and by Blender's Cycles, in turns on one machine.
#include "steradian/apps/bench/options.h"

namespace steradian::bench {

/// Prints the sample rates, errors and efficiencies of both and their ratios, as a table in Markdown or as JSON. Throws
/// Error: Usage if there is no Blender; Other if it cannot render a scene.
void runCycles(const BenchOptions& options);

}  // namespace steradian::bench
