#pragma once
/// Samplers side by side: what error they leave, and what it costs.
#include "steradian/apps/bench/options.h"

namespace steradian::bench {

/// Prints one row for each scene and sampler, and the means over the scenes, as tables in Markdown or as JSON. Throws
/// Error as makeScene() and render() do.
void runSamplers(const BenchOptions& options);

}  // namespace steradian::bench
