#pragma once
/// Executes a render command in this process.
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "steradian/apps/books/picture.h"
#include "steradian/apps/steradian/render_options.h"
#include "steradian/integrators/render/render.h"

namespace steradian::books {

/// How much of the work is done.
struct Effort {
  bool quick = false;  ///< small pictures of few samples, as a quick check

  /// Options that, put last, override those of a command.
  std::vector<std::string> overrules() const;
  /// Of each half of a reference, per pixel.
  std::uint32_t referenceSamples() const { return quick ? 64 : 256; }
};

/// Parses the words, "render" first, as `steradian` does. Throws Error (Usage) as it does.
app::RenderOptions parseRender(const std::vector<std::string>& words);
/// The options of a picture.
app::RenderOptions optionsOf(const NumberedPicture& picture, const Effort& effort);

struct Rendering {
  Image image;  ///< with standard errors
  RenderStatistics statistics;
  app::RenderOptions options;  ///< without the scene

  double seconds() const { return statistics.sampleSeconds; }
  double samplesPerSecond() const { return static_cast<double>(statistics.samples) / seconds(); }
};

/// Renders with the path integrator and settings of the options, or with the given integrator.
Rendering renderScene(const Scene& scene, app::RenderOptions options, const Integrator* integrator = nullptr);
/// Builds the scene first; with the picture's mistake.
Rendering renderPicture(const NumberedPicture& picture, const Effort& effort);
/// Writes the picture's file, with the view that its command names.
void writePicture(const Rendering& rendering, const std::filesystem::path& path);

}  // namespace steradian::books
