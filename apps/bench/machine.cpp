#include "steradian/apps/bench/machine.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <cstdlib>  // getloadavg
#include <fstream>

#include "steradian/core/base/build_info.h"

namespace steradian::bench {
namespace {

std::string processorName() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

const char* vectors() {
#if defined(__AVX512F__)
  return "AVX-512";
#elif defined(__AVX2__)
  return "AVX2";
#elif defined(__AVX__)
  return "AVX";
#elif defined(__SSE2__)
  return "SSE2";
#else
  return "vectors of the compiler's default";
#endif
}

}  // namespace

double systemLoad() {
  double load = -1.0;
  return getloadavg(&load, 1) == 1 ? load : -1.0;
}

std::string machineLine() {
  return fmt::format("{}, {} processors, {}, {}, load {:.1f}", processorName(), tbb::this_task_arena::max_concurrency(),
                     vectors(), compilerVersion(), systemLoad());
}

}  // namespace steradian::bench
