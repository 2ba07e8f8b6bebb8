#include "steradian/apps/steradian/render_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "steradian/apps/scenes/scenes.h"
#include "steradian/apps/steradian/arguments.h"
#include "steradian/core/colour/colour_image.h"
#include "steradian/integrators/make_integrator.h"

namespace steradian::app {

namespace {

constexpr std::uint32_t kMaxSamples = 1u << 24;
constexpr std::uint32_t kMaxThreads = 1024;

/// The integrators and their keys, for --help.
std::string integratorHelp() {
  std::string text =
      "Integrators (NAME{:KEY=VALUE}, such as path:strategy=mixture:light-samples=4) and their defaults:\n";
  for (const IntegratorInfo& info : integratorRegistry()) {
    text += fmt::format("  {:<28}{}\n", info.name, info.help);
    for (const IntegratorKey& key : info.keys)
      text += fmt::format("    {:<26}{}\n", fmt::format("{}={}", key.name, key.defaultValue), key.help);
  }
  return text;
}

constexpr const char* kNotes =
    "\nOf an option that is given twice the last counts. $OCIO names another colour configuration for --display and\n"
    "--view. --strategy, --max-depth, --target, --reuse and --width are short for keys of --integrator path.\n";

/// Runs a parser of the library that throws, and collects its errors.
template <class Parse>
void collect(Arguments& arguments, Parse parse) {
  try {
    parse();
  } catch (const Error& error) {
    for (const Diagnostic& d : error.diagnostics()) arguments.problem(d.message, d.suggestion);
  }
}

/// The user's colour configuration ($OCIO) or the built-in one.
Display openDisplay() {
  const char* path = std::getenv("OCIO");
  if (path == nullptr || *path == '\0') return Display();
  try {
    return Display(std::filesystem::path(path));
  } catch (const Error& error) {
    throw Error(error.kind(), "$OCIO: " + error.diagnostics().front().message);
  }
}

std::vector<Output> checkOutputs(const RenderTexts& texts, Arguments& arguments) {
  std::optional<ImageFormat> format;
  bool formatUsed = false, standardOutput = false;
  if (texts.format) {
    try {
      format = imageFormatOf("a." + *texts.format);
    } catch (const Error&) {
      arguments.problem(fmt::format("--format: unknown format \"{}\"", *texts.format),
                        didYouMean(*texts.format, {"exr", "png", "jpg", "tif", "hdr", "ppm"}));
    }
  }
  std::vector<Output> outputs;
  for (const std::string& path : texts.outputs) {
    std::error_code ignored;
    const bool isDevice = path == "-" || std::filesystem::is_character_file(path, ignored);
    if (isDevice || !std::filesystem::path(path).has_extension()) {
      formatUsed = true;
      if (path == "-" && std::exchange(standardOutput, true)) arguments.problem("-o - is given twice");
      if (format) outputs.push_back({path, *format});
      if (!texts.format && isDevice) arguments.problem(fmt::format("-o {} needs --format, such as --format png", path));
      if (texts.format || isDevice) continue;
    }
    collect(arguments, [&] { outputs.push_back({path, imageFormatOf(path)}); });
  }
  if (format && !formatUsed) arguments.problem("--format is for -o - and for files without an extension");
  if (standardOutput && texts.statistics == "json")
    arguments.problem("-o - and --stats=json cannot both go to standard output");
  return outputs;
}

std::vector<std::string> samplerNames() {
  std::vector<std::string> names;
  names.reserve(kSamplerTypes.size());
  for (const SamplerType type : kSamplerTypes) names.emplace_back(nameOf(type));
  return names;
}

std::optional<Filter> checkFilter(const std::string& text, Arguments& arguments) {
  const std::size_t colon = text.find(':');
  std::optional<float> radius;
  if (colon != std::string::npos)
    radius = static_cast<float>(arguments.number("--filter's radius", text.substr(colon + 1), 0.01, 16.0));
  std::optional<Filter> filter;
  collect(arguments, [&] { filter = filterOf(text.substr(0, colon), radius); });
  return filter;
}

std::string integratorSpec(const RenderTexts& texts) {
  std::string spec = texts.integrator.value_or("path");
  if (texts.strategy) spec += ":strategy=" + *texts.strategy;
  if (texts.maxDepth) spec += ":max-depth=" + *texts.maxDepth;
  if (texts.targets) spec += ":targets=" + *texts.targets;
  if (texts.reuse) spec += ":reuse=" + *texts.reuse;
  if (texts.pathWidth) spec += ":width=" + *texts.pathWidth;
  return spec;
}

std::string replayOptions(const RenderTexts& texts, const std::string& integrator) {
  std::string text = fmt::format("--integrator '{}'", integrator);
  const auto add = [&](const char* option, const std::optional<std::string>& value) {
    if (value) text += fmt::format(" {} '{}'", option, *value);
  };
  add("--seed", texts.seed);
  add("--sampler", texts.sampler);
  add("--filter", texts.filter);
  add("--replicates", texts.replicates);
  add("--texture", texts.texture);
  add("--sky", texts.sky);
  return text;
}

/// Throws Error (Usage) for an instruction set that is unknown or not usable.
Isa checkIsa(const RenderTexts& texts) {
  const Isa isa = texts.isa ? isaOf(*texts.isa) : bestIsa();
  requireUsable(isa);
  return isa;
}

StatisticsFormat checkStatistics(const RenderTexts& texts, Arguments& arguments) {
  if (!texts.statistics) return StatisticsFormat::None;
  if (*texts.statistics == "json") return StatisticsFormat::Json;
  if (*texts.statistics != "text")
    arguments.problem(fmt::format("--stats: unknown format \"{}\"", *texts.statistics),
                      didYouMean(*texts.statistics, {"text", "json"}));
  return StatisticsFormat::Text;
}

void checkDisplay(const RenderTexts& texts, RenderOptions& options, Arguments& arguments) {
  options.view = {.display = texts.display.value_or(""), .view = texts.view.value_or("")};
  if (texts.exposure)
    options.view.exposure = static_cast<float>(arguments.number("--exposure", *texts.exposure, -64.0, 64.0));
  bool needed = texts.display || texts.view;
  for (const Output& output : options.outputs) needed |= isDisplayReferred(output.format);
  if (!needed) return;
  collect(arguments, [&] {
    options.display = openDisplay();
    options.display->check(options.view);
  });
}

RenderSettings checkSettings(const RenderTexts& texts, Arguments& arguments) {
  RenderSettings settings;
  if (texts.size) {
    const Size size = arguments.size("--size", *texts.size);
    settings.width = size.width;
    settings.height = size.height;
  }
  if (texts.samples) settings.samplesPerPixel = arguments.whole("--spp", *texts.samples, 1, kMaxSamples);
  if (texts.time) settings.timeLimit = arguments.seconds("--time", *texts.time);
  if (texts.seed) settings.seed = arguments.whole("--seed", *texts.seed, 0, 0xffffffffu);
  if (texts.replicates)
    settings.replicates = arguments.whole("--replicates", *texts.replicates, 1, Film::kMaxReplicates);
  if (texts.tileSize) settings.tileSize = static_cast<int>(arguments.whole("--tile", *texts.tileSize, 1, 4096));
  const std::string sampler = texts.sampler.value_or("sobol");
  if (const auto type = samplerTypeOf(sampler)) {
    settings.sampler = *type;
  } else {
    arguments.problem(fmt::format("--sampler: unknown sampler \"{}\"", sampler), didYouMean(sampler, samplerNames()));
  }
  if (const auto filter = checkFilter(texts.filter.value_or("box"), arguments)) settings.filter = *filter;
  return settings;
}

void checkCrop(const RenderTexts& texts, const RenderDefaults& defaults, RenderSettings& settings,
               Arguments& arguments) {
  if (!texts.crop) return;
  const Size full{settings.width.value_or(defaults.width), settings.height.value_or(defaults.height)};
  settings.crop = arguments.crop("--crop", *texts.crop, full);
}

bool hasImageTexture(const SceneDescription& scene) {
  for (const TextureDescription& texture : scene.textures)
    if (std::holds_alternative<ImageTexture>(texture)) return true;
  return false;
}

/// Puts a picture in the place of every image texture's.
void replaceTextures(SceneDescription& scene, const std::string& file) {
  const std::shared_ptr<const Image> picture = readColourImage(file);
  for (TextureDescription& texture : scene.textures) {
    auto* image = std::get_if<ImageTexture>(&texture);
    if (image == nullptr) continue;
    image->name = file;
    image->image = picture;
  }
}

/// FILE or FILE:DEGREES. What is behind the last colon belongs to the name unless it is a number.
ImageSky skyFrom(const std::string& text) {
  ImageSky sky;
  sky.name = text;
  const std::size_t colon = text.rfind(':');
  if (colon != std::string::npos && colon + 1 < text.size()) {
    float degrees = 0.0f;
    const char* last = text.data() + text.size();
    const auto [end, failure] = std::from_chars(text.data() + colon + 1, last, degrees);
    if (end == last && failure == std::errc{} && std::isfinite(degrees)) {
      sky.name = text.substr(0, colon);
      sky.rotation = degrees;
    }
  }
  sky.image = readColourImage(sky.name);
  return sky;
}

/// Puts a picture in the place of all skies of the scene.
void replaceSkies(SceneDescription& scene, const std::string& text) {
  std::erase_if(scene.lights, [](const LightDescription& light) {
    return std::holds_alternative<ConstantSky>(light.model) || std::holds_alternative<GradientSky>(light.model) ||
           std::holds_alternative<ImageSky>(light.model);
  });
  scene.addLight("sky", skyFrom(text));
}

}  // namespace

void declareRenderOptions(CLI::App& command, RenderTexts& texts) {
  command.add_option("scene", texts.scene, "a built-in scene (see `steradian scenes`)")->required()->type_name("SCENE");
  command
      .add_option("-o,--output", texts.outputs,
                  "write this file (.exr .png .jpg .tif .hdr .ppm),\nor - for standard output; may be repeated")
      ->allow_extra_args(false)
      ->type_name("FILE");
  const auto option = [&](const char* name, std::optional<std::string>& to, const char* type, const char* help) {
    command
        .add_option_function<std::string>(
            name, [&to](const std::string& text) { to = text; }, help)
        ->take_last()
        ->type_name(type);
  };
  option("--texture", texts.texture, "FILE", "a picture in the place of the scene's image textures");
  option("--sky", texts.sky, "FILE{:DEGREES}",
         "a picture in the place of the scene's skies:\nequirectangular, turned about the vertical");
  option("--format", texts.format, "FORMAT", "of -o - and of files without an extension");
  option("--size", texts.size, "WxH", "width and height in pixels (default: the scene's)");
  option("--spp", texts.samples, "N", "samples per pixel (default: the scene's)");
  option("--time", texts.time, "TIME", "render for this long: 90s, 1.5m, 2h; with --spp at most");
  option("--seed", texts.seed, "K", "of the random numbers (default 0)");
  option("-t,--threads", texts.threads, "N", "default: all processors; never changes the picture");
  option("--integrator", texts.integrator, "SPEC",
         "path (default), normals, albedo, depth, ambient-occlusion;\nkeys below");
  option("--strategy", texts.strategy, "S", "how light is found: bsdf, light, mis (default) or mixture");
  option("--max-depth", texts.maxDepth, "N", "bounces (default: the scene's); 0: emission only");
  option("--target", texts.targets, "NAMES",
         "what scattered rays aim at (mis, mixture): names of shapes,\nor lights; separated by commas (default: the "
         "scene's)");
  option("--reuse", texts.reuse, "N",
         "2, 4, 8, 16 or 32 neighbouring pixels share paths: in diffuse\nscenes far less noise, but their errors are "
         "correlated "
         "(default 1: none)");
  option("--width", texts.pathWidth, "N", "paths traced at once: 1, 4, 8 or 16; 0 (default): as many as pay here");
  option(
      "--isa", texts.isa, "NAME",
      "instruction set: baseline, avx2 or avx512 (default: the\nwidest of the processor); never changes the picture");
  option(
      "--accel", texts.accel, "NAME",
      "what intersects rays: auto (default), flat (each of at most 64\nprimitives in turn), bvh8 (our own hierarchy) "
      "or embree; never\nchanges the picture, but for meshes in the last bits");
  option("--crop", texts.crop, "x0,x1,y0,y1", "render only these pixels; y counts from the top");
  option("--sampler", texts.sampler, "NAME",
         "independent, stratified, halton, sobol (default),\nsobol-full, blue-noise or pmj02; stratified and\n"
         "blue-noise need --spp besides --time");
  option("--filter", texts.filter, "NAME{:RADIUS}",
         "box (default), triangle, gaussian, mitchell or\nblackman-harris; the radius in pixels");
  option("--replicates", texts.replicates, "R", "that many independent sequences: unbiased standard errors");
  option("--tile", texts.tileSize, "N", "edge of a tile in pixels (default 16);\nnever changes the picture");
  option("--display", texts.display, "NAME", "of the colour configuration, for PNG, JPEG, TIFF, PPM");
  option("--view", texts.view, "NAME", "of that display: sRGB (default), ACES SDR, Book or Raw");
  option("--exposure", texts.exposure, "STOPS", "for PNG, JPEG, TIFF, PPM (default 0)");
  command.add_flag("--stats{text}", texts.statistics,
                   "print statistics when done; --stats=json: as JSON, to\nstandard output");
  command.add_flag("-q,--quiet", texts.quiet, "no progress");
  command.add_flag("-v,--verbose", texts.verbose, "say what was built");
  command.footer(integratorHelp() + kNotes);
}

RenderOptions checkRenderOptions(const RenderTexts& texts, Arguments& arguments) {
  RenderOptions options;
  options.settings = checkSettings(texts, arguments);
  options.outputs = checkOutputs(texts, arguments);
  options.integrator = integratorSpec(texts);
  options.replay = replayOptions(texts, options.integrator);
  ExecutionSettings& execution = options.settings.execution;
  collect(arguments, [&] { execution.isa = checkIsa(texts); });
  collect(arguments, [&] { execution = makeIntegrator(options.integrator, execution).execution; });
  if (texts.threads) options.threads = static_cast<int>(arguments.whole("--threads", *texts.threads, 1, kMaxThreads));
  if (texts.accel) collect(arguments, [&] { options.accel = accelOf(*texts.accel); });
  options.statistics = checkStatistics(texts, arguments);
  checkDisplay(texts, options, arguments);
  collect(arguments, [&] {
    options.scene = makeScene(texts.scene);
    checkCrop(texts, options.scene.defaults, options.settings, arguments);
    if (texts.texture && !hasImageTexture(options.scene))
      arguments.problem(fmt::format("--texture: the scene \"{}\" has no image texture to replace", texts.scene));
  });
  options.quiet = texts.quiet;
  options.verbose = texts.verbose;
  arguments.throwIfProblems();
  if (texts.texture) replaceTextures(options.scene, *texts.texture);
  if (texts.sky) replaceSkies(options.scene, *texts.sky);
  return options;
}

}  // namespace steradian::app
