/// The program `steradian`.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "steradian/apps/steradian/commands.h"
#include "steradian/apps/steradian/console.h"
#include "steradian/apps/steradian/exit_codes.h"
#include "steradian/apps/steradian/program.h"
#include "steradian/core/base/diagnostics.h"

namespace {

using namespace steradian;
using namespace steradian::app;

constexpr const char* kExitCodes =
    "Exit codes: 0 done; 2 wrong usage; 65 bad scene or asset; 71 out of memory; 74 output could not be written;\n"
    "75 stopped early, picture saved; 1 anything else.";

std::vector<CLI::App*> commandsOf(CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

/// The command that the user gave, or the program itself.
CLI::App& chosen(CLI::App& app) {
  const auto commands = app.get_subcommands();
  return commands.empty() ? app : *commands.front();
}

/// The names that the user may have meant: of commands, or of the options of the command that was given.
std::vector<std::string> knownWords(CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::Option* option : chosen(app).get_options())
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  if (&chosen(app) == &app)
    for (const CLI::App* command : commandsOf(app)) words.push_back(command->get_name());
  return words;
}

void printHint(CLI::App& app) {
  printErr(fmt::format("Try `steradian {}--help`.\n", &chosen(app) == &app ? "" : chosen(app).get_name() + " "));
}

/// CLI11 reports what it was configured to check: a command, arguments, values of options.
int reportUsage(CLI::App& app, const CLI::ParseError& problem, Arguments& arguments) {
  const std::vector<std::string> unknown = app.remaining(true);
  arguments.unexpected(unknown, knownWords(app));
  if (unknown.empty()) {
    const bool noCommand = &chosen(app) == &app;
    arguments.problem(noCommand ? "a command is needed: render, scenes, info or diff" : problem.what());
  }
  try {
    arguments.throwIfProblems();
  } catch (const Error& error) {
    printErr(std::string(error.what()) + "\n");
  }
  printHint(app);
  return kExitUsage;
}

int runProgram(int argc, char** argv) {
  CLI::App app{"Steradian: a path tracer for the scenes of Peter Shirley's books"};
  app.name("steradian");
  app.set_version_flag("--version", STERADIAN_VERSION, "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.require_subcommand(1);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  Run run;
  addRenderCommand(app, run);
  addScenesCommand(app, run);
  addInfoCommand(app, run);
  addDiffCommand(app, run);
  app.footer(kExitCodes);
  for (CLI::App* command : commandsOf(app)) {
    command->group("Commands");
    command->footer(command->get_footer() + (command->get_footer().empty() ? "" : "\n") + kExitCodes);
    command->allow_extras();  // we report unknown words ourselves, together with bad values
  }
  Arguments arguments;
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    printOut(app.help());
    return kExitSuccess;
  } catch (const CLI::CallForVersion&) {
    printOut(STERADIAN_VERSION "\n");
    return kExitSuccess;
  } catch (const CLI::ParseError& problem) {
    return reportUsage(app, problem, arguments);
  }
  const std::vector<std::string> unknown = app.remaining(true);
  arguments.unexpected(unknown, knownWords(app));
  try {
    return run(arguments);
  } catch (const Error& error) {
    printErr(std::string(error.what()) + "\n");
    if (!unknown.empty()) printHint(app);
    return exitCodeOf(error.kind());
  }
}

}  // namespace

int main(int argc, char** argv) {
  return steradian::app::runMain([&] { return runProgram(argc, argv); });
}
