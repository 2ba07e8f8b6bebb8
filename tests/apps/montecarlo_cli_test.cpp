/// `steradian-montecarlo` as a user runs it.
#include <nlohmann/json.hpp>

#include "steradian/tests/apps/cli_test.h"

namespace steradian::cli {
namespace {

class MonteCarlo : public CliTest {
 protected:
  Outcome montecarlo(std::vector<std::string> arguments) const {
    return launch({.arguments = std::move(arguments), .program = STERADIAN_MONTECARLO});
  }
};

TEST_F(MonteCarlo, HelpListsTheProgrammes) {
  const Outcome help = montecarlo({"--help"});
  EXPECT_EQ(help.exitCode, 0);
  EXPECT_EQ(help.error, "");
  for (const char* word : {"Usage: steradian-montecarlo", "NAME", "--plot FILE.svg", "--samples N", "pi-stratified",
                           "sphere-solid-angle", "Exit codes: 0 done; 2 wrong usage"})
    EXPECT_NE(help.output.find(word), std::string::npos) << word << help.output;
  EXPECT_EQ(montecarlo({"--version"}).exitCode, 0);
}

TEST_F(MonteCarlo, AProgrammePrintsWhatItFound) {
  const Outcome outcome = montecarlo({"halfway", "--samples", "65536", "--seed", "3"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.error, "");
  for (const char* part : {"exact 2.0384", "2.016002314977", "1.0 standard errors"})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part << outcome.output;
  EXPECT_EQ(montecarlo({"halfway", "--samples", "65536", "--seed", "3"}).output, outcome.output) << "the same bits";
  EXPECT_TRUE(files().empty());
}

TEST_F(MonteCarlo, AllPrintsEveryProgrammeAsJson) {
  const Outcome outcome = montecarlo({"all", "--samples", "2048", "--json", "--sampler", "sobol"});
  ASSERT_EQ(outcome.exitCode, 0) << outcome.error;
  const auto json = nlohmann::json::parse(outcome.output);
  EXPECT_GE(json.size(), 21u);
  for (const auto& programme : json) {
    for (const auto& result : programme["results"]) EXPECT_TRUE(result["estimate"].is_number()) << programme["name"];
  }
  EXPECT_EQ(json[0]["name"], "pi");
  EXPECT_EQ(json[0]["sampler"], "sobol");
  EXPECT_FALSE(json[0]["results"][0]["book"][0]["outside"]);
}

TEST_F(MonteCarlo, WrongWordsAreNamed) {
  expectComplaints(
      montecarlo({"halfwy"}), 2,
      {R"x(unknown programme "halfwy"; `steradian-montecarlo --help` lists them (did you mean "halfway"?))x"});
  expectComplaints(montecarlo({}), 2, {"the name of a programme is needed"});
  expectComplaints(montecarlo({"pi", "--sampels", "9"}), 2, {R"("--sampels" (did you mean "--samples"?))"});
  expectComplaints(montecarlo({"pi", "--samples", "0", "--sampler", "sobl", "--plot", "a.png"}), 2,
                   {"--samples needs a whole number", R"(unknown sampler "sobl" (did you mean "sobol"?))",
                    R"(--plot needs the name of a file that ends in .svg, not "a.png")"});
  expectComplaints(montecarlo({"x-squared-exact", "--plot", "a.svg"}), 2, {"has no error to plot"});
  expectComplaints(montecarlo({"pi", "--picture", "a.svg"}), 2, {"--picture is for \"directions\""});
  expectComplaints(montecarlo({"all", "--plot", "a.svg", "--picture", "a.svg"}), 2, {"files of their own"});
  EXPECT_TRUE(files().empty());
}

TEST_F(MonteCarlo, PlotsAndPicturesAreFiles) {
  const Outcome outcome = montecarlo({"directions", "--samples", "2048", "--picture", "sphere.svg"});
  EXPECT_EQ(outcome.exitCode, 0) << outcome.error;
  EXPECT_EQ(montecarlo({"pi", "--samples", "2048", "--plot", "pi.svg"}).exitCode, 0);
  EXPECT_EQ(files(), (std::set<std::string>{"pi.svg", "sphere.svg"}));
}

TEST_F(MonteCarlo, WhatCannotBeWrittenLeavesNothingBehind) {
  expectComplaints(montecarlo({"pi", "--plot", "missing/pi.svg"}), 74, {"missing"});
  const Outcome full = launch({.arguments = {"pi", "--samples", "2048", "--plot", "pi.svg"},
                               .fileSizeLimit = 100,
                               .program = STERADIAN_MONTECARLO});
  expectComplaints(full, 74, {"pi.svg"});
  EXPECT_TRUE(files().empty());
  const Outcome noOutput =
      launch({.arguments = {"pi", "--samples", "2048"}, .output = Stream::FullDisk, .program = STERADIAN_MONTECARLO});
  EXPECT_EQ(noOutput.exitCode, 74) << noOutput.error;
}

}  // namespace
}  // namespace steradian::cli
