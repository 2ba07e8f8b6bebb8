/// The program `steradian-bench`: measures speed. BENCHMARKS.md explains what is measured.
#include <fmt/format.h>

#include <CLI/Error.hpp>
#include <exception>

#include "steradian/apps/bench/books.h"
#include "steradian/apps/bench/cycles.h"
#include "steradian/apps/bench/machine.h"
#include "steradian/apps/bench/micro.h"
#include "steradian/apps/bench/options.h"
#include "steradian/apps/bench/renders.h"
#include "steradian/apps/bench/samplers.h"
#include "steradian/apps/bench/structures.h"
#include "steradian/apps/steradian/exit_codes.h"
#include "steradian/core/base/diagnostics.h"

namespace {

using namespace steradian::bench;

void runPart(Part part, const BenchOptions& options) {
  switch (part) {
    case Part::Micro:
      return runMicro(options);
    case Part::Renders:
      return runRenders(options);
    case Part::Samplers:
      return runSamplers(options);
    case Part::Books:
      return runBooks(options);
    case Part::Structures:
      return runStructures(options);
    case Part::Cycles:
      return runCycles(options);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const BenchOptions options = readOptions(argc, argv);
    if (!options.json) fmt::print("{}\n", machineLine());
    for (const Part part : options.parts) runPart(part, options);
    return steradian::app::kExitSuccess;
  } catch (const CLI::Success&) {
    return steradian::app::kExitSuccess;
  } catch (const steradian::Error& error) {
    fmt::print(stderr, "{}\n", error.what());
    return steradian::app::exitCodeOf(error.kind());
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return steradian::app::kExitOther;
  }
}
