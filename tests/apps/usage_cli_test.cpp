/// Wrong command lines: exit code 2, one line per mistake, all mistakes at once, and nothing written. The values of
/// options are render_options_test.cpp's: starting the program takes long.
#include <sstream>

#include "steradian/tests/apps/cli_test.h"

namespace steradian::cli {
namespace {

using Usage = CliTest;

TEST_F(Usage, HelpIsForStandardOutput) {
  const Outcome help = run({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_EQ(help.error, "");
  for (const char* word : {"Usage: steradian", "render", "scenes", "info", "diff", "Exit codes: 0 done; 2 wrong usage"})
    EXPECT_NE(help.output.find(word), std::string::npos) << word;
}

TEST_F(Usage, TheHelpOfRenderListsTheIntegratorsKeys) {
  const Outcome help = run({"render", "--help"});
  EXPECT_EQ(help.exitCode, 0);
  for (const char* word : {"Usage: steradian render", "path ", "normals ", "ambient-occlusion ", "strategy=mis",
                           "scatter-pdf=bsdf", "75 stopped early, picture saved"})
    EXPECT_NE(help.output.find(word), std::string::npos) << word;
  std::istringstream text(help.output);
  for (std::string line; std::getline(text, line);) EXPECT_LE(line.size(), 110u) << line;
}

TEST_F(Usage, Words) {
  expectComplaints(run({}), 2, {"a command is needed"});
  expectComplaints(run({"rendr"}), 2, {R"("rendr" (did you mean "render"?))"});
  expectComplaints(run({"render"}), 2, {"scene is required"});
  expectComplaints(run({"info", "quads", "again", "--jsn"}), 2,
                   {R"(unexpected argument "again")", R"("--jsn" (did you mean "--json"?))"});
  expectComplaints(run({"info", "quds"}), 2,
                   {R"x(unknown scene "quds"; `steradian scenes` lists them (did you mean "quads"?))x"});
}

TEST_F(Usage, AllMistakesAtOnce) {
  expectComplaints(run({"render", "cornel-box", "--siz", "9x9", "--spp", "0", "--view", "Bok", "-o", "a.gif"}), 2,
                   {R"(unexpected argument "--siz")", "--spp", R"(unknown view "Bok")", R"(extension "gif")",
                    R"(unknown scene "cornel-box")"});
}

TEST_F(Usage, OfAnOptionGivenTwiceTheLastCounts) {
  EXPECT_EQ(render({"--size", "7x5", "-o", "a.png"}).exitCode, 0);
  EXPECT_EQ(image("a.png").width(), 7);
}

TEST_F(Usage, TheColourConfigurationIsNamed) {
  Launch what{.arguments = renderArguments({"-o", "a.png"}), .environment = {"OCIO=/nonsense"}};
  expectComplaints(launch(what), 2, {"$OCIO: the colour configuration \"/nonsense\""});
  what.arguments = renderArguments({"-o", "a.exr"});
  EXPECT_EQ(launch(what).exitCode, 0) << "EXR is not display-transformed";
}

}  // namespace
}  // namespace steradian::cli
