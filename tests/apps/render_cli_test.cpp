/// What `steradian render` writes, and where to.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "steradian/accel/accel.h"
#include "steradian/core/base/isa.h"
#include "steradian/tests/apps/cli_test.h"

namespace steradian::cli {
namespace {

namespace fs = std::filesystem;

using Render = CliTest;

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The pixels without what differs between runs, such as the time they took.
std::vector<float> pixelsOf(const Image& image) { return {image.values().begin(), image.values().end()}; }

TEST_F(Render, EveryFormatAtOnce) {
  ASSERT_EQ(render({"-o", "a.exr", "-o", "a.png", "-o", "a.jpg", "-o", "a.tif", "-o", "a.hdr", "-o", "a.ppm"}).exitCode,
            0);
  for (const char* name : {"a.exr", "a.png", "a.jpg", "a.tif", "a.hdr", "a.ppm"}) {
    EXPECT_EQ(image(name).width(), 20) << name;
    EXPECT_EQ(image(name).height(), 15) << name;
  }
  EXPECT_EQ(contentOf(path("a.png")).substr(1, 3), "PNG");
  EXPECT_EQ(contentOf(path("a.hdr")).substr(0, 10), "#?RADIANCE");
  EXPECT_EQ(files().size(), 6u) << "nothing else is left";
}

TEST_F(Render, AnExrSaysWhereItComesFrom) {
  ASSERT_EQ(render({"--seed", "7", "-o", "a.exr"}).exitCode, 0);
  const Image picture = image("a.exr");
  for (const char* channel : {"R", "G", "B", "A", "Albedo.R", "N.X", "Z", "StdErr.Y", "Samples"})
    EXPECT_TRUE(picture.findChannel(channel)) << channel;
  for (const char* name : {"worldToCamera", "worldToNDC", "chromaticities", "renderTime", "steradian.scene",
                           "steradian.sceneHash", "steradian.seed", "steradian.ledger"})
    EXPECT_TRUE(picture.metadata().contains(name)) << name;
  const auto* seed = findMetadata<std::string>(picture.metadata(), "steradian.seed");
  ASSERT_NE(seed, nullptr);
  EXPECT_EQ(*seed, "7");
}

TEST_F(Render, ThreadsTilesInstructionSetsAndStructuresDoNotChangeABit) {
  std::vector<std::vector<std::string>> ways{
      {"-t", "1"}, {"-t", "2"}, {"-t", "3", "--tile", "5"}, {"-t", "8", "--tile", "64"}};
  for (const Isa isa : compiledIsas()) {
    if (isUsable(isa)) ways.push_back({"--isa", std::string(nameOf(isa))});
  }
  for (const std::string_view accel : kAccelNames) ways.push_back({"--accel", std::string(accel)});
  std::vector<float> first;
  for (std::vector<std::string> way : ways) {
    way.insert(way.end(), {"-o", "a.exr"});
    ASSERT_EQ(render(way).exitCode, 0);
    if (first.empty()) first = pixelsOf(image("a.exr"));
    EXPECT_EQ(pixelsOf(image("a.exr")), first) << way[0] << " " << way[1];
  }
  ASSERT_EQ(render({"--seed", "1", "-o", "a.exr"}).exitCode, 0);
  EXPECT_NE(pixelsOf(image("a.exr")), first) << "the test must be able to fail";
}

TEST_F(Render, StructuresDoNotChangeABitOfLargerScenes) {
  for (const char* scene : {"cornell-city:300", "next-week-final"}) {
    ASSERT_EQ(render({"--accel", "bvh8", "-o", "own.exr"}, scene).exitCode, 0);
    const Outcome outcome = render({"--accel", "embree", "--stats=json", "-o", "embree.exr"}, scene);
    ASSERT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(pixelsOf(image("own.exr")), pixelsOf(image("embree.exr"))) << scene;
    const nlohmann::json stats = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(stats["accel"], "embree");
    EXPECT_GT(stats["embree"]["rays"], 20 * 15 * 2);
    EXPECT_GT(stats["embree"]["callbacks"], stats["embree"]["rays"]);
  }
}

TEST_F(Render, StructuresThatASceneCannotHaveAreRefusedByName) {
  expectComplaints(render({"--accel", "flat", "-o", "a.exr"}, "cornell-city:300"), 2,
                   {"accel flat is not for more than 64 primitives"});
  expectComplaints(render({"--accel", "flat", "-o", "a.exr"}, "cornell-tower:4"), 2,
                   {"accel flat is not for instances"});
  expectComplaints(render({"--accel", "bvh", "-o", "a.exr"}), 2,
                   {"unknown acceleration structure \"bvh\" (did you mean \"bvh8\"?)"});
  EXPECT_TRUE(files().empty());
}

TEST_F(Render, ACropIsTheSamePartOfTheFullPicture) {
  ASSERT_EQ(render({"-o", "full.exr"}).exitCode, 0);
  ASSERT_EQ(render({"--crop", "3,17,5,12", "-o", "crop.exr"}).exitCode, 0);
  const Image full = image("full.exr"), crop = image("crop.exr");
  EXPECT_EQ(crop.window(), (ImageWindow{3, 5, 20, 15}));
  ASSERT_EQ(crop.channels(), full.channels());
  for (int y = 0; y < crop.height(); ++y)
    for (int x = 0; x < crop.width(); ++x)
      EXPECT_TRUE(std::ranges::equal(crop.pixel(x, y), full.pixel(x + 3, y + 5))) << x << ' ' << y;
}

TEST_F(Render, StandardOutputGetsTheSameBytes) {
  const Outcome outcome = render({"-o", "-", "-o", "a.ppm", "--format", "ppm"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_EQ(outcome.output, contentOf(path("a.ppm")));
  EXPECT_EQ(outcome.output.substr(0, 2), "P6");
}

TEST_F(Render, ReplacesWhatALinkPointsTo) {
  fs::create_directory(path("elsewhere"));
  fs::create_symlink("elsewhere/target.png", path("link.png"));
  ASSERT_EQ(render({"-o", "link.png"}).exitCode, 0);
  EXPECT_TRUE(fs::is_symlink(path("link.png")));
  EXPECT_EQ(image("elsewhere/target.png").width(), 20);
}

TEST_F(Render, WritesIntoPipesAndDevices) {
  ASSERT_EQ(::mkfifo(path("pipe.png").c_str(), 0600), 0);
  const int reader = ::open(path("pipe.png").c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  EXPECT_EQ(render({"-o", "pipe.png", "-o", "/dev/null", "--format", "png"}).exitCode, 0);
  std::string start(4, '\0');
  EXPECT_EQ(::read(reader, start.data(), start.size()), 4);
  ::close(reader);
  EXPECT_EQ(start.substr(1), "PNG");
  EXPECT_EQ(files(), std::set<std::string>{"pipe.png"});
}

TEST_F(Render, TargetsThatCannotBeWritten) {
  fs::create_directory(path("folder.png"));
  expectComplaints(
      render({"-o", "missing/a.png", "-o", "folder.png", "-o", "good.png"}), 74,
      {"cannot write \"missing/a.png\": No such file or directory", "cannot write \"folder.png\": Is a directory"});
  EXPECT_EQ(files(), std::set<std::string>{"folder.png"}) << "it fails before it renders";
  expectComplaints(render({"-o", "/dev/full", "--format", "png", "-o", "good.png"}), 74,
                   {"cannot write \"/dev/full\": No space left on device"});
  EXPECT_EQ(image("good.png").width(), 20) << "the others are saved";
}

TEST_F(Render, NothingIsLeftBehindOnAFullDisk) {
  const Launch what{.arguments = renderArguments({"-o", "a.exr", "-o", "a.png"}), .fileSizeLimit = 512};
  expectComplaints(launch(what), 74,
                   {"cannot write \"a.exr\": File too large", "cannot write \"a.png\": File too large"});
  EXPECT_TRUE(files().empty());
}

TEST_F(Render, BrokenStandardOutput) {
  const auto error = [&](Stream output) {
    const Outcome outcome = launch({.arguments = renderArguments({"-o", "-", "--format", "png"}), .output = output});
    EXPECT_EQ(outcome.exitCode, 74);
    return outcome.error;
  };
  EXPECT_NE(error(Stream::FullDisk).find("No space left on device"), std::string::npos);
  EXPECT_NE(error(Stream::BrokenPipe).find("Broken pipe"), std::string::npos);
  EXPECT_NE(error(Stream::Closed).find("Bad file descriptor"), std::string::npos);
  EXPECT_EQ(launch({.arguments = {"scenes"}, .output = Stream::FullDisk}).exitCode, 74);
}

TEST_F(Render, ABrokenLogDoesNotCostThePicture) {
  for (const Stream log : {Stream::FullDisk, Stream::BrokenPipe, Stream::Closed}) {
    Launch what{.arguments = renderArguments({"-v", "--stats", "-o", "a.png"}), .output = log, .error = log};
    std::erase(what.arguments, "-q");
    EXPECT_EQ(launch(what).exitCode, 0);
    EXPECT_EQ(image("a.png").width(), 20);
    fs::remove(path("a.png"));
  }
}

TEST_F(Render, StatisticsAreJsonBesideTheProgress) {
  const Outcome outcome =
      run({"render", "cornell-box", "--size", "20x15", "--spp", "2", "--stats=json", "-o", "a.png"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_NE(outcome.error.find("100% 0:0"), std::string::npos) << outcome.error;
  const nlohmann::json stats = nlohmann::json::parse(outcome.output);
  for (const char* key : {"render_seconds", "seconds", "samples", "rays", "path_lengths", "primitives", "bytes",
                          "accel", "embree", "non_finite_samples", "width", "height", "threads", "seed", "stopped"})
    EXPECT_TRUE(stats.contains(key)) << key;
  EXPECT_EQ(stats["samples"], 20 * 15 * 2);
  EXPECT_EQ(stats["rays"]["camera"], 20 * 15 * 2);
  std::uint64_t paths = 0;
  for (const nlohmann::json& count : stats["path_lengths"]) paths += count.get<std::uint64_t>();
  EXPECT_EQ(paths, 20u * 15u * 2u) << "every path has a length";
}

TEST_F(Render, AFilmThatNoMachineCanHold) {
  expectComplaints(render({"--size", "65536x4096", "--replicates", "256", "-o", "a.exr"}), 71,
                   {"a picture of 65536 x 4096 pixels needs"});
  EXPECT_TRUE(files().empty());
}

TEST_F(Render, EndsByTime) {
  const Outcome outcome = run({"render", "quads", "--size", "16x16", "--time", "0.1s", "-q", "--stats=json"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_GE(nlohmann::json::parse(outcome.output)["passes"], 1);
}

TEST_F(Render, PicturesOfTheUsers) {
  ASSERT_EQ(render({"-o", "map.png"}).exitCode, 0);
  EXPECT_EQ(render({"-o", "earth.png", "--texture", "map.png", "--sky", "map.png:45"}, "earth").exitCode, 0);
  expectComplaints(render({"--texture", "map.png"}), 2, {"no image texture"});
  expectComplaints(render({"--texture", "missing.png"}, "earth"), 65, {"missing.png"});
}

TEST_F(Render, SaysThatNothingWasSaved) {
  const Outcome outcome = run({"render", "quads", "--size", "8x8", "--spp", "1"});
  EXPECT_EQ(outcome.exitCode, 0);
  EXPECT_NE(outcome.error.find("nothing was saved"), std::string::npos);
}

}  // namespace
}  // namespace steradian::cli
