#include "steradian/integrators/make_integrator.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "steradian/integrators/path/path.h"

namespace steradian {
namespace {

PathSettings pathSettings(std::string_view spec) {
  const IntegratorChoice choice = makeIntegrator(spec);
  const auto* path = dynamic_cast<const PathIntegrator*>(choice.integrator.get());
  if (path == nullptr) throw Error(ErrorKind::Other, "not a path integrator");
  return path->settings();
}

std::vector<Diagnostic> mistakesIn(std::string_view spec) {
  try {
    makeIntegrator(spec);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    return {error.diagnostics().begin(), error.diagnostics().end()};
  }
  return {};
}

TEST(MakeIntegrator, DefaultsAreThoseOfTheSettings) {
  const PathSettings given = pathSettings("path"), expected;
  EXPECT_EQ(given.strategy, expected.strategy);
  EXPECT_EQ(given.lightSamples, expected.lightSamples);
  EXPECT_EQ(given.maxDepth, std::nullopt);
  EXPECT_EQ(given.rouletteStart, 4u);
  EXPECT_EQ(given.rouletteStrength, expected.rouletteStrength);
}

TEST(MakeIntegrator, TheRegistryNamesTheDefaults) {
  std::string spec = "path:strategy=mixture";
  for (const IntegratorKey& key : integratorRegistry().front().keys) {
    const bool ofTheScene = key.defaultValue == "the scene's";
    if (!ofTheScene && key.name != "strategy") spec += fmt::format(":{}={}", key.name, key.defaultValue);
  }
  const PathSettings named = pathSettings(spec), expected;
  EXPECT_EQ(named.lightSamples, expected.lightSamples);
  EXPECT_EQ(named.scatterPdf, expected.scatterPdf);
  EXPECT_EQ(named.rouletteStart, expected.rouletteStart);
  EXPECT_EQ(named.rouletteStrength, expected.rouletteStrength);
  EXPECT_EQ(named.targetWeight, 0.5f);
  EXPECT_EQ(expected.targetWeight, std::nullopt);
  EXPECT_EQ(makeIntegrator(spec).execution.width, ExecutionSettings{}.width);
}

TEST(MakeIntegrator, ReadsEveryKeyOfPath) {
  const PathSettings s = pathSettings(
      "path:strategy=mixture:max-depth=0:light-samples=4:scatter-pdf=hemisphere:roulette-start=3:roulette-strength=0.5:"
      "target-weight=0.25:targets=lamp,glass ball");
  EXPECT_EQ(s.strategy, Strategy::Mixture);
  EXPECT_EQ(s.maxDepth, 0u);
  EXPECT_EQ(s.lightSamples, 4u);
  EXPECT_EQ(s.scatterPdf, ScatterPdf::Hemisphere);
  EXPECT_EQ(s.rouletteStart, 3u);
  EXPECT_EQ(s.rouletteStrength, 0.5f);
  EXPECT_EQ(s.targetWeight, 0.25f);
  EXPECT_EQ(s.targets, (std::vector<std::string>{"lamp", "glass ball"}));
}

TEST(MakeIntegrator, EveryNameOfTheRegistryCanBeMade) {
  for (const IntegratorInfo& info : integratorRegistry()) {
    EXPECT_NE(makeIntegrator(info.name).integrator, nullptr) << info.name;
    EXPECT_FALSE(info.help.empty());
  }
}

TEST(MakeIntegrator, TheRegistryNamesExactlyTheKeysThatAreRead) {
  // A value that no key accepts is reported as such, unless nothing reads the key.
  for (const IntegratorInfo& info : integratorRegistry()) {
    for (const IntegratorKey& key : info.keys) {
      const std::string spec = std::string(info.name) + ":" + std::string(key.name) + "=,";
      const std::vector<Diagnostic> mistakes = mistakesIn(spec);
      ASSERT_EQ(mistakes.size(), 1u) << spec;
      EXPECT_NE(mistakes[0].message.find(" must be "), std::string::npos) << mistakes[0].message;
    }
  }
}

TEST(MakeIntegrator, ReportsAllMistakesAtOnceWithSuggestions) {
  const auto mistakes =
      mistakesIn("path:stratgy=mis:max-depth=-1:scatter-pdf=cosin:oops:light-samples=2:light-samples=3");
  ASSERT_EQ(mistakes.size(), 5u);
  const auto mention = [&](std::string_view text, std::string_view suggestion) {
    for (const Diagnostic& d : mistakes) {
      if (d.message.find(text) != std::string::npos && d.suggestion == suggestion) return true;
    }
    return false;
  };
  EXPECT_TRUE(mention("\"stratgy\"", "strategy"));
  EXPECT_TRUE(mention("max-depth must be a whole number", ""));
  EXPECT_TRUE(mention("scatter-pdf must be", "cosine"));
  EXPECT_TRUE(mention("\"oops\"", ""));
  EXPECT_TRUE(mention("\"light-samples\" is given twice", ""));
}

TEST(MakeIntegrator, SuggestsANameForAnUnknownOne) {
  const auto mistakes = mistakesIn("pth:strategy=mis");
  ASSERT_EQ(mistakes.size(), 1u);
  EXPECT_EQ(mistakes[0].suggestion, "path");
}

TEST(MakeIntegrator, RefusesNumbersThatMakeNoSense) {
  for (const char* bad :
       {"path:light-samples=0", "path:light-samples=2000", "path:max-depth=1e3",
        "path:max-depth=", "path:strategy=mixture:target-weight=nan", "path:strategy=mixture:target-weight=1.01",
        "path:roulette-strength=-0.1", "ambient-occlusion:distance=0", "ambient-occlusion:distance=nan",
        "normals:distance=1", "path:strategy=mixture:targets=a,,b", "path:=3", ""}) {
    EXPECT_EQ(mistakesIn(bad).size(), 1u) << bad;
  }
}

TEST(MakeIntegrator, TheWidthOfASpecIsThatOfTheExecution) {
  EXPECT_EQ(makeIntegrator("path:width=8").execution.width, 8u);
  EXPECT_EQ(makeIntegrator("path:width=0", {.width = 4}).execution.width, 0u);
  for (const char* spec : {"path", "normals"}) {
    const ExecutionSettings kept = makeIntegrator(spec, {.isa = Isa::Baseline, .width = 4}).execution;
    EXPECT_EQ(kept.isa, Isa::Baseline);
    EXPECT_EQ(kept.width, 4u);
  }
}

TEST(MakeIntegrator, RefusesExecutionThatIsNotPossible) {
  EXPECT_EQ(mistakesIn("path:width=5").size(), 1u);
  EXPECT_EQ(mistakesIn("normals:width=4").size(), 1u);
  EXPECT_THROW(makeIntegrator("normals", {.width = 5}), Error);
  EXPECT_THROW(makeIntegrator("path:reuse=2", {.width = 1}), Error);
  EXPECT_NO_THROW(makeIntegrator("path:reuse=2:width=4", {.width = 1}));
}

TEST(MakeIntegrator, RefusesTargetsWhereNothingAimsAtThem) {
  EXPECT_EQ(mistakesIn("path:targets=lights:target-weight=0.5").size(), 0u);
  EXPECT_EQ(mistakesIn("path:strategy=bsdf:targets=lights:target-weight=0.5").size(), 2u);
  EXPECT_EQ(mistakesIn("path:strategy=light:targets=lights").size(), 1u);
}

}  // namespace
}  // namespace steradian
