#include "steradian/apps/bench/cycles.h"

#include <fmt/format.h>
#include <stdlib.h>  // mkdtemp

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "steradian/apps/bench/contender.h"
#include "steradian/apps/bench/machine.h"
#include "steradian/apps/scenes/scenes.h"
#include "steradian/apps/steradian/reference.h"
#include "steradian/core/image_metrics.h"

namespace steradian::bench {
namespace {

constexpr std::uint32_t kSamplesPerPixel = 64;
constexpr std::uint32_t kReferenceSamples = 512;

/// A folder that disappears with this object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "steradian-bench-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw Error(ErrorKind::Output, "cannot make the folder " + name);
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// What one renderer achieved; medians.
struct Result {
  double seconds, samplesPerSecond, relMse, efficiency, mean;
};

/// One renderer's reference, and its runs so far. Its error is that against its own reference: modelling a scene a
/// little differently shall not count as noise.
class Entrant {
 public:
  /// `longer`: how many times the samples of the options' reference.
  Entrant(Contender& contender, const BenchOptions& options, double longer = 1.0)
      : contender_(contender),
        pixels_(static_cast<double>(options.width) * options.height),
        reference_(makeReference(
            contender, static_cast<std::uint32_t>(longer * options.referenceSamples.value_or(kReferenceSamples)))) {}

  /// Returns the seconds that it took.
  double run(std::uint32_t samplesPerPixel, std::uint32_t seed) {
    const TimedPicture picture = contender_.render(samplesPerPixel, seed);
    const double error = reference_.relMseOf(picture.image);
    seconds_.push_back(picture.seconds);
    rates_.push_back(pixels_ * samplesPerPixel / picture.seconds);
    errors_.push_back(error);
    efficiencies_.push_back(1.0 / (error * picture.seconds));
    return picture.seconds;
  }

  Result result() const {
    const std::array<double, 3> means = channelMeans(reference_.mean);
    return {median(seconds_), median(rates_), median(errors_), median(efficiencies_),
            (means[0] + means[1] + means[2]) / 3.0};
  }

 private:
  static app::Reference makeReference(Contender& contender, std::uint32_t samplesPerPixel) {
    constexpr std::uint32_t seed = 1000;  // that no run has
    const Image first = contender.render(samplesPerPixel, seed).image;
    return app::Reference(first, contender.render(samplesPerPixel, seed + 1).image);
  }

  Contender& contender_;
  double pixels_;
  app::Reference reference_;
  std::vector<double> seconds_, rates_, errors_, efficiencies_;
};

struct Comparison {
  std::string scene;
  Result ours, theirs;

  double sampleRateRatio() const { return ours.samplesPerSecond / theirs.samplesPerSecond; }
  double efficiencyRatio() const { return ours.efficiency / theirs.efficiency; }
  double meanRatio() const { return ours.mean / theirs.mean; }
};

Comparison compare(const std::string& name, const BenchOptions& options) {
  const SceneDescription scene = makeScene(name);
  const TemporaryFolder folder;
  Steradian steradian(scene, options);
  Cycles cycles(scene, options, folder.path());
  const std::uint32_t spp = options.samplesPerPixel.value_or(kSamplesPerPixel);
  double faster = 1.0, secondsPerSample = 0.0;
  if (options.equalTime) {
    constexpr std::uint32_t trialSeed = 2000;
    const double trial = steradian.render(spp, trialSeed).seconds;
    secondsPerSample = trial / spp;
    faster = std::max(1.0, cycles.render(spp, trialSeed).seconds / trial);
  }
  Entrant ours(steradian, options, faster), theirs(cycles, options);
  for (int i = 0; i < options.repeats; ++i) {
    const auto seed = static_cast<std::uint32_t>(i);
    const double seconds = theirs.run(spp, seed);
    ours.run(options.equalTime ? static_cast<std::uint32_t>(std::max(1.0, seconds / secondsPerSample)) : spp, seed);
  }
  return {name, ours.result(), theirs.result()};
}

void printComparison(const Comparison& c) {
  const auto row = [&](const char* renderer, const Result& r) {
    fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.5f} | {:.0f} |\n", c.scene, renderer, r.seconds,
               r.samplesPerSecond / 1e6, r.relMse, r.efficiency);
  };
  row("Steradian", c.ours);
  row("Cycles", c.theirs);
  fmt::print("| {} | **ratio** | | **{:.2f}** | | **{:.2f}** |\n", c.scene, c.sampleRateRatio(), c.efficiencyRatio());
  std::fflush(stdout);
}

nlohmann::json toJson(const Comparison& c) {
  const auto result = [&](const Result& r) {
    return nlohmann::json{{"sample_seconds", r.seconds},
                          {"samples_per_second", r.samplesPerSecond},
                          {"rel_mse", r.relMse},
                          {"efficiency", r.efficiency},
                          {"reference_mean", r.mean}};
  };
  return {{"scene", c.scene},
          {"steradian", result(c.ours)},
          {"cycles", result(c.theirs)},
          {"sample_rate_ratio", c.sampleRateRatio()},
          {"efficiency_ratio", c.efficiencyRatio()},
          {"mean_ratio", c.meanRatio()}};
}

}  // namespace

void runCycles(const BenchOptions& options) {
  if (!Cycles::available()) throw Error(ErrorKind::Usage, "there is no blender (Debian: apt-get install blender)");
  const std::vector<std::string> scenes =
      options.scenes.empty() ? std::vector<std::string>{"cornell-box", "cornell-glass-sphere"} : options.scenes;
  if (!options.json) {
    fmt::print(
        "\nBeside Blender's Cycles, {} x {}, {} spp{}, {} threads, medians of {}\n\n"
        "| scene | renderer | sampling s | Msamples/s | relMSE | 1/(relMSE s) |\n|---|---|---|---|---|---|\n",
        options.width, options.height, options.samplesPerPixel.value_or(kSamplesPerPixel),
        options.equalTime ? " of Cycles, ours as many as its time allows" : "", options.threads, options.repeats);
    std::fflush(stdout);
  }
  std::vector<Comparison> comparisons;
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& scene : scenes) {
    comparisons.push_back(compare(scene, options));
    rows.push_back(toJson(comparisons.back()));
    if (!options.json) printComparison(comparisons.back());
  }
  if (options.json) {
    fmt::print("{}\n", nlohmann::json{{"machine", machineLine()}, {"cycles", rows}}.dump(1));
    return;
  }
  fmt::print("\nMeans of the references, ours over theirs:");
  for (const Comparison& c : comparisons) fmt::print(" {} {:.4f}", c.scene, c.meanRatio());
  fmt::print("\n");
}

}  // namespace steradian::bench
