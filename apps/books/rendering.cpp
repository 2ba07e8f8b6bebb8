#include "steradian/apps/books/rendering.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "steradian/core/image/image_io.h"
#include "steradian/integrators/make_integrator.h"

namespace steradian::books {

std::vector<std::string> Effort::overrules() const {
  return quick ? std::vector<std::string>{"--size", "48x36", "--spp", "16"} : std::vector<std::string>{};
}

app::RenderOptions parseRender(const std::vector<std::string>& words) {
  CLI::App program;
  CLI::App* command = program.add_subcommand("render");
  app::RenderTexts texts;
  app::declareRenderOptions(*command, texts);
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  try {
    program.parse(reversed);
  } catch (const CLI::ParseError& problem) {
    throw Error(ErrorKind::Usage, problem.what());
  }
  app::Arguments arguments;
  return app::checkRenderOptions(texts, arguments);
}

app::RenderOptions optionsOf(const NumberedPicture& picture, const Effort& effort) {
  std::vector<std::string> words = picture.command;
  for (const std::string& word : effort.overrules()) words.push_back(word);
  if (effort.quick && picture.enlarged) words.insert(words.end(), {"--crop", "10,26,6,15"});
  return parseRender(words);
}

Rendering renderScene(const Scene& scene, app::RenderOptions options, const Integrator* integrator) {
  std::unique_ptr<const Integrator> own;
  if (integrator == nullptr) {
    own = makeIntegrator(options.integrator, options.settings.execution).integrator;
    integrator = own.get();
  }
  RenderResult result = render(scene, *integrator, options.settings);
  options.settings = result.settings;
  options.scene = {};
  return {result.film.image({.features = false}), result.statistics, std::move(options)};
}

Rendering renderPicture(const NumberedPicture& picture, const Effort& effort) {
  app::RenderOptions options = optionsOf(picture, effort);
  const Scene scene(std::move(options.scene));
  const BookIntegrator wrong(picture.mistake);
  return renderScene(scene, std::move(options), picture.mistake == Mistake::None ? nullptr : &wrong);
}

void writePicture(const Rendering& rendering, const std::filesystem::path& path) {
  const Image shown = rendering.options.display->apply(rendering.image, rendering.options.view);
  writeImage(shown, path, {.format = imageFormatOf(path.string())});
}

}  // namespace steradian::books
