#include "steradian/materials/image_texture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace steradian {
namespace {

using Wrap = ImageTexture::Wrap;
using Filter = ImageTexture::Filter;

/// 4 x 2 pixels: red counts columns from the left, green rows from the top, in tenths.
std::shared_ptr<const Image> numbered() {
  auto image = std::make_shared<Image>(4, 2, std::vector<std::string>{"R", "G", "B"});
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 4; ++x) {
      image->at(x, y, 0) = 0.1f * static_cast<float>(x + 1);
      image->at(x, y, 1) = 0.1f * static_cast<float>(y + 1);
    }
  }
  return image;
}

ImageTexture texture(Wrap wrap, Filter filter) {
  return {.name = "", .image = numbered(), .wrapU = wrap, .wrapV = wrap, .filter = filter};
}

TEST(ImageTextureLookup, RunsToTheRightAndUpwards) {
  const ImageTextureLookup lookup(texture(Wrap::Repeat, Filter::Nearest));
  const auto expect = [&](Vec2f uv, float column, float row) {
    const Rgb c = lookup.value(uv);
    EXPECT_FLOAT_EQ(c.r, 0.1f * column) << uv.x << " " << uv.y;
    EXPECT_FLOAT_EQ(c.g, 0.1f * row) << uv.x << " " << uv.y;
  };
  expect({0.01f, 0.01f}, 1, 2);  // the lower left corner
  expect({0.99f, 0.01f}, 4, 2);
  expect({0.01f, 0.99f}, 1, 1);
  expect({0.26f, 0.51f}, 2, 1);
  expect({0.24f, 0.49f}, 1, 2);
}

TEST(ImageTextureLookup, IsExactAtTheCentresOfPixelsAndLinearBetween) {
  const ImageTextureLookup lookup(texture(Wrap::Clamp, Filter::Bilinear));
  for (const int x : {0, 1, 2, 3}) {
    for (const int y : {0, 1}) {
      const Vec2f uv{0.25f * (static_cast<float>(x) + 0.5f), 1.0f - 0.5f * (static_cast<float>(y) + 0.5f)};
      EXPECT_EQ(lookup.value(uv).r, numbered()->at(x, y, 0));
      EXPECT_EQ(lookup.value(uv).g, numbered()->at(x, y, 1));
    }
  }
  const Rgb between = lookup.value({0.25f * 1.75f, 0.25f + 0.5f * 0.75f});
  EXPECT_NEAR(between.r, 0.225f, 1e-7f);
  EXPECT_NEAR(between.g, 0.125f, 1e-7f);
}

TEST(ImageTextureLookup, WrapsAsToldByNearestPixels) {
  const auto column = [](Wrap wrap, float u) {
    return ImageTextureLookup(texture(wrap, Filter::Nearest)).value({u, 0.25f}).r;
  };
  for (const float u : {0.1f, 0.3f, 0.6f, 0.9f}) {
    const float inside = column(Wrap::Clamp, u), mirrored = column(Wrap::Clamp, 1.0f - u);
    for (const Wrap wrap : {Wrap::Repeat, Wrap::Mirror, Wrap::Black}) EXPECT_EQ(column(wrap, u), inside);
    for (const float turn : {-3.0f, -1.0f, 1.0f, 5.0f}) {
      EXPECT_EQ(column(Wrap::Repeat, u + turn), inside) << u + turn;
      EXPECT_EQ(column(Wrap::Mirror, u + turn), mirrored) << u + turn;
      EXPECT_EQ(column(Wrap::Black, u + turn), 0.0f);
      EXPECT_EQ(column(Wrap::Clamp, u + turn), turn < 0.0f ? 0.1f : 0.4f);
    }
    EXPECT_EQ(column(Wrap::Mirror, u - 2.0f), inside);
  }
}

TEST(ImageTextureLookup, WrapsAsToldBetweenPixels) {
  const auto red = [](Wrap wrap, float u) {
    return ImageTextureLookup(texture(wrap, Filter::Bilinear)).value({u, 0.25f}).r;
  };
  EXPECT_NEAR(red(Wrap::Repeat, 0.0f), 0.25f, 1e-7f);  // half the first, half the last
  EXPECT_NEAR(red(Wrap::Repeat, 1.0f), 0.25f, 1e-7f);
  EXPECT_NEAR(red(Wrap::Mirror, 0.0f), 0.1f, 1e-7f);
  EXPECT_NEAR(red(Wrap::Mirror, 1.0f), 0.4f, 1e-7f);
  EXPECT_NEAR(red(Wrap::Clamp, 0.0f), 0.1f, 1e-7f);
  EXPECT_NEAR(red(Wrap::Black, 0.0f), 0.05f, 1e-7f);
  EXPECT_NEAR(red(Wrap::Black, 1.0f), 0.2f, 1e-7f);
  EXPECT_NEAR(red(Wrap::Black, -0.0625f), 0.025f, 1e-7f);
  EXPECT_EQ(red(Wrap::Black, -0.126f), 0.0f);
  EXPECT_EQ(red(Wrap::Black, 1.126f), 0.0f);
  // Repeating is continuous everywhere.
  for (float u = -2.0f; u < 2.0f; u += 0.0137f) {
    EXPECT_NEAR(red(Wrap::Repeat, u), red(Wrap::Repeat, u + 1e-4f), 0.35f * 4.0f * 1.1e-4f) << u;
    EXPECT_NEAR(red(Wrap::Mirror, u), red(Wrap::Mirror, u + 1e-4f), 0.1f * 4.0f * 1.1e-4f) << u;
  }
}

TEST(ImageTextureLookup, FitsSeveralTimesAndTurnedOver) {
  ImageTexture several = texture(Wrap::Repeat, Filter::Nearest);
  several.repeatU = 3.0f;
  several.repeatV = -1.0f;
  const ImageTextureLookup lookup(several);
  EXPECT_FLOAT_EQ(lookup.value({0.01f, 0.0f}).r, 0.1f);
  EXPECT_FLOAT_EQ(lookup.value({0.32f, 0.0f}).r, 0.4f);
  EXPECT_FLOAT_EQ(lookup.value({0.35f, 0.0f}).r, 0.1f);
  EXPECT_FLOAT_EQ(lookup.value({0.0f, 0.01f}).g, 0.1f);  // the top
  EXPECT_FLOAT_EQ(lookup.value({0.0f, 0.99f}).g, 0.2f);
}

TEST(ImageTextureLookup, ClampsToReflectances) {
  auto image = std::make_shared<Image>(2, 1, std::vector<std::string>{"R", "G", "B"});
  image->at(0, 0, 0) = 3.0f, image->at(0, 0, 1) = -1.0f, image->at(0, 0, 2) = 0.5f;
  for (const Filter filter : {Filter::Nearest, Filter::Bilinear}) {
    const Rgb c = ImageTextureLookup({.image = image, .wrapU = Wrap::Clamp, .filter = filter}).value({0.0f, 0.5f});
    EXPECT_EQ(c.r, 1.0f);
    EXPECT_EQ(c.g, 0.0f);
    EXPECT_EQ(c.b, 0.5f);
  }
}

TEST(ImageTextureLookup, TakesAnyNumbers) {
  const float large = std::numeric_limits<float>::max(), infinite = std::numeric_limits<float>::infinity();
  auto one = std::make_shared<Image>(1, 1, std::vector<std::string>{"Y"});
  one->at(0, 0, 0) = 0.5f;
  for (const Wrap wrap : {Wrap::Repeat, Wrap::Mirror, Wrap::Clamp, Wrap::Black}) {
    for (const Filter filter : {Filter::Nearest, Filter::Bilinear}) {
      const ImageTextureLookup lookup(texture(wrap, filter));
      const ImageTextureLookup single({.image = one, .wrapU = wrap, .wrapV = wrap, .filter = filter});
      for (const float x : {-1e-9f, 0.0f, 1.0f, 1e9f, -1e9f, large, -large, infinite, -infinite, std::nanf("")}) {
        for (const float y : {0.5f, 1e30f, std::nanf("")}) {
          const float red = lookup.value({x, y}).r;
          EXPECT_GE(red, 0.0f);
          EXPECT_LE(red, 0.4f);
          const float grey = single.value({x, y}).g;
          EXPECT_GE(grey, 0.0f);
          EXPECT_LE(grey, 0.5f);
        }
      }
    }
  }
}

}  // namespace
}  // namespace steradian
