#pragma once
/// The program's commands. Each function adds its command to `app`; when the user calls it, `run` is set to the
/// function that does the work and returns the exit code.
#include <functional>

#include "steradian/apps/steradian/arguments.h"

namespace CLI {
class App;
}

namespace steradian::app {

/// Takes the problems of the command line so far, adds others, and throws before any work if there are any.
using Run = std::function<int(Arguments&)>;

void addRenderCommand(CLI::App& app, Run& run);
void addScenesCommand(CLI::App& app, Run& run);
void addInfoCommand(CLI::App& app, Run& run);
void addDiffCommand(CLI::App& app, Run& run);

}  // namespace steradian::app
