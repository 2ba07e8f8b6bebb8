#pragma once
/// Compares samplers: their error, and their cost.
#include "steradian/apps/bench/options.h"

namespace steradian::bench {

/// Prints one row for each scene and sampler, and the means over the scenes, as tables in Markdown or as JSON. Throws
/// Error as makeScene() and render() do.
void runSamplers(const BenchOptions& options);

}  // namespace steradian::bench
