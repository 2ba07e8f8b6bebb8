#pragma once
/// Renders what a command says, in this process.
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
  bool quick = false;  ///< small pictures of few samples: to see that everything works

  /// Options that overrule those of a command, as the last ones count.
  std::vector<std::string> overrules() const;
  /// Of each half of a reference, per pixel.
  std::uint32_t referenceSamples() const { return quick ? 64 : 256; }
};

/// What `steradian` would make of the words, "render" first. Throws Error (Usage) as it does.
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

/// Of the path integrator and the settings that the options say, or of an integrator given.
Rendering renderScene(const Scene& scene, app::RenderOptions options, const Integrator* integrator = nullptr);
/// Builds the scene first; with the picture's mistake.
Rendering renderPicture(const NumberedPicture& picture, const Effort& effort);
/// The file of a picture, by the view that its command says.
void writePicture(const Rendering& rendering, const std::filesystem::path& path);

}  // namespace steradian::books
