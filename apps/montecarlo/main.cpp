/// The program `steradian-montecarlo`: the numeric programmes of "Ray Tracing: The Rest of Your Life".
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "steradian/apps/montecarlo/direction_picture.h"
#include "steradian/apps/montecarlo/options.h"
#include "steradian/apps/montecarlo/plot.h"
#include "steradian/apps/montecarlo/report.h"
#include "steradian/apps/steradian/console.h"
#include "steradian/apps/steradian/exit_codes.h"
#include "steradian/apps/steradian/parse.h"
#include "steradian/apps/steradian/program.h"
#include "steradian/core/base/atomic_file.h"

namespace {

using namespace steradian;
using namespace steradian::app;
using namespace steradian::montecarlo;

/// The books show 200; a power of two is a net.
constexpr std::uint32_t kDirections = 256;

std::string footer() {
  std::string text = "Programmes (\"all\" runs all of them):\n";
  for (const Programme& programme : programmes())
    text += fmt::format("  {:<20} {}\n", programme.name, programme.summary);
  return text +
         "\nExit codes: 0 done; 2 wrong usage; 71 out of memory; 74 output could not be written; 1 anything else.";
}

void write(const std::string& path, const std::string& text) {
  writeFileAtomically(path, std::as_bytes(std::span(text)));
}

/// A plot of all series of the programmes.
std::string plotOf(const Options& options) {
  std::vector<Panel> panels;
  for (const Programme* programme : options.programmes) {
    if (!programme->series) continue;
    panels.push_back({programme->name, programme->summary, {}});
    for (const Series& series : programme->series(options.settings.seed))
      panels.back().curves.push_back(errorCurve(series));
  }
  return plotSvg(panels);
}

int runOptions(const Options& options) {
  std::vector<Outcome> outcomes;
  for (const Programme* programme : options.programmes)
    outcomes.push_back({programme, programme->run(options.settings)});
  if (options.plot) write(*options.plot, plotOf(options));
  if (options.picture) write(*options.picture, directionsSvg(kDirections, options.settings.seed));
  std::string text;
  if (options.json) {
    text = reportJson(outcomes, options.settings);
  } else {
    for (const Outcome& outcome : outcomes) text += (text.empty() ? "" : "\n") + reportText(outcome);
  }
  printOut(text);
  return kExitSuccess;
}

int runProgram(int argc, char** argv) {
  CLI::App app{
      "The numeric programmes of \"Ray Tracing: The Rest of Your Life\": estimate, interval, exact value, and the\n"
      "figure that the book prints"};
  app.name("steradian-montecarlo");
  app.set_version_flag("--version", STERADIAN_VERSION, "print the version");
  app.set_help_flag("-h,--help", "print this help");
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  OptionTexts texts;
  app.add_option("NAME", texts.name, "a programme, or all")->option_text(" ");
  app.add_option("--samples", texts.samples, "samples of each estimate (1048576)")->option_text("N");
  app.add_option("--seed", texts.seed, "other seeds give other samples (0)")->option_text("K");
  app.add_option("--sampler", texts.sampler,
                 "independent, stratified or sobol, for programmes that leave the choice (independent)")
      ->option_text("S");
  app.add_option("--plot", texts.plot, "draw the error against the number of samples, with fitted slopes")
      ->option_text("FILE.svg");
  app.add_option("--picture", texts.picture, "draw the directions of \"directions\"")->option_text("FILE.svg");
  app.add_flag("--json", texts.json, "print JSON");
  app.footer(footer());
  Arguments arguments;
  if (const auto done = parse(app, argc, argv, arguments)) return *done;
  return runOptions(optionsOf(texts, arguments));
}

}  // namespace

int main(int argc, char** argv) {
  return steradian::app::runMain([&] { return runProgram(argc, argv); });
}
