#pragma once
/// The command line of `steradian-montecarlo`.
#include <optional>
#include <string>
#include <vector>

#include "steradian/apps/montecarlo/programme.h"
#include "steradian/apps/steradian/arguments.h"

namespace steradian::montecarlo {

/// As the user wrote it.
struct OptionTexts {
  std::string name;
  std::optional<std::string> samples, seed, sampler, plot, picture;
  bool json = false;
};

struct Options {
  std::vector<const Programme*> programmes;
  RunSettings settings;
  std::optional<std::string> plot, picture;  ///< files
  bool json = false;
};

/// Parses the texts. Adds what is wrong with them to `arguments`, and throws Error (Usage) if anything is; throws Error
/// (Output) for files that cannot be written.
Options optionsOf(const OptionTexts& texts, app::Arguments& arguments);

}  // namespace steradian::montecarlo
