#include "steradian/apps/bench/samplers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "steradian/apps/bench/machine.h"
#include "steradian/apps/bench/measure.h"
#include "steradian/apps/scenes/scenes.h"
#include "steradian/apps/steradian/reference.h"
#include "steradian/integrators/path/path.h"
#include "steradian/integrators/render/render.h"

namespace steradian::bench {
namespace {

constexpr std::uint32_t kReferenceSamples = 1024;
constexpr std::uint32_t kReferenceSeed = 1000;  // of no run

/// One sampler with one scene and one number of samples.
struct Cell {
  double relMse = 0.0;   ///< mean of all runs
  double seconds = 0.0;  ///< median
  double cost() const { return relMse * seconds; }
};
/// By sampler, then by number of samples.
using Table = std::array<std::vector<Cell>, kSamplerTypes.size()>;

RenderResult renderWith(Threads& threads, const Scene& scene, const BenchOptions& options, SamplerType type,
                        std::uint32_t samples, std::uint32_t seed) {
  RenderSettings settings;
  settings.width = options.samplersWidth;
  settings.height = options.samplersHeight;
  settings.samplesPerPixel = samples;
  settings.sampler = type;
  settings.seed = seed;
  return threads.run([&] { return render(scene, PathIntegrator(), settings); });
}

Table measure(Threads& threads, const Scene& scene, const BenchOptions& options,
              const std::vector<std::uint32_t>& counts) {
  const std::uint32_t many = options.referenceSamples.value_or(kReferenceSamples);
  const auto half = [&](std::uint32_t seed) {
    return renderWith(threads, scene, options, SamplerType::Sobol, many, seed)
        .film.image({.features = false, .errors = false});
  };
  const app::Reference reference(half(kReferenceSeed), half(kReferenceSeed + 1));
  Table table;
  table.fill(std::vector<Cell>(counts.size()));
  for (std::size_t c = 0; c < counts.size(); ++c) {
    std::array<std::vector<double>, kSamplerTypes.size()> seconds;
    for (int i = 0; i < options.repeats; ++i) {
      // In turns, so that changes of the machine's speed affect all.
      for (std::size_t s = 0; s < kSamplerTypes.size(); ++s) {
        const RenderResult result =
            renderWith(threads, scene, options, kSamplerTypes[s], counts[c], static_cast<std::uint32_t>(i));
        table[s][c].relMse +=
            reference.relMseOf(result.film.image({.features = false, .errors = false})) / options.repeats;
        seconds[s].push_back(result.statistics.sampleSeconds);
      }
    }
    for (std::size_t s = 0; s < kSamplerTypes.size(); ++s) table[s][c].seconds = median(seconds[s]);
  }
  return table;
}

void printHead(const std::string& names, const std::vector<std::uint32_t>& counts) {
  std::string head = names;
  for (const char* what : {"relMSE", "relMSE x s"}) {
    for (const std::uint32_t count : counts) head += fmt::format(" {}, {} spp |", what, count);
  }
  fmt::print("\n{}\n|", head);
  for (auto columns = std::count(head.begin(), head.end(), '|') - 1; columns > 0; --columns) fmt::print("---|");
  fmt::print("\n");
}

void printScene(const std::string& scene, const Table& table) {
  for (std::size_t s = 0; s < kSamplerTypes.size(); ++s) {
    fmt::print("| {} | {} |", scene, nameOf(kSamplerTypes[s]));
    for (const Cell& cell : table[s]) fmt::print(" {:.3g} |", cell.relMse);
    for (const Cell& cell : table[s]) fmt::print(" {:.3g} |", cell.cost());
    fmt::print("\n");
  }
  std::fflush(stdout);
}

/// Geometric means over the scenes of `value`, relative to that of sobol.
template <class Value>
double relativeMean(const std::vector<Table>& tables, std::size_t sampler, std::size_t count, Value value) {
  const auto sobol = static_cast<std::size_t>(
      std::find(kSamplerTypes.begin(), kSamplerTypes.end(), SamplerType::Sobol) - kSamplerTypes.begin());
  double sum = 0.0;
  for (const Table& table : tables) sum += std::log(value(table[sampler][count]) / value(table[sobol][count]));
  return std::exp(sum / static_cast<double>(tables.size()));
}

void printMeans(const std::vector<Table>& tables, const std::vector<std::uint32_t>& counts) {
  fmt::print("\nGeometric means over the scenes, sobol = 1, lower is better\n");
  printHead("| sampler |", counts);
  for (std::size_t s = 0; s < kSamplerTypes.size(); ++s) {
    fmt::print("| {} |", nameOf(kSamplerTypes[s]));
    for (std::size_t c = 0; c < counts.size(); ++c) {
      fmt::print(" {:.2f} |", relativeMean(tables, s, c, [](const Cell& cell) { return cell.relMse; }));
    }
    for (std::size_t c = 0; c < counts.size(); ++c) {
      fmt::print(" {:.2f} |", relativeMean(tables, s, c, [](const Cell& cell) { return cell.cost(); }));
    }
    fmt::print("\n");
  }
}

nlohmann::json toJson(const std::string& scene, const Table& table, const std::vector<std::uint32_t>& counts) {
  nlohmann::json rows = nlohmann::json::array();
  for (std::size_t s = 0; s < kSamplerTypes.size(); ++s) {
    for (std::size_t c = 0; c < counts.size(); ++c) {
      rows.push_back({{"scene", scene},
                      {"sampler", nameOf(kSamplerTypes[s])},
                      {"samples_per_pixel", counts[c]},
                      {"rel_mse", table[s][c].relMse},
                      {"sample_seconds", table[s][c].seconds}});
    }
  }
  return rows;
}

}  // namespace

void runSamplers(const BenchOptions& options) {
  const std::vector<std::string> scenes =
      options.scenes.empty() ? std::vector<std::string>{"cornell-box", "one-weekend", "cornell-glass-sphere"}
                             : options.scenes;
  const std::vector<std::uint32_t> counts =
      options.samplesPerPixel ? std::vector{*options.samplesPerPixel} : std::vector{16u, 64u, 256u};
  if (!options.json) {
    fmt::print("\nSamplers, {} x {}, {} threads; relMSE: means of {} runs, seconds: medians\n", options.samplersWidth,
               options.samplersHeight, options.threads, options.repeats);
    printHead("| scene | sampler |", counts);
    std::fflush(stdout);
  }
  Threads threads(options.threads);
  std::vector<Table> tables;
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& name : scenes) {
    std::unique_ptr<const Scene> scene;
    threads.run([&] { scene = std::make_unique<Scene>(makeScene(name)); });
    tables.push_back(measure(threads, *scene, options, counts));
    if (!options.json) printScene(name, tables.back());
    for (auto& row : toJson(name, tables.back(), counts)) rows.push_back(std::move(row));
  }
  if (options.json) {
    fmt::print("{}\n", nlohmann::json{{"machine", machineLine()}, {"samplers", rows}}.dump(1));
  } else {
    printMeans(tables, counts);
  }
}

}  // namespace steradian::bench
