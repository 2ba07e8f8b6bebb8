#pragma once
/// Micro-benchmarks: single routines, by Google Benchmark.
#include "steradian/apps/bench/options.h"

namespace steradian::bench {

/// Runs those that the options select and prints one line for each: its median in Mray/s or ns.
/// With --benchmark_format=... Google Benchmark reports in its own way.
void runMicro(const BenchOptions& options);

// Each registers the benchmarks of its file.
void registerLeafBenchmarks();      ///< one ray and one cluster
void registerQueryBenchmarks();     ///< one ray and a whole scene
void registerSamplingBenchmarks();  ///< samplers and warps
void registerShapeBenchmarks();     ///< directions towards shapes
void registerShadingBenchmarks();   ///< materials, lights and the film

}  // namespace steradian::bench
