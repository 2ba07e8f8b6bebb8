#pragma once
/// Parses a command line and reports all mistakes at once.
#include <CLI/CLI.hpp>
#include <optional>

#include "steradian/apps/steradian/arguments.h"

namespace steradian::app {

/// For a program without commands: parses, prints the texts of --help and --version, and adds what is wrong and which
/// words are unknown to `arguments`. The exit code if the program is done.
std::optional<int> parse(CLI::App& app, int argc, char** argv, Arguments& arguments);

}  // namespace steradian::app
