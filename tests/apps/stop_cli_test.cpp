/// Ctrl-C and SIGTERM: the unfinished picture is saved.
#include <csignal>

#include "steradian/tests/apps/cli_test.h"

namespace steradian::cli {
namespace {

class Stop : public CliTest {
 protected:
  /// A render that would take hours; -v says when it has begun.
  static Launch endless() {
    return {.arguments = {"render", "cornell-box", "--size", "32x32", "--spp", "16777216", "-v", "-o", "a.exr", "-o",
                          "a.png"}};
  }
};

TEST_F(Stop, SavesThePicture) {
  for (const int signal : {SIGINT, SIGTERM}) {
    Program program(endless(), directory());
    ASSERT_TRUE(program.waitForError("primitives"));
    program.send(signal);
    const Outcome outcome = program.wait();
    EXPECT_EQ(outcome.exitCode, 75) << outcome.error;
    EXPECT_NE(outcome.error.find("of 16777216 samples per pixel"), std::string::npos) << outcome.error;
    EXPECT_EQ(image("a.exr").width(), 32);
    EXPECT_EQ(files(), (std::set<std::string>{"a.exr", "a.png"}));
    for (const std::string& name : files()) std::filesystem::remove(path(name));
  }
}

TEST_F(Stop, ASecondSignalDoesNotWait) {
  // One tile of minutes, which a first signal waits for.
  Program program({.arguments = {"render", "cornell-box", "--size", "300x300", "--tile", "4096", "--spp", "1", "-v",
                                 "--integrator", "path:light-samples=1024", "-o", "a.png"}},
                  directory());
  ASSERT_TRUE(program.waitForError("primitives"));
  program.send(SIGINT);
  ASSERT_TRUE(program.waitForError("once more"));
  program.send(SIGINT);
  EXPECT_EQ(program.wait().exitCode, 1);
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace steradian::cli
