#include "steradian/apps/bench/contender.h"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "steradian/apps/steradian/scene_json.h"
#include "steradian/core/image/image_io.h"
#include "steradian/integrators/render/render.h"

namespace steradian::bench {
namespace {

/// The text as one word for the shell.
std::string shellWord(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

/// The last line that is not empty: usually the error message.
std::string lastLine(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \n\r");
  if (end == std::string::npos) return "it said nothing";
  const std::size_t before = text.rfind('\n', end);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1;
  return text.substr(begin, end + 1 - begin);
}

/// What Blender prints, both streams together. Throws Error (Other) if it fails.
std::string blender(const std::string& arguments) {
  std::FILE* pipe = ::popen(("blender " + arguments + " 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) throw Error(ErrorKind::Other, "cannot run blender");
  std::string text;
  char part[4096];
  while (const std::size_t count = std::fread(part, 1, sizeof part, pipe)) text.append(part, count);
  if (::pclose(pipe) != 0) throw Error(ErrorKind::Other, "Blender failed: " + lastLine(text));
  return text;
}

/// The number behind the last `label`, if there is one.
std::optional<double> numberAfter(const std::string& text, const std::string& label) {
  const std::size_t found = text.rfind(label);
  if (found == std::string::npos) return std::nullopt;
  const char* const begin = text.c_str() + found + label.size();
  char* end = nullptr;
  const double value = std::strtod(begin, &end);
  return end == begin ? std::nullopt : std::optional(value);
}

}  // namespace

Steradian::Steradian(const SceneDescription& scene, const BenchOptions& options, std::uint32_t reuse)
    : width_(options.width),
      height_(options.height),
      integrator_({.reuse = reuse}),
      execution_{.width = options.pathWidth},
      threads_(options.threads) {
  threads_.run([&] { scene_ = std::make_unique<Scene>(scene); });
}

TimedPicture Steradian::render(std::uint32_t samplesPerPixel, std::uint32_t seed) {
  RenderSettings settings;
  settings.width = width_;
  settings.height = height_;
  settings.samplesPerPixel = samplesPerPixel;
  settings.seed = seed;
  settings.execution = execution_;
  const RenderResult result = threads_.run([&] { return steradian::render(*scene_, integrator_, settings); });
  return {result.film.image({.features = false, .errors = false}), result.statistics.sampleSeconds};
}

Cycles::Cycles(const SceneDescription& scene, const BenchOptions& options, std::filesystem::path folder)
    : folder_(std::move(folder)),
      script_(options.cyclesScript),
      width_(options.width),
      height_(options.height),
      threads_(options.threads) {
  if (!std::filesystem::exists(script_)) {
    throw Error(ErrorKind::Usage, "there is no " + script_ + ": start in the project's folder or give --cycles-script");
  }
  std::ofstream(folder_ / "scene.json") << app::toJson(scene);
}

TimedPicture Cycles::render(std::uint32_t samplesPerPixel, std::uint32_t seed) {
  const std::filesystem::path picture = folder_ / "picture.exr";
  std::filesystem::remove(picture);
  const std::string output = blender(
      fmt::format("-b --factory-startup --debug-cycles --python-exit-code 1 -P {} -- {} {} --spp {} --size {}x{} "
                  "--threads {} --seed {}",
                  shellWord(script_), shellWord((folder_ / "scene.json").string()), shellWord(picture.string()),
                  samplesPerPixel, width_, height_, threads_, seed));
  const std::optional<double> seconds = numberAfter(output, "Path Tracing  ");
  if (!seconds || !std::filesystem::exists(picture)) {
    throw Error(ErrorKind::Other, "Cycles rendered nothing: " + lastLine(output));
  }
  return {readImage(picture), *seconds};
}

bool Cycles::available() { return std::system("command -v blender >/dev/null 2>&1") == 0; }

}  // namespace steradian::bench
