#include "steradian/apps/steradian/render_options.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "steradian/tests/support/temporary_folder.h"

namespace steradian::app {
namespace {

using Words = std::vector<std::string>;

RenderOptions parse(Words words, const std::string& scene = "cornell-box") {
  CLI::App command;
  RenderTexts texts;
  declareRenderOptions(command, texts);
  words.insert(words.begin(), scene);
  std::reverse(words.begin(), words.end());  // the order that CLI11 expects
  command.parse(words);
  Arguments arguments;
  return checkRenderOptions(texts, arguments);
}

/// The only complaint about these words, or an explanation of why there is not one.
std::string complaint(const Words& words, const std::string& scene = "cornell-box") {
  try {
    parse(words, scene);
    return "nothing was wrong";
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::Usage) return "not about usage";
    if (error.diagnostics().size() != 1) return std::string("several: ") + error.what();
    return error.what();
  }
}

testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << '"' << text << "\" does not contain \"" << part << '"';
}

TEST(RenderOptions, Defaults) {
  const RenderOptions options = parse({});
  EXPECT_EQ(options.scene.name, "cornell-box");
  EXPECT_EQ(options.integrator, "path");
  EXPECT_FALSE(options.settings.width || options.settings.samplesPerPixel || options.settings.timeLimit);
  EXPECT_FALSE(options.settings.crop);
  EXPECT_EQ(options.threads, 0);
  EXPECT_EQ(options.statistics, StatisticsFormat::None);
  EXPECT_FALSE(options.display) << "no picture is to be seen";
}

class Pictures : public test::TemporaryFolder {
 protected:
  std::string picture(const std::string& name) {
    Image image(4, 2, {"R", "G", "B"});
    image.at(1, 0, 0) = 0.5f;
    writeImage(image, folder_ / name);
    return (folder_ / name).string();
  }
};

TEST_F(Pictures, ReplaceImageTextures) {
  const std::string file = picture("map.exr");
  const RenderOptions options = parse({"--texture", file}, "earth");
  const auto& texture = std::get<ImageTexture>(options.scene.textures.at(0));
  EXPECT_EQ(texture.name, file);
  EXPECT_EQ(texture.image->at(1, 0, 0), 0.5f);
  EXPECT_TRUE(contains(options.replay, "--texture '" + file + "'"));
  EXPECT_TRUE(contains(complaint({"--texture", file}, "cornell-box"), "no image texture"));
}

TEST_F(Pictures, ReplaceSkies) {
  const std::string file = picture("sky.exr"), odd = picture("a:b.exr");
  const auto sky = [](const std::string& text) {
    const RenderOptions options = parse({"--sky", text}, "quads");
    EXPECT_EQ(options.scene.lights.size(), 1u);
    return std::get<ImageSky>(options.scene.lights.at(0).model);
  };
  EXPECT_EQ(sky(file).name, file);
  EXPECT_EQ(sky(file).rotation, 0.0f);
  EXPECT_EQ(sky(file + ":-30.5").name, file);
  EXPECT_EQ(sky(file + ":-30.5").rotation, -30.5f);
  EXPECT_EQ(sky(odd).name, odd);
  EXPECT_EQ(sky(odd + ":90").rotation, 90.0f);
  EXPECT_EQ(parse({"--sky", file}, "cornell-box").scene.lights.size(), 1u);
}

TEST_F(Pictures, ThatCannotBeReadAreBadAssets) {
  for (const char* option : {"--texture", "--sky"}) {
    try {
      parse({option, (folder_ / "missing.png").string()}, "earth");
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::Scene);
      EXPECT_TRUE(contains(error.what(), "missing.png"));
    }
  }
}

TEST(RenderOptions, Values) {
  const RenderOptions options = parse({"--size",       "40x30",
                                       "--spp",        "7",
                                       "--time",       "1.5m",
                                       "--seed",       "9",
                                       "-t",           "3",
                                       "--crop",       "1,40,2,30",
                                       "--sampler",    "stratified",
                                       "--filter",     "gaussian:1.25",
                                       "--replicates", "4",
                                       "--tile",       "8",
                                       "--strategy",   "mixture",
                                       "--max-depth",  "0",
                                       "--target",     "light,short box",
                                       "--view",       "Book",
                                       "--exposure",   "-1.5",
                                       "-o",           "a.PNG",
                                       "-o",           "b.exr",
                                       "--stats"});
  const RenderSettings& s = options.settings;
  EXPECT_EQ(s.width, 40);
  EXPECT_EQ(s.height, 30);
  EXPECT_EQ(s.samplesPerPixel, 7u);
  EXPECT_EQ(s.timeLimit, 90.0);
  EXPECT_EQ(s.seed, 9u);
  EXPECT_EQ(s.crop, (Crop{1, 40, 2, 30}));
  EXPECT_EQ(s.sampler, SamplerType::Stratified);
  EXPECT_EQ(s.replicates, 4u);
  EXPECT_EQ(s.tileSize, 8);
  EXPECT_EQ(options.threads, 3);
  EXPECT_EQ(options.integrator, "path:strategy=mixture:max-depth=0:targets=light,short box");
  EXPECT_EQ(options.view.view, "Book");
  EXPECT_EQ(options.view.exposure, -1.5f);
  EXPECT_TRUE(options.display);
  ASSERT_EQ(options.outputs.size(), 2u);
  EXPECT_EQ(options.outputs[0].format, ImageFormat::Png);
  EXPECT_EQ(options.outputs[1].format, ImageFormat::Exr);
  EXPECT_EQ(options.statistics, StatisticsFormat::Text);
}

TEST(RenderOptions, Structures) {
  EXPECT_EQ(parse({}).accel, Accel::Auto);
  EXPECT_EQ(parse({"--accel", "embree"}).accel, Accel::Embree);
  EXPECT_TRUE(
      contains(complaint({"--accel", "flap"}), R"(unknown acceleration structure "flap" (did you mean "flat"?))"));
}

TEST(RenderOptions, InstructionSets) {
  EXPECT_EQ(parse({}).settings.execution.isa, bestIsa());
  EXPECT_EQ(parse({"--isa", "baseline"}).settings.execution.isa, Isa::Baseline);
  EXPECT_TRUE(contains(complaint({"--isa", "axv2"}), R"(unknown instruction set "axv2" (did you mean "avx2"?))"));
  for (const Isa isa : {Isa::Avx2, Isa::Avx512}) {
    if (isUsable(isa)) {
      EXPECT_EQ(parse({"--isa", std::string(nameOf(isa))}).settings.execution.isa, isa);
    } else {
      EXPECT_TRUE(contains(complaint({"--isa", std::string(nameOf(isa))}), "has no " + std::string(nameOf(isa))));
    }
  }
}

TEST(RenderOptions, ACropIsCheckedAgainstTheScenesSizeIfNoOtherIsGiven) {
  EXPECT_TRUE(parse({"--crop", "599,600,0,600"}).settings.crop);
  EXPECT_TRUE(contains(complaint({"--crop", "0,601,0,600"}), "x1 <= 600"));
}

TEST(RenderOptions, EverySamplerHasAName) {
  for (const SamplerType type : kSamplerTypes)
    EXPECT_EQ(parse({"--sampler", std::string(nameOf(type))}).settings.sampler, type);
}

TEST(RenderOptions, FilesWithoutAnExtensionTakeTheFormat) {
  const RenderOptions options = parse({"-o", "-", "-o", "/dev/null", "-o", "pipe", "-o", "a.jpg", "--format", "ppm"});
  ASSERT_EQ(options.outputs.size(), 4u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(options.outputs[i].format, ImageFormat::Ppm);
  EXPECT_EQ(options.outputs[3].format, ImageFormat::Jpeg);
}

TEST(RenderOptions, NumbersThatMakeNoSense) {
  const std::vector<std::pair<const char*, std::vector<const char*>>> mistakes{
      {"--size", {"0x0", "", "x", "-4x4", "1e9x1", "65537x1", "65536x65536", "0x10", "nanxnan", "4 x 4", "40"}},
      {"--spp", {"0", "-1", "1.5", "1e9", "4294967297", "", "0x10", "nan"}},
      {"--time", {"0", "-1s", "inf", "nan", "1d", "", "s", "1e300h", "1 s"}},
      {"--seed", {"-1", "4294967296", "x"}},
      {"--threads", {"0", "-2", "100000", "all"}},
      {"--crop", {"0,0,0,0", "5,4,0,9", "-1,9,0,9", "0,9,0,601", "", "0,9,0", "0,9,0,9,", "a,b,c,d"}},
      {"--exposure", {"nan", "inf", "1e9", "", "1f"}},
      {"--replicates", {"0", "257", "-1"}},
      {"--tile", {"0", "1000000"}},
      {"--max-depth", {"-1", "1e9", "", "nan"}},
  };
  for (const auto& [option, texts] : mistakes)
    for (const char* text : texts) {
      const std::string name = std::string(option) == "--max-depth" ? "max-depth" : option;
      EXPECT_TRUE(contains(complaint({option, text}), "error: " + name)) << option << " " << text;
      EXPECT_TRUE(contains(complaint({option, text}), '"' + std::string(text) + '"')) << option << " " << text;
    }
  for (const char* filter : {"gaussian:nan", "box:0", "box:", "box:1e9", "triangle:-1", "box:1:2"})
    EXPECT_TRUE(contains(complaint({"--filter", filter}), "--filter's radius")) << filter;
}

TEST(RenderOptions, UnknownNames) {
  const std::vector<std::pair<Words, const char*>> mistakes{
      {{"-o", "a.gif"}, R"(unknown extension "gif")"},
      {{"-o", "picture"}, "has no extension"},
      {{"-o", ""}, "has no extension"},
      {{"-o", "-"}, "needs --format"},
      {{"-o", "/dev/null"}, "needs --format"},
      {{"--format", "png", "-o", "a.png"}, "--format is for"},
      {{"-o", "-", "--format", "pgn"}, R"(unknown format "pgn" (did you mean "png"?))"},
      {{"-o", "-", "-o", "-", "--format", "png"}, "-o - is given twice"},
      {{"-o", "-", "--format", "png", "--stats=json"}, "cannot both go to standard output"},
      {{"--stats=jsn"}, R"(unknown format "jsn" (did you mean "json"?))"},
      {{"--sampler", "sobl"}, R"(unknown sampler "sobl" (did you mean "sobol"?))"},
      {{"--sampler", "blue-nose"}, R"(unknown sampler "blue-nose" (did you mean "blue-noise"?))"},
      {{"--sampler", "pmj2"}, R"(unknown sampler "pmj2" (did you mean "pmj02"?))"},
      {{"--sampler", ""}, R"(unknown sampler "")"},
      {{"--filter", "gaus"}, R"(unknown filter "gaus" (did you mean "gaussian"?))"},
      {{"--view", "aces sdr"}, R"(unknown view "aces sdr")"},
      {{"--view", "aces sdr"}, R"((did you mean "ACES SDR"?))"},
      {{"--display", "tv", "-o", "a.png"}, R"(unknown display "tv")"},
      {{"--strategy", "miss"}, R"(not "miss" (did you mean "mis"?))"},
      {{"--width", "5"}, "the width must be 1, 4, 8 or 16"},
      {{"--width", "17"}, "width"},
      {{"--reuse", "6"}, "reuse must be 1, 2, 4, 8, 16 or 32"},
      {{"--reuse", "8", "--width", "1"}, "reuse needs width"},
      {{"--strategy", ""}, R"(not "")"},
      {{"--integrator", "pth"}, R"(did you mean "path"?)"},
      {{"--integrator", "path:light-sample=4"}, R"(did you mean "light-samples"?)"},
      {{"--integrator", "path:strategy"}, "key=value"},
      {{"--integrator", "path:strategy=mis", "--strategy", "mis"}, "given twice"},
      {{"--integrator", "normals", "--max-depth", "2"}, R"(no key "max-depth")"},
  };
  for (const auto& [words, part] : mistakes) EXPECT_TRUE(contains(complaint(words), part));
}

TEST(RenderOptions, UnknownScenes) {
  EXPECT_TRUE(contains(complaint({}, "cornell-bx"), R"((did you mean "cornell-box"?))"));
  EXPECT_TRUE(contains(complaint({}, ""), R"(unknown scene "")"));
  EXPECT_TRUE(contains(complaint({}, "cornell-city"), "needs a whole number N"));
  for (const char* count : {"", "0", "-1", "1e9", "4294967297", "1.5", "x"})
    EXPECT_TRUE(contains(complaint({}, std::string("cornell-city:") + count), "needs a whole number N")) << count;
  EXPECT_TRUE(contains(complaint({}, "cornell-box:3"), "takes no count"));
}

TEST(RenderOptions, AllComplaintsTogether) {
  try {
    parse({"--spp", "0", "--filter", "gaus:99", "--integrator", "path:a=1:light-samples=0", "-o", "x", "--view", "y"},
          "z");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.diagnostics().size(), 8u) << error.what();
  }
}

TEST(RenderOptions, TheReplayRepeatsWhatChoosesSamples) {
  EXPECT_EQ(parse({"--spp", "4", "--seed", "7", "--filter", "box:1", "--strategy", "light"}).replay,
            "--integrator 'path:strategy=light' --seed '7' --filter 'box:1'");
}

}  // namespace
}  // namespace steradian::app
