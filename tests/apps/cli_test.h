#pragma once
/// What the tests of the command line share.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "steradian/core/image/image_io.h"
#include "steradian/tests/apps/run_program.h"

namespace steradian::cli {

/// Each test runs the program in an empty directory of its own.
class CliTest : public testing::Test {
 protected:
  CliTest() {
    std::string name = (std::filesystem::temp_directory_path() / "steradian-cli-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a directory");
    directory_ = name;
  }
  ~CliTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }

  Outcome launch(const Launch& what) const { return Program(what, directory_).wait(); }
  Outcome run(std::vector<std::string> arguments) const { return launch({.arguments = std::move(arguments)}); }
  /// `render SCENE --size 20x15 --spp 2 -q` and more.
  Outcome render(const std::vector<std::string>& more, const std::string& scene = "cornell-box") const {
    return run(renderArguments(more, scene));
  }
  static std::vector<std::string> renderArguments(const std::vector<std::string>& more,
                                                  const std::string& scene = "cornell-box") {
    std::vector<std::string> arguments{"render", scene, "--size", "20x15", "--spp", "2", "-q"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  std::filesystem::path path(const std::string& name) const { return directory_ / name; }
  Image image(const std::string& name) const { return readImage(path(name)); }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(directory_)) names.insert(entry.path().filename());
    return names;
  }
  const std::filesystem::path& directory() const { return directory_; }

 private:
  std::filesystem::path directory_;
};

/// Errors are one line each, which begins with "error: ", and possibly a hint at the end.
inline void expectComplaints(const Outcome& outcome, int exitCode, const std::vector<std::string_view>& parts) {
  EXPECT_EQ(outcome.exitCode, exitCode) << outcome.error;
  EXPECT_EQ(outcome.output, "");
  std::vector<std::string> lines = outcome.errorLines();
  if (!lines.empty() && lines.back().starts_with("Try `steradian")) lines.pop_back();
  EXPECT_EQ(lines.size(), parts.size()) << outcome.error;
  for (const std::string& line : lines) {
    EXPECT_TRUE(line.starts_with("error: ") || line.find(": error: ") != std::string::npos) << line;
    EXPECT_EQ(line.find("error: error"), std::string::npos) << line;
  }
  for (const std::string_view part : parts)
    EXPECT_NE(outcome.error.find(part), std::string::npos) << part << "\nis not in\n" << outcome.error;
}

}  // namespace steradian::cli
