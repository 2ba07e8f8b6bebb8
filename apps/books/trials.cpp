#include "steradian/apps/books/trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "steradian/apps/books/html.h"

namespace steradian::books {
namespace {

constexpr std::uint32_t kShort = 4;  ///< samples per pixel of a first render

app::RenderOptions optionsOf(const Trial& trial, const Effort& effort) {
  std::vector<std::string> words = trial.command;
  for (const std::string& word : effort.overrules()) words.push_back(word);
  const bool cropped = std::find(words.begin(), words.end(), "--crop") != words.end();
  if (effort.quick && cropped) words.insert(words.end(), {"--crop", "10,26,6,15"});
  return parseRender(words);
}

Rendering renderTrial(const Trial& trial, app::RenderOptions options) {
  if (trial.change) trial.change(options.scene);
  const Scene scene(std::move(options.scene));
  return renderScene(scene, std::move(options));
}

TrialResult resultOf(const Rendering& rendering, const Trial& trial, Measurer& measurer) {
  const RenderStatistics& s = rendering.statistics;
  const auto rays = static_cast<double>(s.paths.cameraRays + s.paths.bounceRays + s.paths.shadowRays);
  return {.seconds = rendering.seconds(),
          .samplesPerSecond = rendering.samplesPerSecond(),
          .raysPerSample = rays / static_cast<double>(s.samples),
          .samplesPerPixel = *rendering.options.settings.samplesPerPixel,
          .samples = s.samples,
          .nonFinite = s.nonFiniteSamples,
          .relMse = measurer.relMse(rendering, trial.command[1]),
          .mean = meanLuminance(rendering.image).mean};
}

TrialResult runWith(app::RenderOptions options, const Trial& trial, Measurer& measurer,
                    const std::filesystem::path& folder) {
  const Rendering rendering = renderTrial(trial, std::move(options));
  if (!trial.picture.empty()) writePicture(rendering, folder / trial.picture);
  return resultOf(rendering, trial, measurer);
}

}  // namespace

TrialResult run(const Trial& trial, Measurer& measurer, const Effort& effort, const std::filesystem::path& folder) {
  return runWith(optionsOf(trial, effort), trial, measurer, folder);
}

TrialResult runFor(double seconds, const Trial& trial, Measurer& measurer, const Effort& effort,
                   const std::filesystem::path& folder) {
  app::RenderOptions options = optionsOf(trial, effort);
  options.settings.samplesPerPixel = kShort;
  const Rendering first = renderTrial(trial, options);
  const double count = std::round(seconds / first.seconds() * kShort);
  options.settings.samplesPerPixel = static_cast<std::uint32_t>(std::clamp(count, 1.0, 1e6));
  return runWith(std::move(options), trial, measurer, folder);
}

std::string commandsOf(const std::vector<Trial>& trials) {
  std::string lines;
  for (const Trial& trial : trials) {
    if (trial.change) continue;
    NumberedPicture picture;
    picture.id = trial.picture.empty() ? "trial" : trial.picture.substr(0, trial.picture.rfind('.'));
    picture.command = trial.command;
    lines += (lines.empty() ? "" : "\n") + picture.commandLine();
  }
  return lines.empty() ? "" : "<pre>" + escaped(lines) + "</pre>\n";
}

}  // namespace steradian::books
