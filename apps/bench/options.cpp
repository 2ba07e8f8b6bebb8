#include "steradian/apps/bench/options.h"

#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>

#include "steradian/apps/steradian/arguments.h"
#include "steradian/core/base/diagnostics.h"

namespace steradian::bench {
namespace {

constexpr const char* kDescription =
    "Measures Steradian. Without PART: micro, renders and books. Options that begin with --benchmark_ go to the\n"
    "micro-benchmarks (Google Benchmark): --benchmark_filter=REGEX, --benchmark_list_tests, ...";

struct Texts {
  std::vector<std::string> parts;
  std::string size, samples, reference, threads, repeats = "3", pathWidth = "0";
  bool cycles = false;
};

std::vector<Part> partsOf(const Texts& texts) {
  std::vector<Part> parts;
  for (const std::string& part : texts.parts) {
    parts.push_back(part == "micro"        ? Part::Micro
                    : part == "renders"    ? Part::Renders
                    : part == "books"      ? Part::Books
                    : part == "structures" ? Part::Structures
                                           : Part::Samplers);
  }
  if (texts.cycles) parts.push_back(Part::Cycles);
  if (parts.empty()) parts = {Part::Micro, Part::Renders, Part::Books};
  return parts;
}

void declare(CLI::App& app, Texts& texts, BenchOptions& options) {
  app.add_option("PART", texts.parts, "micro, renders, books, samplers, structures")
      ->check(CLI::IsMember({"micro", "renders", "books", "samplers", "structures"}));
  app.add_flag("--cycles", texts.cycles, "Compare with Blender's Cycles (needs blender)");
  app.add_option(
         "--scenes", options.scenes,
         "Scenes of renders, books, samplers, structures and --cycles; renders and\nstructures also take mesh-room:N")
      ->delimiter(',');
  app.add_option("--size", texts.size, "Size of the pictures; default: 300x300, samplers 64x64")->type_name("WxH");
  app.add_option("--spp", texts.samples,
                 "Samples per pixel; default: renders and books 16, --cycles 64, samplers 16, 64 and 256")
      ->type_name("N");
  app.add_option("--reference-spp", texts.reference,
                 "Samples of each half of a reference; default: --cycles 512, samplers 1024")
      ->type_name("N");
  app.add_option("-t,--threads", texts.threads,
                 "Threads of renders, books and samplers; default: one for each processor")
      ->type_name("N");
  app.add_option("--width", texts.pathWidth, "Paths that our renders trace at once: 1, 4, 8, 16; 0: as many as pay")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--reuse", options.reuse,
                 "--cycles: pixels that share paths in our renders: 1, 2, 4, 8, 16, 32; or several")
      ->delimiter(',')
      ->check(CLI::IsMember({1, 2, 4, 8, 16, 32}))
      ->type_name("N,...")
      ->capture_default_str();
  app.add_option("--repeats", texts.repeats, "Figures are medians of N runs")->type_name("N")->capture_default_str();
  app.add_flag("--equal-time", options.equalTime, "--cycles: ours with as many samples as take the time of Cycles");
  app.add_option("--cycles-script", options.cyclesScript, "The script that Blender runs")->capture_default_str();
  app.add_flag("--json", options.json,
               "Print the figures of renders, books, samplers, structures and --cycles as JSON");
}

}  // namespace

BenchOptions readOptions(int argc, char** argv) {
  CLI::App app{kDescription};
  app.name("steradian-bench");
  app.allow_extras();
  Texts texts;
  BenchOptions options;
  declare(app, texts, options);
  app::Arguments arguments;
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    app.exit(asked);  // prints the help
    throw;
  } catch (const CLI::ParseError& problem) {
    throw Error(ErrorKind::Usage, problem.what());
  }
  for (std::string& extra : app.remaining()) {
    if (!extra.starts_with("--benchmark_")) arguments.problem("unexpected argument \"" + extra + "\"");
    options.forMicro.push_back(std::move(extra));
  }
  if (!texts.size.empty()) {
    const app::Size size = arguments.size("--size", texts.size);
    options.width = options.samplersWidth = size.width;
    options.height = options.samplersHeight = size.height;
  }
  if (!texts.samples.empty()) options.samplesPerPixel = arguments.whole("--spp", texts.samples, 1, 1u << 20);
  if (!texts.reference.empty())
    options.referenceSamples = arguments.whole("--reference-spp", texts.reference, 1, 1u << 20);
  options.threads = texts.threads.empty() ? tbb::this_task_arena::max_concurrency()
                                          : static_cast<int>(arguments.whole("--threads", texts.threads, 1, 1024));
  options.pathWidth = arguments.whole("--width", texts.pathWidth, 0, 16);
  options.repeats = static_cast<int>(arguments.whole("--repeats", texts.repeats, 1, 1000));
  arguments.throwIfProblems();
  options.parts = partsOf(texts);
  return options;
}

}  // namespace steradian::bench
