#include "steradian/apps/montecarlo/options.h"

#include <fmt/format.h>

#include <limits>

#include "steradian/core/base/atomic_file.h"

namespace steradian::montecarlo {

namespace {

std::vector<const Programme*> chosen(const std::string& name, app::Arguments& arguments) {
  std::vector<const Programme*> list;
  std::vector<std::string> names{"all"};
  for (const Programme& programme : programmes()) {
    if (name == "all" || name == programme.name) list.push_back(&programme);
    names.push_back(programme.name);
  }
  if (name.empty()) {
    arguments.problem("the name of a programme is needed, or \"all\"");
  } else if (list.empty()) {
    arguments.problem(fmt::format("unknown programme \"{}\"; `steradian-montecarlo --help` lists them", name),
                      didYouMean(name, names));
  }
  return list;
}

SamplerType samplerOf(const std::string& name, app::Arguments& arguments) {
  const auto type = samplerTypeOf(name);
  if (!type)
    arguments.problem(fmt::format("--sampler: unknown sampler \"{}\"", name),
                      didYouMean(name, {"independent", "stratified", "sobol"}));
  return type.value_or(SamplerType::Independent);
}

void checkPicture(std::string_view option, const std::string& path, app::Arguments& arguments) {
  if (!path.ends_with(".svg"))
    arguments.problem(fmt::format("{} needs the name of a file that ends in .svg, not \"{}\"", option, path));
}

/// Adds a problem if no programme supports the option.
void checkPurpose(const Options& options, app::Arguments& arguments) {
  bool plots = false, draws = false;
  for (const Programme* programme : options.programmes) {
    plots = plots || programme->series;
    draws = draws || programme->name == "directions";
  }
  if (options.programmes.empty()) return;
  if (options.plot && !plots)
    arguments.problem(fmt::format("--plot: \"{}\" has no error to plot", options.programmes.front()->name));
  if (options.picture && !draws) arguments.problem("--picture is for \"directions\" (or \"all\")");
  if (options.plot && options.plot == options.picture)
    arguments.problem("--plot and --picture need files of their own");
}

}  // namespace

Options optionsOf(const OptionTexts& texts, app::Arguments& arguments) {
  Options options{chosen(texts.name, arguments), {}, texts.plot, texts.picture, texts.json};
  if (texts.samples) options.settings.samples = arguments.whole("--samples", *texts.samples, 1024, 1u << 30);
  if (texts.seed)
    options.settings.seed = arguments.whole("--seed", *texts.seed, 0, std::numeric_limits<std::uint32_t>::max());
  if (texts.sampler) options.settings.sampler = samplerOf(*texts.sampler, arguments);
  if (texts.plot) checkPicture("--plot", *texts.plot, arguments);
  if (texts.picture) checkPicture("--picture", *texts.picture, arguments);
  checkPurpose(options, arguments);
  arguments.throwIfProblems();
  if (options.plot) checkWritable(*options.plot);
  if (options.picture) checkWritable(*options.picture);
  return options;
}

}  // namespace steradian::montecarlo
