#include "steradian/core/colour/false_colour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/colour/display.h"

namespace steradian {
namespace {

float lightness(const DisplayColour& c) {
  return 0.2126f * srgbDecode(c[0]) + 0.7152f * srgbDecode(c[1]) + 0.0722f * srgbDecode(c[2]);
}

TEST(FalseColour, HeatGrowsInLightnessWithoutLeavingTheGamut) {
  float previous = -1.0f;
  for (int i = 0; i <= 100; ++i) {
    const DisplayColour colour = heatColour(static_cast<float>(i) / 100.0f);
    EXPECT_GT(lightness(colour), previous) << i;
    previous = lightness(colour);
    for (const float c : colour) {
      EXPECT_GT(c, 0.0f) << i;  // 0 and 1 are where a colour outside sRGB would have been cut
      EXPECT_LT(c, 1.0f) << i;
    }
  }
  EXPECT_LT(lightness(heatColour(0.0f)), 0.01f);
  EXPECT_GT(lightness(heatColour(1.0f)), 0.8f);
  EXPECT_EQ(heatColour(-5.0f), heatColour(0.0f));
  EXPECT_EQ(heatColour(std::numeric_limits<float>::infinity()), heatColour(1.0f));
}

TEST(FalseColour, NotANumberStandsOut) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(heatColour(nan), divergingColour(nan));
  for (int i = 0; i <= 100; ++i) {
    const DisplayColour a = heatColour(static_cast<float>(i) / 100.0f), b = heatColour(nan);
    EXPECT_GT(std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]), 0.3f) << i;
  }
}

TEST(FalseColour, DivergingIsBalanced) {
  for (int i = 1; i <= 10; ++i) {
    const float t = static_cast<float>(i) / 10.0f;
    const DisplayColour negative = divergingColour(-t), positive = divergingColour(t);
    EXPECT_GT(negative[2], negative[0]);
    EXPECT_GT(positive[0], positive[2]);
    EXPECT_NEAR(lightness(negative), lightness(positive), 0.06f);
    EXPECT_LT(lightness(positive), lightness(divergingColour(t - 0.1f)));
  }
}

TEST(FalseColour, MapsAChannel) {
  Image image(4, 1, {"Q", "Z"});
  const float z[4] = {2.0f, 3.0f, 4.0f, std::numeric_limits<float>::infinity()};
  for (int x = 0; x < 4; ++x) image.at(x, 0, 1) = z[x];
  const ScalarRange range = rangeOf(image, "Z");
  EXPECT_EQ(range.low, 2.0f);
  EXPECT_EQ(range.high, 4.0f);
  EXPECT_EQ(rangeOf(image, "Z", 0.4).high, 3.0f);
  EXPECT_GT(rangeOf(image, "Q").high, rangeOf(image, "Q").low);
  const Image map = falseColour(image, "Z", range);
  EXPECT_EQ(map.at(1, 0, 0), heatColour(0.5f)[0]);
  EXPECT_EQ(map.at(3, 0, 1), heatColour(1.0f)[1]);
  EXPECT_THROW(falseColour(image, "W", range), Error);
}

}  // namespace
}  // namespace steradian
