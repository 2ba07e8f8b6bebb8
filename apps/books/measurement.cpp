#include "steradian/apps/books/measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "steradian/apps/scenes/scenes.h"
#include "steradian/integrators/path/path.h"

namespace steradian::books {
namespace {

// // Seeds that no picture has.
constexpr std::uint32_t kReferenceSeed = 1000, kDefaultSeed = 2000;

Rendering byDefault(const Scene& scene, const RenderSettings& like, std::uint32_t samples, std::uint32_t seed) {
  app::RenderOptions options;
  options.settings.width = like.width;
  options.settings.height = like.height;
  options.settings.crop = like.crop;
  options.settings.samplesPerPixel = samples;
  options.settings.seed = seed;
  options.integrator = "path";
  return renderScene(scene, std::move(options));
}

double pixelsOf(const Rendering& rendering) {
  return static_cast<double>(rendering.image.width()) * static_cast<double>(rendering.image.height());
}

/// What a reference depends on.
std::string keyOf(const std::string& sceneName, const RenderSettings& s) {
  std::string key = fmt::format("{} {}x{}", sceneName, *s.width, *s.height);
  if (s.crop) key += fmt::format(" {},{},{},{}", s.crop->x0, s.crop->x1, s.crop->y0, s.crop->y1);
  return key;
}

}  // namespace

MeanLuminance meanLuminance(const Image& image) {
  const int r = image.channel("R"), g = image.channel("G"), b = image.channel("B"), e = image.channel("StdErr.Y");
  double sum = 0.0, variance = 0.0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      sum += static_cast<double>(luminance(Rgb{image.at(x, y, r), image.at(x, y, g), image.at(x, y, b)}));
      variance += sqr(static_cast<double>(image.at(x, y, e)));
    }
  }
  const double pixels = static_cast<double>(image.width()) * static_cast<double>(image.height());
  return {sum / pixels, std::sqrt(variance) / pixels};
}

Measurer::Known& Measurer::knownOf(const std::string& sceneName, const RenderSettings& settings) {
  const std::string key = keyOf(sceneName, settings);
  const auto found = known_.find(key);
  if (found != known_.end()) return found->second;
  auto scene = std::make_unique<const Scene>(makeScene(sceneName));
  const auto half = [&](std::uint32_t seed) { return byDefault(*scene, settings, effort_.referenceSamples(), seed); };
  const Rendering a = half(kReferenceSeed), b = half(kReferenceSeed + 1);
  const double meanA = meanLuminance(a.image).mean, meanB = meanLuminance(b.image).mean;
  Known known{std::move(scene), app::Reference(a.image, b.image), std::max(a.samplesPerSecond(), b.samplesPerSecond()),
              0.5 * (meanA + meanB), 0.5 * std::abs(meanA - meanB)};
  return known_.emplace(key, std::move(known)).first->second;
}

double Measurer::relMse(const Rendering& rendering, const std::string& sceneName) {
  return knownOf(sceneName, rendering.options.settings).reference.relMseOf(rendering.image);
}

Measurement Measurer::measure(const Rendering& rendering, const std::string& sceneName) {
  const RenderSettings& settings = rendering.options.settings;
  const Known& known = knownOf(sceneName, settings);
  Measurement result;
  result.relMse = known.reference.relMseOf(rendering.image);
  const MeanLuminance mean = meanLuminance(rendering.image);
  result.bias = mean.mean / known.mean - 1.0;
  result.biasError = std::hypot(mean.standardError, known.meanError) / known.mean;

  const double count = std::round(rendering.seconds() * known.samplesPerSecond / pixelsOf(rendering));
  const auto samples = static_cast<std::uint32_t>(std::clamp(count, 1.0, 1e6));
  const Rendering other = byDefault(*known.scene, settings, samples, kDefaultSeed);
  result.defaultRelMse = known.reference.relMseOf(other.image);
  if (result.relMse > 0.0 && result.defaultRelMse > 0.0)
    result.ratio = result.defaultRelMse * other.seconds() / (result.relMse * rendering.seconds());
  return result;
}

}  // namespace steradian::books
