#include "steradian/apps/steradian/parse.h"

#include "steradian/apps/steradian/console.h"
#include "steradian/apps/steradian/exit_codes.h"

namespace steradian::app {

std::optional<int> parse(CLI::App& app, int argc, char** argv, Arguments& arguments) {
  app.allow_extras();  // we report unknown words ourselves, together with bad values
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    printOut(app.help());
    return kExitSuccess;
  } catch (const CLI::CallForVersion&) {
    printOut(app.version() + "\n");
    return kExitSuccess;
  } catch (const CLI::ParseError& problem) {
    arguments.problem(problem.what());
  }
  std::vector<std::string> known;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
  arguments.unexpected(app.remaining(true), known);
  return std::nullopt;
}

}  // namespace steradian::app
