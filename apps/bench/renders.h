#pragma once
/// Whole renders: how long scenes take to build and to sample, and how near that is to tracing their rays alone.
#include "steradian/apps/bench/options.h"

namespace steradian::bench {

/// Prints one row for each scene, as a table in Markdown or as JSON. Throws Error as makeScene() and render() do.
void runRenders(const BenchOptions& options);

}  // namespace steradian::bench
