#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "steradian/apps/scenes/scenes.h"
#include "steradian/apps/steradian/commands.h"
#include "steradian/apps/steradian/console.h"
#include "steradian/apps/steradian/exit_codes.h"

namespace steradian::app {

namespace {

int listScenes(bool asJson) {
  std::string text;
  if (asJson) {
    nlohmann::json list = nlohmann::json::array();
    for (const SceneInfo& scene : builtInScenes()) list.push_back({{"name", scene.name}, {"summary", scene.summary}});
    text = list.dump(2) + "\n";
  } else {
    for (const SceneInfo& scene : builtInScenes()) text += fmt::format("{:<24}{}\n", scene.name, scene.summary);
  }
  printOut(text);
  return kExitSuccess;
}

}  // namespace

void addScenesCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("scenes", "List the built-in scenes");
  auto asJson = std::make_shared<bool>(false);
  command->add_flag("--json", *asJson, "print JSON");
  command->callback([&run, asJson] {
    run = [asJson](Arguments& arguments) {
      arguments.throwIfProblems();
      return listScenes(*asJson);
    };
  });
}

}  // namespace steradian::app
