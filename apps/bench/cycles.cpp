#include "steradian/apps/bench/cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>  // mkdtemp
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "steradian/apps/bench/contender.h"
#include "steradian/apps/bench/machine.h"
#include "steradian/apps/scenes/scenes.h"
#include "steradian/apps/steradian/reference.h"
#include "steradian/core/image/image_metrics.h"

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

/// One renderer's reference, and its runs so far. Its error is measured against its own reference, so that small
/// differences in modelling a scene do not count as noise.
class Entrant {
 public:
  /// `samples`: of each half of the reference.
  Entrant(Contender& contender, const BenchOptions& options, std::uint32_t samples)
      : contender_(contender),
        pixels_(static_cast<double>(options.width) * options.height),
        reference_(makeReference(contender, samples)) {}

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
    constexpr std::uint32_t seed = 1000;  // of no run
    const Image first = contender.render(samplesPerPixel, seed).image;
    return app::Reference(first, contender.render(samplesPerPixel, seed + 1).image);
  }

  Contender& contender_;
  double pixels_;
  app::Reference reference_;
  std::vector<double> seconds_, rates_, errors_, efficiencies_;
};

/// Ours, with one of the numbers of pixels that share paths (BenchOptions::reuse).
struct Ours {
  std::uint32_t reuse;
  std::unique_ptr<Steradian> renderer;
  double secondsPerSample = 0.0;
  std::unique_ptr<Entrant> entrant;
};

struct Comparison {
  std::string scene;
  std::uint32_t reuse;
  Result ours, theirs;

  double sampleRateRatio() const { return ours.samplesPerSecond / theirs.samplesPerSecond; }
  double efficiencyRatio() const { return ours.efficiency / theirs.efficiency; }
  double meanRatio() const { return ours.mean / theirs.mean; }
};

std::vector<Comparison> compare(const std::string& name, const BenchOptions& options) {
  const SceneDescription scene = makeScene(name);
  const TemporaryFolder folder;
  Cycles cycles(scene, options, folder.path());
  const std::uint32_t spp = options.samplesPerPixel.value_or(kSamplesPerPixel);
  const std::uint32_t forReference = options.referenceSamples.value_or(kReferenceSamples);
  constexpr std::uint32_t trialSeed = 2000;
  const double trial = options.equalTime ? cycles.render(spp, trialSeed).seconds : 0.0;
  std::vector<Ours> all;
  for (const std::uint32_t reuse : options.reuse) {
    Ours& ours = all.emplace_back(Ours{reuse, std::make_unique<Steradian>(scene, options, reuse), 0.0, nullptr});
    double longer = 1.0;  // our reference, relative to theirs
    if (options.equalTime) {
      ours.secondsPerSample = ours.renderer->render(spp, trialSeed).seconds / spp;
      longer = std::max(1.0, trial / (ours.secondsPerSample * spp));
    }
    ours.entrant =
        std::make_unique<Entrant>(*ours.renderer, options, static_cast<std::uint32_t>(longer * forReference));
  }
  Entrant theirs(cycles, options, forReference);
  for (int i = 0; i < options.repeats; ++i) {
    const auto seed = static_cast<std::uint32_t>(i);
    const double seconds = theirs.run(spp, seed);
    for (const Ours& ours : all) {
      const double affordable = options.equalTime ? std::max(1.0, seconds / ours.secondsPerSample) : spp;
      ours.entrant->run(static_cast<std::uint32_t>(affordable), seed);
    }
  }
  std::vector<Comparison> comparisons;
  comparisons.reserve(all.size());
  for (const Ours& ours : all) comparisons.push_back({name, ours.reuse, ours.entrant->result(), theirs.result()});
  return comparisons;
}

void printRow(const std::string& scene, const std::string& renderer, const Result& r) {
  fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.6f} | {:.0f} | |\n", scene, renderer, r.seconds,
             r.samplesPerSecond / 1e6, r.relMse, r.efficiency);
}

void printComparisons(const std::vector<Comparison>& comparisons) {
  printRow(comparisons[0].scene, "Cycles", comparisons[0].theirs);
  for (const Comparison& c : comparisons) {
    const std::string renderer = c.reuse > 1 ? fmt::format("Steradian, `reuse={}`", c.reuse) : "Steradian";
    printRow(c.scene, renderer, c.ours);
    fmt::print("| {} | **ratio** | | **{:.2f}** | | **{:.2f}** | {:.4f} |\n", c.scene, c.sampleRateRatio(),
               c.efficiencyRatio(), c.meanRatio());
  }
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
          {"reuse", c.reuse},
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
        "| scene | renderer | sampling s | Msamples/s | relMSE | 1/(relMSE s) | ratio of means |\n"
        "|---|---|---|---|---|---|---|\n",
        options.width, options.height, options.samplesPerPixel.value_or(kSamplesPerPixel),
        options.equalTime ? " of Cycles, ours as many as its time allows" : "", options.threads, options.repeats);
    std::fflush(stdout);
  }
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& scene : scenes) {
    const std::vector<Comparison> comparisons = compare(scene, options);
    for (const Comparison& c : comparisons) rows.push_back(toJson(c));
    if (!options.json) printComparisons(comparisons);
  }
  if (options.json) fmt::print("{}\n", nlohmann::json{{"machine", machineLine()}, {"cycles", rows}}.dump(1));
}

}  // namespace steradian::bench
