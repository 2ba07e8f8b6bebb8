#include "steradian/core/image/image.h"

#include <gtest/gtest.h>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

ErrorKind kindOfFailure(int width, int height, const std::vector<std::string>& channels,
                        std::optional<ImageWindow> window = std::nullopt) {
  try {
    const Image image(width, height, channels, window);
  } catch (const Error& error) {
    return error.kind();
  }
  ADD_FAILURE() << "nothing was thrown";
  return ErrorKind::Other;
}

TEST(Image, StoresInterleavedPixels) {
  Image image(3, 2, {"R", "G", "B", "Z"});
  EXPECT_EQ(image.pixelCount(), 6u);
  EXPECT_EQ(image.values().size(), 24u);
  image.at(2, 1, 3) = 5.0f;
  EXPECT_EQ(image.values().back(), 5.0f);
  EXPECT_EQ(image.pixel(2, 1)[3], 5.0f);
  EXPECT_EQ(image.at(1, 1, 3), 0.0f);
}

TEST(Image, FindsChannels) {
  const Image image(1, 1, {"B", "Albedo.R", "R", "G"});
  EXPECT_EQ(image.findChannel("Albedo.R"), 1);
  EXPECT_FALSE(image.findChannel("A").has_value());
  EXPECT_EQ(*image.findRgb(), (std::array<int, 3>{2, 3, 0}));
  EXPECT_FALSE(Image(1, 1, {"R", "G"}).findRgb().has_value());
  try {
    image.channel("Albdo.R");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"Albedo.R\""), std::string::npos) << error.what();
  }
}

TEST(Image, KnowsItsWindow) {
  EXPECT_FALSE(Image(4, 3, {"Y"}).isCropped());
  const Image crop(4, 3, {"Y"}, ImageWindow{2, 1, 8, 8});
  EXPECT_TRUE(crop.isCropped());
  EXPECT_EQ(crop.window().x0, 2);
}

TEST(Image, RefusesImpossibleShapes) {
  EXPECT_EQ(kindOfFailure(0, 1, {"Y"}), ErrorKind::Usage);
  EXPECT_EQ(kindOfFailure(1, -5, {"Y"}), ErrorKind::Usage);
  EXPECT_EQ(kindOfFailure(Image::maxSide + 1, 1, {"Y"}), ErrorKind::Usage);
  EXPECT_EQ(kindOfFailure(1, 1, {}), ErrorKind::Usage);
  EXPECT_EQ(kindOfFailure(1, 1, {"R", "G", "R"}), ErrorKind::Usage);
  EXPECT_EQ(kindOfFailure(1, 1, {"R", ""}), ErrorKind::Usage);
  EXPECT_EQ(kindOfFailure(1, 1, {"Y"}, ImageWindow{0, 0, 0, 1}), ErrorKind::Usage);
}

/// 2^40 pixels of 64 channels are 2^48 bytes.
TEST(Image, RefusesMoreThanTheAddressSpace) {
  std::vector<std::string> channels(64);
  for (std::size_t i = 0; i < channels.size(); ++i) channels[i] = std::to_string(i);
  EXPECT_EQ(kindOfFailure(Image::maxSide, Image::maxSide, channels), ErrorKind::Memory);
}

TEST(Image, MetadataByType) {
  Image image(1, 1, {"Y"});
  image.metadata()["seed"] = 3;
  EXPECT_EQ(*findMetadata<int>(image.metadata(), "seed"), 3);
  EXPECT_EQ(findMetadata<float>(image.metadata(), "seed"), nullptr);
  EXPECT_EQ(findMetadata<int>(image.metadata(), "sed"), nullptr);
}

}  // namespace
}  // namespace steradian
