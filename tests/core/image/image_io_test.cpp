#include "steradian/core/image/image_io.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <limits>

#include "steradian/core/base/diagnostics.h"
#include "steradian/tests/support/temporary_folder.h"

namespace steradian {
namespace {

namespace fs = std::filesystem;

class ImageIo : public test::TemporaryFolder {};

/// Values that no two pixels or channels share, some beyond [0, 1].
void fill(Image& image) {
  float value = -0.25f;
  for (float& v : image.values()) v = value += 0.03125f;
}

Image ramp(int width, int height) {
  Image image(width, height, {"R", "G", "B"});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.at(x, y, 0) = static_cast<float>(x) / static_cast<float>(width - 1);
      image.at(x, y, 1) = static_cast<float>(y) / static_cast<float>(height - 1);
      image.at(x, y, 2) = 0.25f;
    }
  }
  return image;
}

ErrorKind kindOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_FALSE(std::string(error.what()).empty());
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorKind::Other;
}

std::vector<std::byte> bytesOf(std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

TEST_F(ImageIo, ExrKeepsChannelsWindowAndMetadata) {
  const std::vector<std::string> channels{"Z",        "R",   "G",   "B",   "A",        "Albedo.R", "Albedo.G",
                                          "Albedo.B", "N.X", "N.Y", "N.Z", "StdErr.Y", "samples"};
  Image image(7, 5, channels, ImageWindow{3, 2, 40, 30});
  fill(image);
  image.at(1, 1, image.channel("R")) = 1e30f;
  image.at(2, 1, image.channel("Z")) = std::numeric_limits<float>::infinity();
  std::vector<float> matrix(16);
  for (std::size_t i = 0; i < 16; ++i) matrix[i] = static_cast<float>(i) * 0.5f;
  const Metadata metadata{{"worldToCamera", matrix},
                          {"worldToNDC", matrix},
                          {"steradian:seed", 42},
                          {"steradian:sceneHash", std::string("0123abc\n{\"a\": 1}")},
                          {"steradian:time", 1.25f},
                          {"steradian:seconds", 1.0 / 3.0},
                          {"steradian:offset", std::vector<float>{1, 2}},
                          {"steradian:eye", std::vector<float>{1, 2, 3}},
                          {"steradian:weights", std::vector<float>{1, 2, 3, 4, 5}}};
  image.metadata() = metadata;
  writeImage(image, folder_ / "a.exr");
  const Image read = readImage(folder_ / "a.exr");

  EXPECT_EQ(filesInFolder(), 1u);
  EXPECT_EQ(read.width(), 7);
  EXPECT_EQ(read.height(), 5);
  EXPECT_EQ(read.window(), image.window());
  ASSERT_EQ(read.channelCount(), image.channelCount());
  for (const std::string& channel : channels) {
    const int from = image.channel(channel), to = read.channel(channel);
    for (int y = 0; y < 5; ++y) {
      for (int x = 0; x < 7; ++x) EXPECT_EQ(read.at(x, y, to), image.at(x, y, from)) << channel;
    }
  }
  for (const auto& [key, value] : metadata) {
    const auto found = read.metadata().find(key);
    ASSERT_NE(found, read.metadata().end()) << key;
    EXPECT_EQ(found->second, value) << key;
  }
  const auto* primaries = findMetadata<std::vector<float>>(read.metadata(), "chromaticities");
  ASSERT_NE(primaries, nullptr);
  EXPECT_EQ(*primaries, (std::vector<float>{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f}));
  EXPECT_EQ(*findMetadata<std::string>(read.metadata(), "encoding"), "linear");
}

TEST_F(ImageIo, ExrHalfRoundsColoursOnly) {
  Image image(4, 4, {"R", "G", "B", "Z", "StdErr.R"});
  for (float& v : image.values()) v = 1.0f / 3.0f;
  const Image read = decodeImage(encodeImage(image, ImageFormat::Exr, {.half = true}), "half");
  EXPECT_NE(read.at(0, 0, read.channel("R")), 1.0f / 3.0f);
  EXPECT_NEAR(read.at(0, 0, read.channel("R")), 1.0f / 3.0f, 1.0f / 4096.0f);
  EXPECT_EQ(read.at(0, 0, read.channel("Z")), 1.0f / 3.0f);
  EXPECT_EQ(read.at(0, 0, read.channel("StdErr.R")), 1.0f / 3.0f);
}

TEST_F(ImageIo, EveryFormatReadsBack) {
  const Image image = ramp(97, 901);
  struct Case {
    const char* file;
    int bits;
    float tolerance;
    const char* encoding;
  };
  for (const Case& c :
       {Case{"a.exr", 8, 0.0f, "linear"}, Case{"a.png", 8, 0.5f / 255, "srgb"}, Case{"b.png", 16, 0.5f / 65535, "srgb"},
        Case{"a.jpg", 8, 6.0f / 255, "srgb"}, Case{"b.JPEG", 8, 6.0f / 255, "srgb"},
        Case{"a.tif", 8, 0.5f / 255, "srgb"}, Case{"b.tiff", 16, 0.5f / 65535, "srgb"},
        Case{"a.hdr", 8, 1.0f / 128, "linear"}, Case{"a.ppm", 8, 0.5f / 255, "srgb"}}) {
    SCOPED_TRACE(c.file);
    writeImage(image, folder_ / c.file, {.bits = c.bits});
    const Image read = readImage(folder_ / c.file);
    ASSERT_EQ(read.width(), 97);
    ASSERT_EQ(read.height(), 901);
    EXPECT_EQ(*findMetadata<std::string>(read.metadata(), "encoding"), c.encoding);
    ASSERT_EQ(read.channelCount(), 3);
    const std::array<int, 3> rgb = read.findRgb().value();
    float difference = 0.0f;
    for (std::size_t i = 0; i < image.values().size(); ++i) {
      const float value = read.values()[i / 3 * 3 + static_cast<std::size_t>(rgb[i % 3])];
      difference = std::max(difference, std::abs(value - image.values()[i]));
    }
    EXPECT_LE(difference, c.tolerance + 1e-7f);
  }
}

TEST_F(ImageIo, QuantisesByRoundingOrAsTheBooksDo) {
  Image image(4, 1, {"Y"});
  image.values()[0] = 1.0f;
  image.values()[1] = 0.5f;
  image.values()[2] = -3.0f;
  image.values()[3] = std::numeric_limits<float>::quiet_NaN();
  const auto codes = [&](const WriteOptions& options) {
    const Image read = decodeImage(encodeImage(image, ImageFormat::Ppm, options), "ppm");
    std::vector<int> result;
    result.reserve(4);
    for (int x = 0; x < 4; ++x) result.push_back(static_cast<int>(std::lround(read.at(x, 0, 1) * 255.0f)));
    return result;
  };
  EXPECT_EQ(codes({}), (std::vector<int>{255, 128, 0, 0}));
  image.values()[1] = 0.999f / 2;  // 127.87 of 256, 127.37 of 255
  EXPECT_EQ(codes({}), (std::vector<int>{255, 127, 0, 0}));
  image.values()[1] = 0.4999f;  // 127.97 of 256, 127.47 of 255: the books cut off
  EXPECT_EQ(codes({.quantisation = Quantisation::Book}), (std::vector<int>{255, 127, 0, 0}));
  image.values()[1] = 0.4f;  // 102.4 of 256, 102.0 of 255
  image.metadata().insert_or_assign("quantisation", std::string("book"));
  EXPECT_EQ(codes({}), (std::vector<int>{255, 102, 0, 0}));
  image.values()[1] = 0.998f;  // 255.49 of 256, 254.49 of 255
  EXPECT_EQ(codes({}), (std::vector<int>{255, 255, 0, 0}));
  EXPECT_EQ(codes({.quantisation = Quantisation::Round}), (std::vector<int>{255, 254, 0, 0}));
}

TEST_F(ImageIo, FirstBytesDecideNotTheName) {
  writeImage(ramp(8, 8), folder_ / "a.png");
  fs::rename(folder_ / "a.png", folder_ / "a.exr");
  EXPECT_EQ(readImage(folder_ / "a.exr").width(), 8);
}

TEST_F(ImageIo, UnknownExtensionSuggests) {
  try {
    imageFormatOf("out.pgn");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    EXPECT_NE(std::string(error.what()).find("\"png\""), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(".tiff"), std::string::npos) << error.what();
  }
  EXPECT_EQ(kindOf([] { imageFormatOf("noextension"); }), ErrorKind::Usage);
  EXPECT_EQ(imageFormatOf("A.TIF"), ImageFormat::Tiff);
}

TEST_F(ImageIo, BadOptionsAreRefused) {
  const Image image = ramp(4, 4);
  EXPECT_EQ(kindOf([&] { encodeImage(image, ImageFormat::Jpeg, {.bits = 16}); }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([&] { encodeImage(image, ImageFormat::Ppm, {.bits = 16}); }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([&] { encodeImage(image, ImageFormat::Png, {.bits = 12}); }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([&] { encodeImage(image, ImageFormat::Jpeg, {.jpegQuality = 0}); }), ErrorKind::Usage);
  const Image noColour(4, 4, {"X", "Y"});
  EXPECT_EQ(kindOf([&] { encodeImage(noColour, ImageFormat::Png); }), ErrorKind::Usage);
  EXPECT_EQ(kindOf([] { encodeImage(Image(65501, 1, {"Y"}), ImageFormat::Jpeg); }), ErrorKind::Output);
  EXPECT_EQ(kindOf([] { encodeImage(Image(1, 1000001, {"Y"}), ImageFormat::Png); }), ErrorKind::Output);
}

TEST_F(ImageIo, UnwritableTargetsAreOutputErrors) {
  const Image image = ramp(64, 64);
  for (const char* extension : {"exr", "png", "jpg", "tif", "hdr", "ppm"}) {
    SCOPED_TRACE(extension);
    const WriteOptions options{.format = imageFormatOf(std::string("a.") + extension)};
    EXPECT_EQ(kindOf([&] { writeImage(image, "/dev/full", options); }), ErrorKind::Output);
    EXPECT_EQ(kindOf([&] { writeImage(image, folder_ / "missing" / "a", options); }), ErrorKind::Output);
    EXPECT_EQ(kindOf([&] { writeImage(image, folder_, options); }), ErrorKind::Output);
    EXPECT_NO_THROW(writeImage(image, "/dev/null", options));
  }
  EXPECT_EQ(filesInFolder(), 0u);
}

/// Lets no file of this process grow beyond `bytes` while it lives. (A child process made by fork would not do: the
/// threads of OpenEXR's pool stay behind, and writing waits for them.)
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*signal_)(int);
};

TEST_F(ImageIo, FileSizeLimitLeavesNothingBehind) {
  const Image image = ramp(256, 256);
  std::ofstream(folder_ / "old.png") << "old";
  for (const char* file : {"a.exr", "old.png", "a.jpg", "a.tif", "a.hdr", "a.ppm"}) {
    SCOPED_TRACE(file);
    const auto write = [&] {
      const FileSizeLimit limit(512);
      writeImage(image, folder_ / file, {.bits = 8});
    };
    EXPECT_EQ(kindOf(write), ErrorKind::Output);
    EXPECT_EQ(filesInFolder(), 1u);
  }
  std::string content;
  std::ifstream(folder_ / "old.png") >> content;
  EXPECT_EQ(content, "old");
}

/// A complete file of one small tile whose data window is then made huge.
TEST_F(ImageIo, HugeDataWindowIsRefusedBeforeAllocation) {
  std::vector<std::byte> file = encodeImage(Image(1, 1, {"Y"}), ImageFormat::Exr);
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  const std::size_t box = text.find(std::string_view("dataWindow\0box2i\0", 17)) + 17 + 4;
  ASSERT_LT(box + 16, file.size());
  for (const std::int32_t side : {20'000, 60'000, 2'000'000'000}) {
    const std::int32_t last = side - 1;
    std::memcpy(file.data() + box + 8, &last, 4);
    std::memcpy(file.data() + box + 12, &last, 4);
    try {
      decodeImage(file, "hostile.exr");
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::Scene);
      EXPECT_NE(std::string(error.what()).find("hostile.exr: error:"), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("claims " + std::to_string(side)), std::string::npos) << error.what();
    }
  }
}

TEST_F(ImageIo, DamagedFilesAreSceneErrors) {
  const Image image = ramp(64, 64);
  for (const ImageFormat format :
       {ImageFormat::Exr, ImageFormat::Png, ImageFormat::Tiff, ImageFormat::Hdr, ImageFormat::Ppm}) {
    SCOPED_TRACE(formatName(format));
    std::vector<std::byte> file = encodeImage(image, format);
    file.resize(file.size() / 2);
    EXPECT_EQ(kindOf([&] { decodeImage(file, "half"); }), ErrorKind::Scene);
    file.resize(12);
    EXPECT_EQ(kindOf([&] { decodeImage(file, "stump"); }), ErrorKind::Scene);
  }
  EXPECT_EQ(kindOf([] { decodeImage(bytesOf(""), "empty"); }), ErrorKind::Scene);
  EXPECT_EQ(kindOf([] { decodeImage(bytesOf("hello, world"), "text"); }), ErrorKind::Scene);
  EXPECT_EQ(kindOf([] { decodeImage(bytesOf("P6 100000 100000 255\n"), "ppm"); }), ErrorKind::Scene);
  EXPECT_EQ(kindOf([&] { readImage(folder_); }), ErrorKind::Scene);
  EXPECT_EQ(kindOf([&] { readImage(folder_ / "missing.png"); }), ErrorKind::Scene);
  EXPECT_EQ(kindOf([] { readImage("/dev/zero", {.maxFileBytes = 1 << 20}); }), ErrorKind::Scene);
}

TEST_F(ImageIo, LimitsAreObeyed) {
  const std::vector<std::byte> file = encodeImage(ramp(64, 32), ImageFormat::Png);
  EXPECT_NO_THROW(decodeImage(file, "png", {.maxSide = 64, .maxBytes = 64 * 32 * 3 * 4}));
  EXPECT_EQ(kindOf([&] { decodeImage(file, "png", {.maxSide = 63}); }), ErrorKind::Scene);
  EXPECT_EQ(kindOf([&] { decodeImage(file, "png", {.maxBytes = 64 * 32 * 3 * 4 - 1}); }), ErrorKind::Scene);
}

}  // namespace
}  // namespace steradian
