#include "steradian/core/colour/colour_image.h"

#include <gtest/gtest.h>

#include <limits>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/colour/display.h"
#include "steradian/core/image/image_io.h"
#include "steradian/tests/support/lanes_check.h"
#include "steradian/tests/support/temporary_folder.h"

namespace steradian {
namespace {

class ReadPicture : public test::TemporaryFolder {
 protected:
  /// The message of the error; empty if there was none.
  std::string complaint(const std::string& file) {
    try {
      readColourImage(folder_ / file);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::Scene);
      EXPECT_NE(std::string(error.what()).find(file), std::string::npos);
      return error.what();
    }
    return {};
  }
};

Image numbered(int width, int height, std::vector<std::string> channels) {
  Image image(width, height, std::move(channels));
  float value = 0.0f;
  for (float& v : image.values()) v = value += 0.0078125f;
  return image;
}

TEST(ColourImage, FindsItsColoursAmongOtherChannels) {
  const auto image = std::make_shared<const Image>(numbered(3, 2, {"Z", "B", "A", "G", "R"}));
  const ColourImage picture(image);
  EXPECT_EQ(picture.width(), 3u);
  EXPECT_EQ(picture.height(), 2u);
  const Rgb c = picture.texel<float>(2, 1);
  EXPECT_EQ(c.r, image->at(2, 1, 4));
  EXPECT_EQ(c.g, image->at(2, 1, 3));
  EXPECT_EQ(c.b, image->at(2, 1, 1));
}

TEST(ColourImage, OneChannelIsGrey) {
  const auto image = std::make_shared<const Image>(numbered(3, 2, {"depth"}));
  const Rgb c = ColourImage(image).texel<float>(1, 1);
  EXPECT_EQ(c.r, image->at(1, 1, 0));
  EXPECT_EQ(c.g, c.r);
  EXPECT_EQ(c.b, c.r);
}

TEST(ColourImage, NeedsColours) {
  EXPECT_THROW(ColourImage(nullptr), Error);
  EXPECT_THROW(ColourImage(std::make_shared<const Image>(numbered(1, 1, {"R", "G"}))), Error);
}

TEST(ColourImage, BlendsFourPixels) {
  const auto image = std::make_shared<const Image>(numbered(4, 4, {"R", "G", "B"}));
  const ColourImage picture(image);
  const Rgb c = picture.blend<float>({1, 2, 0.25f}, {3, 0, 0.5f});
  const auto along = [&](int y) { return 0.75f * image->at(1, y, 1) + 0.25f * image->at(2, y, 1); };
  EXPECT_FLOAT_EQ(c.g, 0.5f * along(3) + 0.5f * along(0));
}

TEST(ColourImage, LanesAgreeWithScalars) {
  const ColourImage picture(std::make_shared<const Image>(numbered(7, 5, {"R", "G", "B"})));
  const auto value = [&](auto x, auto y) {
    using F = decltype(x);
    const UintOf<F> column = toUnsigned(toInt(x * F(6.0f))), row = toUnsigned(toInt(y * F(4.0f)));
    return picture.blend<F>({column, column + UintOf<F>(1u), x}, {row, row + UintOf<F>(1u), y}).b;
  };
  EXPECT_TRUE(test::sameInLanes<8>(value, test::unitNumbers(200), test::unitNumbers(200, 1)));
}

TEST_F(ReadPicture, RemovesTheCurveOfDisplayFiles) {
  Image image(2, 1, {"R", "G", "B"});
  image.at(1, 0, 0) = 1.0f, image.at(1, 0, 1) = 128.0f / 255.0f;
  writeImage(image, folder_ / "a.png");
  writeImage(image, folder_ / "a.exr");
  const auto png = readColourImage(folder_ / "a.png"), exr = readColourImage(folder_ / "a.exr");
  EXPECT_EQ(png->at(1, 0, 0), 1.0f);
  EXPECT_FLOAT_EQ(png->at(1, 0, 1), srgbDecode(128.0f / 255.0f));
  EXPECT_EQ(exr->at(1, 0, 1), image.at(1, 0, 1));
}

TEST_F(ReadPicture, KeepsColoursAlone) {
  writeImage(numbered(3, 2, {"R", "G", "B", "A", "Z"}), folder_ / "colours.exr");
  EXPECT_EQ(readColourImage(folder_ / "colours.exr")->channels(), (std::vector<std::string>{"R", "G", "B"}));
  writeImage(numbered(3, 2, {"Z"}), folder_ / "depth.exr");
  EXPECT_EQ(readColourImage(folder_ / "depth.exr")->channelCount(), 1);
  writeImage(numbered(3, 2, {"Y", "A"}), folder_ / "cutout.exr");
  const auto cutout = readColourImage(folder_ / "cutout.exr");
  EXPECT_EQ(cutout->channelCount(), 1);
  EXPECT_EQ(cutout->at(2, 1, 0), 11.0f * 0.0078125f);
}

TEST_F(ReadPicture, SaysWhatIsWrong) {
  EXPECT_NE(complaint("missing.png"), "");
  writeImage(numbered(3, 2, {"N.X", "N.Y"}), folder_ / "normals.exr");
  EXPECT_NE(complaint("normals.exr").find("but N.X, N.Y"), std::string::npos);
  Image hot = numbered(3, 2, {"R", "G", "B"});
  hot.at(1, 1, 2) = std::numeric_limits<float>::infinity();
  writeImage(hot, folder_ / "hot.exr");
  EXPECT_NE(complaint("hot.exr").find("pixel (1, 1)"), std::string::npos);
  Image part(3, 2, {"R", "G", "B"}, ImageWindow{1, 1, 8, 8});
  writeImage(part, folder_ / "part.exr");
  EXPECT_NE(complaint("part.exr").find("part of a larger picture"), std::string::npos);
}

}  // namespace
}  // namespace steradian
