#pragma once
/// The options of the benchmarks.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace steradian::bench {

enum class Part {
  Micro,       ///< single routines
  Renders,     ///< whole renders against the speed of tracing alone
  Samplers,    ///< whole renders by each sampler: error and time
  Books,       ///< whole renders compared with a renderer as in the books
  Structures,  ///< rays of renders, traced by each acceleration structure
  Cycles       ///< whole renders compared with Blender's Cycles
};

struct BenchOptions {
  std::vector<Part> parts;
  std::vector<std::string> scenes;  ///< empty: the defaults of each part
  int width = 300, height = 300;
  /// Size of the pictures of Samplers, and of those that Books compares; the user's size if given.
  int samplersWidth = 64, samplersHeight = 64;
  std::optional<std::uint32_t> samplesPerPixel;   ///< nothing: the default of each part
  std::optional<std::uint32_t> referenceSamples;  ///< per pixel, of each half of a reference; nothing: likewise
  int threads = 1;
  std::uint32_t pathWidth = 0;             ///< PathSettings::width of our renders
  std::vector<std::uint32_t> reuse = {1};  ///< --cycles: PathSettings::reuse of our renders, one after the other
  int repeats = 3;                         ///< figures are medians of this many runs
  bool json = false;
  bool equalTime = false;  ///< --cycles: ours takes as many samples as the time of Cycles allows
  std::string cyclesScript = "apps/bench/cycles_scene.py";
  std::vector<std::string> forMicro;  ///< options that begin with --benchmark_
};

/// Reads the command line. Throws steradian::Error (Usage) with all that is wrong with it, CLI::Success after --help.
BenchOptions readOptions(int argc, char** argv);

}  // namespace steradian::bench
