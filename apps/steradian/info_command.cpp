#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "steradian/apps/scenes/scenes.h"
#include "steradian/apps/steradian/commands.h"
#include "steradian/apps/steradian/console.h"
#include "steradian/apps/steradian/exit_codes.h"
#include "steradian/apps/steradian/memory_check.h"
#include "steradian/apps/steradian/render_report.h"
#include "steradian/apps/steradian/scene_json.h"
#include "steradian/core/base/build_info.h"
#include "steradian/core/scene/placements.h"
#include "steradian/integrators/path/path_kernels.h"
#include "steradian/integrators/scene/scene.h"

namespace steradian::app {

namespace {

struct InfoArguments {
  std::string scene;
  bool json = false, build = false;
};

std::string describe(const SceneDescription& scene) {
  std::string text = scene.name + "\n  primitives: ";
  const char* separator = "";
  for (const auto& [kind, count] : countPrimitives(scene)) {
    text += fmt::format("{}{} {}", separator, kind, count);
    separator = ", ";
  }
  const Placements placements(scene);
  std::uint64_t emitters = 0;
  std::string targets;
  for (Id id = 0; id < scene.shapes.size(); ++id) {
    const ShapeDescription& shape = scene.shapes[id];
    if (shape.emission != kNone) emitters += placements.countOf(id) * primitiveCount(shape.geometry);
    if (shape.target) targets += fmt::format("{}\"{}\"", targets.empty() ? "" : ", ", shape.name);
  }
  text += fmt::format("\n  materials:  {}\n  lights:     {} emitting primitives, {} others\n", scene.materials.size(),
                      emitters, scene.lights.size());
  if (!targets.empty()) text += "  targets:    " + targets + "\n";
  const RenderDefaults& d = scene.defaults;
  return text + fmt::format("  defaults:   {}x{}, {} samples per pixel, max depth {}\n", d.width, d.height,
                            d.samplesPerPixel, d.maxDepth);
}

nlohmann::ordered_json buildInfo() {
  nlohmann::ordered_json compiled, libraries{{"Embree", embreeVersion()}};
  for (const Isa isa : compiledIsas()) compiled.push_back(nameOf(isa));
  for (const LibraryVersion& library : libraryVersions()) libraries[library.name] = library.version;
  return {{"version", STERADIAN_VERSION}, {"compiler", compilerVersion()},   {"isas", compiled},
          {"isa", nameOf(bestIsa())},     {"width", nativeWidth(bestIsa())}, {"libraries", libraries}};
}

std::string describeBuild(const nlohmann::ordered_json& build) {
  const auto join = [](const auto& words) { return fmt::to_string(fmt::join(words, ", ")); };
  std::vector<std::string> libraries;
  for (const auto& [name, version] : build["libraries"].items())
    libraries.push_back(name + " " + version.get<std::string>());
  return fmt::format(
      "steradian {}\n  compiler:   {}\n  code for:   {}\n  used here:  {}, {} paths at once\n  libraries:  {}\n",
      build["version"].get<std::string>(), build["compiler"].get<std::string>(),
      join(build["isas"].get<std::vector<std::string>>()), build["isa"].get<std::string>(), build["width"].get<int>(),
      join(libraries));
}

int printInfo(const InfoArguments& given) {
  if (given.build) {
    const nlohmann::ordered_json build = buildInfo();
    printOut(given.json ? build.dump(1) + "\n" : describeBuild(build));
    return kExitSuccess;
  }
  SceneDescription description = makeScene(given.scene);
  if (given.json) {
    printOut(toJson(description).dump(1) + "\n");
    return kExitSuccess;
  }
  checkMemory(description, availableMemory());
  const std::string text = describe(description);
  const Scene scene(std::move(description));
  printOut(text + "  geometry:   " + geometrySummary(scene.geometry().statistics()) + "\n");
  return kExitSuccess;
}

}  // namespace

void addInfoCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("info", "Say what is in a scene, or in the program");
  auto given = std::make_shared<InfoArguments>();
  command->add_option("scene", given->scene, "a built-in scene (see `steradian scenes`)");
  command->add_flag("--json", given->json,
                    "print primitives, materials, lights and camera as JSON, complete enough to build the same scene");
  command->add_flag("--build", given->build,
                    "instead of a scene, say what the program was built with and which code it runs");
  command->callback([&run, given] {
    run = [given](Arguments& arguments) {
      if (given->build != given->scene.empty()) arguments.problem("info takes either a scene or --build");
      arguments.throwIfProblems();
      return printInfo(*given);
    };
  });
}

}  // namespace steradian::app
