#pragma once
/// The options of `steradian render`, as text from the command line and as checked values.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "steradian/accel/accel.h"
#include "steradian/apps/steradian/arguments.h"
#include "steradian/core/colour/display.h"
#include "steradian/core/image/image_io.h"
#include "steradian/core/scene/description.h"
#include "steradian/integrators/render/render_settings.h"

namespace CLI {
class App;
}

namespace steradian::app {

/// What the user typed; nothing: the option was not given.
struct RenderTexts {
  std::string scene;
  std::vector<std::string> outputs;
  std::optional<std::string> size, samples, time, seed, threads, crop, tileSize;
  std::optional<std::string> sampler, filter, replicates;
  std::optional<std::string> integrator, strategy, maxDepth, targets, reuse, pathWidth, isa, accel;
  std::optional<std::string> texture, sky;
  std::optional<std::string> format, display, view, exposure;
  std::optional<std::string> statistics;
  bool quiet = false, verbose = false;
};

struct Output {
  std::filesystem::path path;
  ImageFormat format;
};

enum class StatisticsFormat { None, Text, Json };

struct RenderOptions {
  SceneDescription scene;
  std::vector<Output> outputs;
  RenderSettings settings;         ///< with --isa and --width
  Accel accel = Accel::Auto;       ///< acceleration structure of the scene
  std::string integrator;          ///< a complete spec
  std::string replay;              ///< the options, as typed, that choose the samples of a pixel
  int threads = 0;                 ///< 0: all processors
  std::optional<Display> display;  ///< if an output is display-referred
  DisplaySettings view;            ///< of display-referred outputs
  StatisticsFormat statistics = StatisticsFormat::None;
  bool quiet = false, verbose = false;
};

/// Declares the options on `command`, with a footer that lists integrators and views.
void declareRenderOptions(CLI::App& command, RenderTexts& texts);

/// Checks everything that can be checked before the scene is built, and reads the pictures that replace those of the
/// scene. Throws Error: Usage with all problems at once, including those already in `arguments`; Scene or Memory for
/// pictures (see readColourImage).
RenderOptions checkRenderOptions(const RenderTexts& texts, Arguments& arguments);

}  // namespace steradian::app
