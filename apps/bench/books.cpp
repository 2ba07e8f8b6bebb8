#include "steradian/apps/bench/books.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "steradian/apps/bench/books_renderer.h"
#include "steradian/apps/bench/machine.h"
#include "steradian/apps/bench/measure.h"
#include "steradian/apps/scenes/scenes.h"
#include "steradian/core/image/image_metrics.h"
#include "steradian/integrators/path/path.h"
#include "steradian/integrators/render/render.h"

namespace steradian::bench {
namespace {

constexpr std::uint32_t kSamplesPerPixel = 16;
/// Samples per pixel of the pictures that are compared. The books' renderer needs many to reveal an error of 2 %: its
/// light comes in rare bright samples.
constexpr std::uint32_t kOurCheckSamples = 64, kTheirCheckSamples = 1024;
constexpr std::uint32_t kReplicates = 8;

struct Check {
  ZTestResult z;
  double meanRatio = 1.0;                         ///< of luminances, ours over theirs
  double ourVariance = 0.0, theirVariance = 0.0;  ///< of one sample's luminance: means over the pixels
};

/// Rates are per second of all threads together.
struct Row {
  std::string scene;
  Check check;
  double ours = 0.0, theirs = 0.0;
  double oursByBsdf = 0.0;  ///< with their estimator: no light sampling

  double rateRatio() const { return ours / theirs; }
  double rateRatioByBsdf() const { return oursByBsdf / theirs; }
  /// How much longer the books' renderer takes to reach the same noise.
  double timeRatio() const { return rateRatio() * check.theirVariance / check.ourVariance; }
};

/// Variance per sample, from the standard errors of the pixels.
double sampleVariance(const Image& image, std::uint32_t samplesPerPixel) {
  const int channel = image.channel("StdErr.Y");
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const auto error = static_cast<double>(image.at(x, y, channel));
      sum += error * error;
    }
  }
  return sum / static_cast<double>(image.pixelCount()) * samplesPerPixel;
}

double meanLuminance(const Image& image) {
  const std::array<double, 3> means = channelMeans(image);
  return 0.2126 * means[0] + 0.7152 * means[1] + 0.0722 * means[2];
}

/// The scene with plain colours in place of noise textures and pictures, which look different there (other noise, no
/// filtering).
SceneDescription inPlainColours(SceneDescription scene) {
  for (TextureDescription& texture : scene.textures) {
    const bool isOwn = std::holds_alternative<NoiseTexture>(texture) || std::holds_alternative<ImageTexture>(texture);
    if (isOwn) texture = ConstantTexture{grey(0.5f)};
  }
  return scene;
}

/// Both renderers, set up for one scene.
class Pair {
 public:
  Pair(Threads& threads, const SceneDescription& description, const BenchOptions& options)
      : threads_(threads),
        options_(options),
        byBsdf_({.strategy = Strategy::Bsdf}),
        world_(books::makeWorld(description)) {
    threads_.run([&] { scene_ = std::make_unique<Scene>(description); });
  }

  Check check() {
    RenderSettings settings;
    settings.width = options_.samplersWidth;
    settings.height = options_.samplersHeight;
    settings.samplesPerPixel = kOurCheckSamples;
    settings.replicates = kReplicates;
    settings.execution.width = options_.pathWidth;
    const Image ours =
        threads_.run([&] { return render(*scene_, integrator_, settings); }).film.image({.features = false});
    const Image theirs = threads_.run([&] {
      return books::render(world_, {*settings.width, *settings.height}, kTheirCheckSamples, settings.seed);
    });
    Check check;
    check.z = zTest(ours, &ours, theirs, &theirs,
                    {.degreesOfFreedomA = kReplicates - 1.0, .degreesOfFreedomB = kTheirCheckSamples - 1.0});
    check.meanRatio = meanLuminance(ours) / meanLuminance(theirs);
    check.ourVariance = sampleVariance(ours, kOurCheckSamples);
    check.theirVariance = sampleVariance(theirs, kTheirCheckSamples);
    return check;
  }

  double ourRate(std::uint32_t samplesPerPixel) { return rateOf(integrator_, samplesPerPixel); }
  /// With the books' estimator.
  double ourRateByBsdf(std::uint32_t samplesPerPixel) { return rateOf(byBsdf_, samplesPerPixel); }

  double theirRate(std::uint32_t samplesPerPixel, std::uint32_t seed) {
    const double seconds = secondsOf([&] {
      threads_.run([&] { books::render(world_, {options_.width, options_.height}, samplesPerPixel, seed); });
    });
    return static_cast<double>(options_.width) * options_.height * samplesPerPixel / seconds;
  }

 private:
  double rateOf(const PathIntegrator& integrator, std::uint32_t samplesPerPixel) {
    RenderSettings settings;
    settings.width = options_.width;
    settings.height = options_.height;
    settings.samplesPerPixel = samplesPerPixel;
    settings.execution.width = options_.pathWidth;
    const RenderStatistics statistics = threads_.run([&] { return render(*scene_, integrator, settings); }).statistics;
    return static_cast<double>(statistics.samples) / statistics.sampleSeconds;
  }

  Threads& threads_;
  const BenchOptions& options_;
  PathIntegrator integrator_, byBsdf_;
  books::World world_;
  std::unique_ptr<const Scene> scene_;
};

Row measure(Threads& threads, const SceneDescription& description, const BenchOptions& options) {
  Pair pair(threads, description, options);
  Row row{.scene = description.name, .check = Pair(threads, inPlainColours(description), options).check()};
  const std::uint32_t spp = options.samplesPerPixel.value_or(kSamplesPerPixel);
  std::vector<double> ours, byBsdf, theirs;
  for (int i = 0; i < options.repeats; ++i) {
    // In turns, so that changes of the machine's speed affect both.
    ours.push_back(pair.ourRate(spp));
    byBsdf.push_back(pair.ourRateByBsdf(spp));
    theirs.push_back(pair.theirRate(spp, static_cast<std::uint32_t>(i)));
  }
  row.ours = median(ours);
  row.oursByBsdf = median(byBsdf);
  row.theirs = median(theirs);
  return row;
}

void printRow(const Row& row) {
  const ZTestResult& z = row.check.z;
  fmt::print("| books/{} | {:.3f} | {:.3f} | {:.3f} | {:.1f} | {:.1f} | {:.0f} | {:.4f} | {}, z {:.1f} of {:.1f} |\n",
             row.scene, row.ours / 1e6, row.oursByBsdf / 1e6, row.theirs / 1e6, row.rateRatio(), row.rateRatioByBsdf(),
             row.timeRatio(), row.check.meanRatio, z.passed ? "same" : "DIFFER", std::fabs(z.worstZ), z.threshold);
  std::fflush(stdout);
}

nlohmann::json toJson(const Row& row) {
  return {{"scene", row.scene},
          {"samples_per_second", row.ours},
          {"books_samples_per_second", row.theirs},
          {"bsdf_samples_per_second", row.oursByBsdf},
          {"sample_rate_ratio", row.rateRatio()},
          {"bsdf_sample_rate_ratio", row.rateRatioByBsdf()},
          {"equal_noise_time_ratio", row.timeRatio()},
          {"mean_ratio", row.check.meanRatio},
          {"worst_z", row.check.z.worstZ},
          {"z_limit", row.check.z.threshold},
          {"passed", row.check.z.passed}};
}

/// Features of the scene that the books' renderer lacks.
std::string missingFor(const SceneDescription& scene) {
  try {
    books::makeWorld(scene);
    return {};
  } catch (const Error& error) {
    return error.diagnostics().front().message;
  }
}

/// Those of the list that exist in this version.
std::vector<std::string> defaultScenes() {
  std::vector<std::string> scenes;
  for (const char* name : {"next-week-final", "cornell-smoke", "cornell-box", "one-weekend"}) {
    const auto infos = builtInScenes();
    const bool exists = std::any_of(infos.begin(), infos.end(), [&](const SceneInfo& s) { return s.name == name; });
    if (exists) scenes.emplace_back(name);
  }
  return scenes;
}

}  // namespace

void runBooks(const BenchOptions& options) {
  const std::vector<std::string> scenes = options.scenes.empty() ? defaultScenes() : options.scenes;
  if (!options.json) {
    fmt::print(
        "\nBeside the books' way, {} x {}, {} spp, {} threads, medians of {}\n\n"
        "| scene | Msamples/s | with `bsdf` | the books' | ratio | ratio of `bsdf` | ratio of times to equal noise | "
        "ratio of means | pictures, worst z and its limit |\n"
        "|---|---|---|---|---|---|---|---|---|\n",
        options.width, options.height, options.samplesPerPixel.value_or(kSamplesPerPixel), options.threads,
        options.repeats);
    std::fflush(stdout);
  }
  Threads threads(options.threads);
  nlohmann::json rows = nlohmann::json::array();
  std::string different;
  for (const std::string& scene : scenes) {
    const SceneDescription description = makeScene(scene);
    if (const std::string missing = missingFor(description); !missing.empty()) {
      if (!options.json) fmt::print("| books/{} | left out: {} | | | | | | | |\n", scene, missing);
      continue;
    }
    const Row row = measure(threads, description, options);
    if (!row.check.z.passed) different += " " + scene;
    if (options.json) {
      rows.push_back(toJson(row));
    } else {
      printRow(row);
    }
  }
  if (options.json) fmt::print("{}\n", nlohmann::json{{"machine", machineLine()}, {"books", rows}}.dump(1));
  if (!different.empty()) throw Error(ErrorKind::Other, "pictures differ from the books':" + different);
}

}  // namespace steradian::bench
