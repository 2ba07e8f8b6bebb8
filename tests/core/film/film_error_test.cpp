#include "steradian/core/film/film_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace steradian {
namespace {

/// Eight samples (one per group) of mean `mean`, whose standard error is `error`.
std::vector<PixelSample> eightSamples(float mean, float error) {
  // Deviations +-d have a spread of 8 d^2 / 7: the error of the mean is d / sqrt 7.
  const float d = error * std::sqrt(7.0f);
  std::vector<PixelSample> samples;
  for (int i = 0; i < 8; ++i) {
    const float v = i % 2 == 0 ? mean - d : mean + d;
    samples.push_back({.radiance = {v, v, v}});
  }
  return samples;
}

TEST(FilmError, BlocksPoolTheirPixels) {
  Film film({.width = 18, .height = 9});
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 18; ++x) film.addSamples(x, y, 0, eightSamples(2.0f, 0.5f));
  }
  const std::vector<BlockEstimate> blocks = estimateBlocks(film);
  ASSERT_EQ(blocks.size(), 6u);
  EXPECT_EQ(blocks[0].pixels, (Crop{0, 8, 0, 8}));
  EXPECT_EQ(blocks[2].pixels, (Crop{16, 18, 0, 8}));
  EXPECT_EQ(blocks[5].pixels, (Crop{16, 18, 8, 9}));
  for (const BlockEstimate& b : blocks) {
    const double pixels = (b.pixels.x1 - b.pixels.x0) * (b.pixels.y1 - b.pixels.y0);
    EXPECT_NEAR(b.mean, 2.0, 1e-6);
    EXPECT_NEAR(b.standardError, 0.5 / std::sqrt(pixels), 1e-6);
    EXPECT_NEAR(b.degreesOfFreedom, 7.0 * pixels, 1e-3);  // equal variances: they add up
  }
}

TEST(FilmError, OneNoisyPixelRulesTheDegreesOfFreedomOfItsBlock) {
  Film film({.width = 8, .height = 8});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) film.addSamples(x, y, 0, eightSamples(1.0f, x + y == 0 ? 1.0f : 0.0f));
  }
  const std::vector<BlockEstimate> blocks = estimateBlocks(film);
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_NEAR(blocks[0].standardError, 1.0 / 64.0, 1e-6);
  EXPECT_NEAR(blocks[0].degreesOfFreedom, 7.0, 1e-3);
}

TEST(FilmError, IsUnknownWhereAPixelHasNoSpread) {
  Film film({.width = 8, .height = 8});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      const std::vector<PixelSample> samples = eightSamples(1.0f, 0.1f);
      film.addSamples(x, y, 0, x == 3 && y == 3 ? std::span(samples).first(1) : samples);
    }
  }
  EXPECT_TRUE(std::isinf(estimateBlocks(film)[0].standardError));
  EXPECT_EQ(estimateBlocks(film)[0].degreesOfFreedom, 0.0);
  EXPECT_TRUE(std::isinf(estimateRelMse(film)));
}

TEST(FilmError, RelMseDropsTheWorstThousandth) {
  Film film({.width = 64, .height = 64});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) film.addSamples(x, y, 0, eightSamples(2.0f, 0.5f));
  }
  EXPECT_NEAR(estimateRelMse(film), 0.25 / 4.01, 1e-6);
  // Four of 4096 pixels may be anything.
  Film holes({.width = 64, .height = 64});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      if (y > 0 || x >= 4) holes.addSamples(x, y, 0, eightSamples(2.0f, 0.5f));
    }
  }
  EXPECT_NEAR(estimateRelMse(holes), 0.25 / 4.01, 1e-6);
}

}  // namespace
}  // namespace steradian
