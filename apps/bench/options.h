#pragma once
/// What the user may ask the benchmarks for.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace steradian::bench {

enum class Part {
  Micro,       ///< single routines
  Renders,     ///< whole renders against the speed of tracing alone
  Samplers,    ///< whole renders by each sampler: error and time
  Books,       ///< whole renders beside the books' way to render
  Structures,  ///< rays of renders, traced by each acceleration structure
  Cycles       ///< whole renders beside Blender's Cycles
};

struct BenchOptions {
  std::vector<Part> parts;
  std::vector<std::string> scenes;  ///< empty: those that each part takes by itself
  int width = 300, height = 300;
  /// Of the pictures of Samplers, and of those that Books compares; the same if the user says a size.
  int samplersWidth = 64, samplersHeight = 64;
  std::optional<std::uint32_t> samplesPerPixel;   ///< nothing: as each part takes by itself
  std::optional<std::uint32_t> referenceSamples;  ///< per pixel, of each half of a reference; nothing: likewise
  int threads = 1;
  std::uint32_t pathWidth = 0;             ///< PathSettings::width of our renders
  std::vector<std::uint32_t> reuse = {1};  ///< --cycles: PathSettings::reuse of our renders, one after the other
  int repeats = 3;                         ///< figures are medians of so many runs
  bool json = false;
  bool equalTime = false;  ///< --cycles: ours takes as many samples as the time of Cycles allows
  std::string cyclesScript = "apps/bench/cycles_scene.py";
  std::vector<std::string> forMicro;  ///< options that begin with --benchmark_
};

/// Reads the command line. Throws steradian::Error (Usage) with all that is wrong with it, CLI::Success after --help.
BenchOptions readOptions(int argc, char** argv);

}  // namespace steradian::bench
