#include "steradian/apps/scenes/earth_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace steradian {
namespace {

TEST(EarthPicture, HasSeaLandAndIceAtBothPoles) {
  const Image map = scenes::earthPicture(256, 128);
  int sea = 0, land = 0, ice = 0;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 256; ++x) {
      const auto c = map.pixel(x, y);
      for (const float value : c) {
        EXPECT_GE(value, 0.0f);
        EXPECT_LE(value, 1.0f);
      }
      const bool isIce = c[0] > 0.6f, isSea = c[2] > 1.5f * c[0];
      ice += isIce ? 1 : 0, sea += !isIce && isSea ? 1 : 0, land += !isIce && !isSea ? 1 : 0;
      EXPECT_TRUE(isIce || (y >= 6 && y < 122)) << x << ' ' << y;
    }
  }
  const int all = 256 * 128;
  EXPECT_GT(sea, all / 3);
  EXPECT_GT(land, all / 6);
  EXPECT_GT(ice, all / 20);
}

TEST(EarthPicture, HasNoSeam) {
  const Image map = scenes::earthPicture(512, 256);
  double within = 0.0, across = 0.0;
  for (int y = 0; y < 256; ++y) {
    const auto difference = [&](int a, int b) { return std::abs(map.at(a, y, 0) - map.at(b, y, 0)); };
    for (int x = 1; x < 512; ++x) within += difference(x - 1, x) / 511.0;
    across += difference(511, 0);
  }
  EXPECT_LT(across, 3.0 * within + 0.5);
}

TEST(EarthPicture, HasTheSamePlacesAtEverySize) {
  const Image small = scenes::earthPicture(12, 5), large = scenes::earthPicture(36, 15);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 12; ++x) EXPECT_NEAR(small.at(x, y, 1), large.at(3 * x + 1, 3 * y + 1, 1), 1e-3f);
  }
}

}  // namespace
}  // namespace steradian
