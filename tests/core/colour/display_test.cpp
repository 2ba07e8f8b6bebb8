#include "steradian/core/colour/display.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <thread>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/colour/display_config.h"
#include "steradian/core/image/image_io.h"

namespace steradian {
namespace {

Image pixel(float r, float g, float b) {
  Image image(1, 1, {"Z", "R", "G", "B"});
  image.at(0, 0, 0) = 7.0f;
  image.at(0, 0, 1) = r;
  image.at(0, 0, 2) = g;
  image.at(0, 0, 3) = b;
  return image;
}

std::array<float, 3> seen(const Display& display, const Image& image, const DisplaySettings& settings = {}) {
  const Image result = display.apply(image, settings);
  EXPECT_EQ(result.channelCount(), 3);
  return {result.at(0, 0, 0), result.at(0, 0, 1), result.at(0, 0, 2)};
}

std::string messageOf(const std::function<void()>& action, ErrorKind kind) {
  try {
    action();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

TEST(Display, HasTheFourViews) {
  const Display display;
  EXPECT_EQ(display.displays(), std::vector<std::string>{"sRGB"});
  EXPECT_EQ(display.views(), (std::vector<std::string>{"sRGB", "ACES SDR", "Book", "Raw"}));
  EXPECT_EQ(display.defaultView(), "sRGB");
}

/// OpenColorIO makes the slope of the linear part 12.9232, which is exactly tangential; the standard rounds to 12.92.
TEST(Display, SrgbIsTheCurveOfTheStandard) {
  const Display display;
  EXPECT_NEAR(seen(display, pixel(0.18f, 0.0f, 1.0f))[0], 0.4613561f, 2e-6f);
  for (int i = 0; i <= 220; ++i) {
    const float x = static_cast<float>(i) * 0.01f;
    const auto rgb = seen(display, pixel(x, x * 0.1f, x * 0.01f));
    EXPECT_NEAR(rgb[0], srgbEncode(x), 1.2e-5f);
    EXPECT_NEAR(rgb[1], srgbEncode(x * 0.1f), 1.2e-5f);
    EXPECT_NEAR(rgb[2], srgbEncode(x * 0.01f), 1.2e-5f);
    EXPECT_NEAR(srgbDecode(srgbEncode(x)), x, 2e-6f);
    EXPECT_EQ(srgbEncode(-x), -srgbEncode(x));
  }
  EXPECT_LT(seen(display, pixel(-0.1f, 0.0f, 0.0f))[0], 0.0f);
}

TEST(Display, BookIsTheSquareRootAndQuantisesLikeTheBooks) {
  const Image image = Display().apply(pixel(0.25f, 0.5f, 1.0f), {.display = {}, .view = "Book"});
  EXPECT_NEAR(image.at(0, 0, 0), 0.5f, 1e-6f);
  EXPECT_NEAR(image.at(0, 0, 1), std::sqrt(0.5f), 1e-6f);
  EXPECT_NEAR(image.at(0, 0, 2), 1.0f, 1e-6f);
  const Image read = decodeImage(encodeImage(image, ImageFormat::Png), "png");
  EXPECT_EQ(std::lround(read.at(0, 0, 0) * 255), 128);  // int(256 * .5)
  EXPECT_EQ(std::lround(read.at(0, 0, 1) * 255), 181);  // int(181.02)
  EXPECT_EQ(std::lround(read.at(0, 0, 2) * 255), 255);
  EXPECT_GE(seen(Display(), pixel(-0.5f, 0, 0), {.display = {}, .view = "Book"})[0], 0.0f);
}

TEST(Display, RawChangesNothing) {
  EXPECT_EQ(seen(Display(), pixel(-1.0f, 0.18f, 30.0f), {.display = {}, .view = "Raw"}),
            (std::array<float, 3>{-1.0f, 0.18f, 30.0f}));
}

/// Grey stays grey, brighter is brighter, and the ends of the range are those of the ACES tone scale: 4.8 nit for
/// 18 % grey and 48 nit for white in the cinema, which the video transform takes to 10 and 100 nit with a dim surround.
TEST(Display, AcesCompressesHighlights) {
  const Display display;
  const DisplaySettings aces{.display = {}, .view = "ACES SDR"};
  float previous = -1.0f;
  for (const float x : {0.0f, 0.01f, 0.18f, 0.5f, 1.0f, 4.0f, 16.0f}) {
    const auto rgb = seen(display, pixel(x, x, x), aces);
    EXPECT_NEAR(rgb[0], rgb[1], 2e-3f) << x;
    EXPECT_NEAR(rgb[1], rgb[2], 2e-3f) << x;
    EXPECT_GT(rgb[1], previous);
    EXPECT_LE(rgb[1], 1.0f + 1e-4f);
    previous = rgb[1];
  }
  const float middleGrey = srgbDecode(seen(display, pixel(0.18f, 0.18f, 0.18f), aces)[1]);
  EXPECT_NEAR(middleGrey, 0.10f, 0.01f);
  EXPECT_NEAR(previous, 1.0f, 0.02f);
}

TEST(Display, ExposureIsInStops) {
  const auto brighter = seen(Display(), pixel(0.09f, 0.5f, 0.25f), {.display = {}, .view = "Raw", .exposure = 1.0f});
  EXPECT_EQ(brighter, (std::array<float, 3>{0.18f, 1.0f, 0.5f}));
  messageOf([] { Display().check({.display = {}, .view = {}, .exposure = 1000.0f}); }, ErrorKind::Usage);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  messageOf([=] { Display().check({.display = {}, .view = {}, .exposure = nan}); }, ErrorKind::Usage);
}

TEST(Display, KeepsWindowAndMetadata) {
  Image image(2, 2, {"R", "G", "B"}, ImageWindow{1, 2, 8, 9});
  image.metadata()["seed"] = 5;
  const Image result = Display().apply(image);
  EXPECT_EQ(result.window(), image.window());
  EXPECT_EQ(*findMetadata<int>(result.metadata(), "seed"), 5);
  EXPECT_EQ(*findMetadata<std::string>(result.metadata(), "encoding"), "display");
}

TEST(Display, UnknownNamesSuggest) {
  const Display display;
  const auto view = messageOf([&] { display.check({.display = {}, .view = "Bok"}); }, ErrorKind::Usage);
  EXPECT_NE(view.find("did you mean \"Book\""), std::string::npos) << view;
  const auto name = messageOf([&] { display.views("sRBG"); }, ErrorKind::Usage);
  EXPECT_NE(name.find("did you mean \"sRGB\""), std::string::npos) << name;
  messageOf([&] { display.apply(Image(1, 1, {"Y"})); }, ErrorKind::Usage);
}

/// Our own configuration taken for a foreign one goes through ACES2065-1 and back.
TEST(Display, ForeignConfigurationsJoinThroughTheInterchangeRole) {
  const Display foreign = Display::fromText(displayConfigText(), "copy");
  const Display own;
  const Image image = pixel(0.18f, 0.6f, 0.03f);
  for (const char* view : {"sRGB", "ACES SDR", "Book", "Raw"}) {
    const auto a = seen(own, image, {.display = {}, .view = view});
    const auto b = seen(foreign, image, {.display = {}, .view = view});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], 1e-5f) << view;
  }
}

TEST(Display, ConfigurationWithoutInterchangeRoleIsRefused) {
  std::string text = displayConfigText();
  const std::string role = "  aces_interchange: ACES2065-1\n";
  text.erase(text.find(role), role.size());
  const auto message = messageOf([&] { Display::fromText(text, "theirs.ocio"); }, ErrorKind::Usage);
  EXPECT_NE(message.find("theirs.ocio"), std::string::npos);
  EXPECT_NE(message.find("aces_interchange"), std::string::npos);
  messageOf([] { Display::fromText("no configuration", "text"); }, ErrorKind::Usage);
  messageOf([] { Display(std::filesystem::path("/nonexistent/config.ocio")); }, ErrorKind::Usage);
}

TEST(Display, ReadsAConfigurationFile) {
  const auto path = std::filesystem::temp_directory_path() / ("steradian-" + std::to_string(::getpid()) + ".ocio");
  std::ofstream(path) << displayConfigText();
  const Display display(path);
  std::filesystem::remove(path);
  EXPECT_EQ(display.defaultDisplay(), "sRGB");
}

TEST(Display, ThreadsShareOne) {
  const Display display;
  std::array<float, 3> results[4];
  std::vector<std::thread> threads;
  for (auto& result : results) {
    threads.emplace_back([&] { result = seen(display, pixel(0.2f, 0.3f, 0.4f), {.display = {}, .view = "ACES SDR"}); });
  }
  for (std::thread& thread : threads) thread.join();
  for (const auto& result : results) EXPECT_EQ(result, results[0]);
}

TEST(Display, LineariseRemovesTheCurveOnce) {
  Image image(1, 1, {"R", "G", "B", "A"});
  for (float& v : image.values()) v = 0.5f;
  linearise(image);
  EXPECT_EQ(image.at(0, 0, 0), 0.5f);  // unknown encoding
  image.metadata().insert_or_assign("encoding", std::string("srgb"));
  linearise(image);
  linearise(image);
  EXPECT_NEAR(image.at(0, 0, 0), 0.21404114f, 1e-6f);
  EXPECT_EQ(image.at(0, 0, 3), 0.5f);
}

}  // namespace
}  // namespace steradian
