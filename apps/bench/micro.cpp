#include "steradian/apps/bench/micro.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>

#include "steradian/apps/bench/micro_loop.h"

namespace steradian::bench {
namespace {

/// One row of a table for each median.
class MedianReporter final : public benchmark::BenchmarkReporter {
 public:
  explicit MedianReporter(bool repeated) : repeated_(repeated) {}

  bool ReportContext(const Context&) override {
    fmt::print("\n| routine, one thread | |\n|---|---|\n");
    return true;
  }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.error_occurred) {
        if (run.repetition_index == 0) fmt::print("| {} | {} |\n", run.run_name.function_name, run.error_message);
      } else if (!repeated_ || run.aggregate_name == "median") {
        fmt::print("| {} | {} |\n", run.run_name.function_name, figureOf(run));
      }
    }
    std::fflush(stdout);
  }

 private:
  static std::string figureOf(const Run& run) {
    const auto value = [&](const char* name) {
      const auto found = run.counters.find(name);
      return found == run.counters.end() ? 0.0 : found->second.value;
    };
    if (const double rays = value(kRayCounter); rays > 0.0) return fmt::format("{:.1f} Mray/s", rays / 1e6);
    return fmt::format("{:.2f} ns", value(kCallCounter) * 1e9);
  }

  bool repeated_;
};

}  // namespace

void runMicro(const BenchOptions& options) {
  std::vector<std::string> words{"steradian-bench", "--benchmark_min_time=0.1",
                                 fmt::format("--benchmark_repetitions={}", options.repeats),
                                 "--benchmark_enable_random_interleaving=false"};
  words.insert(words.end(), options.forMicro.begin(), options.forMicro.end());
  std::vector<char*> pointers;
  pointers.reserve(words.size());
  for (std::string& word : words) pointers.push_back(word.data());
  int count = static_cast<int>(pointers.size());
  benchmark::Initialize(&count, pointers.data());

  registerLeafBenchmarks();
  registerQueryBenchmarks();
  registerSamplingBenchmarks();
  registerShapeBenchmarks();
  registerShadingBenchmarks();

  const bool ownFormat = std::any_of(words.begin(), words.end(),
                                     [](const std::string& word) { return word.starts_with("--benchmark_format"); });
  if (ownFormat) {
    benchmark::RunSpecifiedBenchmarks();
  } else {
    MedianReporter reporter(options.repeats > 1);
    benchmark::RunSpecifiedBenchmarks(&reporter);
  }
  benchmark::Shutdown();
}

}  // namespace steradian::bench
