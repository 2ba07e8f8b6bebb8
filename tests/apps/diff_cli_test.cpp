/// `steradian diff`, `info` and `scenes`.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "steradian/core/base/isa.h"
#include "steradian/tests/apps/cli_test.h"

namespace steradian::cli {
namespace {

using nlohmann::json;

class Diff : public CliTest {
 protected:
  /// A square picture of one colour with that standard error; 0: without.
  void write(const std::string& name, float value, float standardError, int size = 16) const {
    std::vector<std::string> channels{"R", "G", "B"};
    if (standardError > 0.0f) channels.emplace_back("StdErr.Y");
    Image picture(size, size, channels);
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        for (int c = 0; c < picture.channelCount(); ++c) picture.at(x, y, c) = c < 3 ? value : standardError;
    writeImage(picture, path(name));
  }
};

TEST_F(Diff, EqualPictures) {
  write("a.exr", 0.5f, 0.01f);
  const Outcome outcome = run({"diff", "a.exr", "a.exr", "--check", "--json"});
  EXPECT_EQ(outcome.exitCode, 0);
  const json out = json::parse(outcome.output);
  EXPECT_EQ(out["relMSE"], 0.0);
  EXPECT_EQ(out["MSE"], 0.0);
  EXPECT_EQ(out["max"], 0.0);
  EXPECT_EQ(out["mean"][1], 0.5);
  EXPECT_EQ(out["z_test"]["passed"], true);
}

TEST_F(Diff, DifferentPictures) {
  write("a.exr", 0.75f, 0.01f);
  write("b.exr", 0.5f, 0.01f);
  const Outcome outcome = run({"diff", "a.exr", "b.exr", "--check", "--map", "map.exr"});
  EXPECT_EQ(outcome.exitCode, 1);
  EXPECT_NE(outcome.output.find("relMSE        0.240385"), std::string::npos) << outcome.output;  // .0625 / .26
  EXPECT_NE(outcome.output.find("MSE           0.0625"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("mean G        0.75 against 0.5 (+50.000 %)"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("the pictures differ"), std::string::npos) << outcome.output;
  EXPECT_NEAR(image("map.exr").at(3, 3, 0), std::sqrt(0.0625f / 0.26f), 1e-6f);
}

TEST_F(Diff, CorrelatedPixelsAreNotTakenForIndependent) {
  write("exact.exr", 0.5f, 0.0f);
  write("alone.exr", 0.51f, 0.01f);
  Image shared = image("alone.exr");
  shared.metadata()["steradian.correlatedPixels"] = std::string("256");
  writeImage(shared, path("shared.exr"));
  EXPECT_EQ(run({"diff", "alone.exr", "exact.exr", "--check"}).exitCode, 1);
  EXPECT_EQ(run({"diff", "shared.exr", "exact.exr", "--check"}).exitCode, 0);
}

TEST_F(Diff, TheColoursOfARenderAreNoStandardErrors) {
  write("a.exr", 0.75f, 0.01f);
  write("b.exr", 0.5f, 0.01f);
  const json out = json::parse(run({"diff", "a.exr", "b.exr", "--reference-error", "a.exr", "--json"}).output);
  EXPECT_NEAR(out["relMSE"], 0.0625 / 0.26, 1e-6);
}

TEST_F(Diff, WithoutStandardErrors) {
  write("a.exr", 0.75f, 0.0f);
  const Outcome outcome = run({"diff", "a.exr", "a.exr", "--map", "map.png"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_NE(outcome.output.find("no standard errors"), std::string::npos);
  EXPECT_EQ(image("map.png").width(), 16);
  EXPECT_EQ(run({"diff", "a.exr", "a.exr", "--check"}).exitCode, 2);
}

TEST_F(Diff, WhatCannotBeCompared) {
  write("a.exr", 0.5f, 0.0f);
  write("small.exr", 0.5f, 0.0f, 8);
  std::ofstream(path("text.exr")) << "no picture\n";
  expectComplaints(run({"diff", "a.exr", "small.exr"}), 2, {"images of different size cannot be compared"});
  expectComplaints(run({"diff", "a.exr", "none.exr"}), 65, {"none.exr: error: cannot read the image"});
  expectComplaints(run({"diff", "a.exr", "text.exr"}), 65, {"text.exr: error: cannot read the image"});
  expectComplaints(run({"diff", "a.exr", "a.exr", "--map", "none/map.png"}), 74, {"cannot write \"none/map.png\""});
  expectComplaints(run({"diff", "a.exr", "a.exr", "--map", "map.txt"}), 2, {"unknown extension \"txt\""});
}

using Info = CliTest;

TEST_F(Info, CountsInstances) {
  EXPECT_NE(run({"info", "cornell-city:100"}).output.find("traced by bvh8"), std::string::npos);
  const Outcome outcome = run({"info", "cornell-tower:9"});
  EXPECT_EQ(outcome.exitCode, 0);
  for (const char* part : {"box 18, quad 54", "9 emitting primitives", "9 instances", "600x600"})
    EXPECT_NE(outcome.output.find(part), std::string::npos) << part << "\n" << outcome.output;
}

TEST_F(Info, AsJson) {
  const Outcome outcome = run({"info", "cornell-city:100", "--json"});
  EXPECT_EQ(outcome.exitCode, 0);
  const json scene = json::parse(outcome.output);
  EXPECT_EQ(scene["counts"]["box"], 100);
  EXPECT_EQ(scene["camera"]["lookFrom"], json({278, 278, -800}));
}

TEST_F(Info, OfTheBuild) {
  const Outcome outcome = run({"info", "--build", "--json"});
  EXPECT_EQ(outcome.exitCode, 0);
  const json build = json::parse(outcome.output);
  EXPECT_EQ(build["isa"], std::string(nameOf(bestIsa())));
  EXPECT_EQ(build["isas"].size(), compiledIsas().size());
  for (const char* library : {"Embree", "OpenImageIO", "OpenColorIO", "oneTBB"}) {
    EXPECT_GE(std::stoi(build["libraries"][library].get<std::string>()), 2) << library;
    EXPECT_NE(run({"info", "--build"}).output.find(library), std::string::npos);
  }
  expectComplaints(run({"info", "--build", "quads"}), 2, {"either a scene or --build"});
  expectComplaints(run({"info"}), 2, {"either a scene or --build"});
}

TEST_F(Info, ScenesAreListed) {
  const Outcome outcome = run({"scenes", "--json"});
  EXPECT_EQ(outcome.exitCode, 0);
  const json list = json::parse(outcome.output);
  EXPECT_GE(list.size(), 10u);
  EXPECT_TRUE(std::any_of(list.begin(), list.end(), [](const json& scene) { return scene["name"] == "cornell-box"; }));
  EXPECT_NE(run({"scenes"}).output.find("cornell-city:N"), std::string::npos);
}

}  // namespace
}  // namespace steradian::cli
