#include "steradian/core/image/image_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

Image constant(int width, int height, float r, float g, float b) {
  Image image(width, height, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    image.values()[3 * i] = r;
    image.values()[3 * i + 1] = g;
    image.values()[3 * i + 2] = b;
  }
  return image;
}

/// A grey picture, brighter to the right, with independent noise per pixel, and its standard errors as estimated from
/// `parts` estimates of each pixel (0: the true ones).
struct Noisy {
  Image image;
  Image stdErr;
};

Noisy render(std::mt19937& random, int side, double noise, double bias, int parts) {
  std::normal_distribution<double> normal;
  Noisy result{Image(side, side, {"R", "G", "B"}), Image(side, side, {"StdErr.Y"})};
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double mean = 0.2 + static_cast<double>(x) / side;
      const double sigma = noise * mean;  // of the mean of all parts
      double value = normal(random), spread = 1.0;
      if (parts > 0) {
        // Mean and spread of the parts are independent; the spread is chi-square with parts - 1 degrees of freedom.
        spread = std::chi_squared_distribution<double>(parts - 1)(random) / (parts - 1);
      }
      value = mean * (1.0 + bias) + sigma * value;
      for (int c = 0; c < 3; ++c) result.image.at(x, y, c) = static_cast<float>(value);
      result.stdErr.at(x, y, 0) = static_cast<float>(sigma * std::sqrt(spread));
    }
  }
  return result;
}

TEST(ImageMetrics, RelMseOfAConstantOffset) {
  const Image reference = constant(20, 10, 0.5f, 1.0f, 0.0f), x = constant(20, 10, 0.6f, 1.2f, 0.1f);
  const double expected = (0.01 / 0.26 + 0.04 / 1.01 + 0.01 / 0.01) / 3.0;
  EXPECT_NEAR(relMSE(x, reference), expected, 1e-6);
  EXPECT_NEAR(mse(x, reference), (0.01 + 0.04 + 0.01) / 3.0, 1e-7);
  EXPECT_NEAR(maxAbsDifference(x, reference), 0.2, 1e-7);
  EXPECT_NEAR(channelMeans(x)[1], 1.2, 1e-7);
  const Image stdErr = constant(20, 10, 0.1f, 0.0f, 0.05f);
  EXPECT_NEAR(relMSE(x, reference, &stdErr), expected - (0.01 / 0.26 + 0.0025 / 0.01) / 3.0, 1e-6);
  EXPECT_NEAR(relativeErrorMap(x, reference).at(3, 4, 0), expected, 1e-6);
}

TEST(ImageMetrics, RelMseDropsOnePixelInAThousand) {
  const Image reference = constant(100, 20, 1.0f, 1.0f, 1.0f);
  Image x = constant(100, 20, 1.1f, 1.1f, 1.1f);
  const double clean = relMSE(x, reference);
  x.at(5, 5, 0) = 1000.0f;
  x.at(99, 19, 2) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NEAR(relMSE(x, reference), clean, 1e-12);
  EXPECT_EQ(countNonFinite(x), 1u);
  EXPECT_TRUE(std::isinf(maxAbsDifference(x, reference)));
  x.at(6, 5, 0) = 1000.0f;
  EXPECT_GT(relMSE(x, reference), 100.0);
  // The errors of the two that are dropped are not subtracted either.
  const Image none = constant(100, 20, 0.0f, 0.0f, 0.0f);
  EXPECT_EQ(relMSE(x, reference, &none), relMSE(x, reference));
}

TEST(ImageMetrics, DifferentShapesAreRefused) {
  const Image a = constant(4, 4, 1, 1, 1), b = constant(4, 5, 1, 1, 1);
  EXPECT_THROW(relMSE(a, b), Error);
  EXPECT_THROW(mse(a, Image(4, 4, {"R", "G", "B"}, ImageWindow{1, 0, 8, 8})), Error);
  EXPECT_THROW(mse(a, Image(4, 4, {"X", "Q"})), Error);
  EXPECT_THROW(zTest(a, nullptr, a, nullptr), Error);
  EXPECT_THROW(zTest(a, &a, a, &a, {.blockSize = 0}), Error);
}

TEST(ZTest, IdenticalImagesPass) {
  std::mt19937 random(1);
  const Noisy a = render(random, 50, 0.05, 0.0, 8);
  const ZTestResult result = zTest(a.image, &a.stdErr, a.image, &a.stdErr);
  EXPECT_TRUE(result.passed);
  EXPECT_EQ(result.columns, 7);
  EXPECT_EQ(result.blockCount(), 49);
  EXPECT_EQ(result.pValue, 1.0);
  EXPECT_EQ(result.worstZ, 0.0);
}

/// 400 pairs of pictures that differ in noise only: the rate of failures is alpha. Four standard deviations of the
/// binomial distribution are allowed.
TEST(ZTest, NoiseFailsAtTheNominalRate) {
  constexpr int trials = 400;
  constexpr double alpha = 0.1;
  for (const int parts : {0, 8}) {
    std::mt19937 random(7);
    const double dof = parts == 0 ? std::numeric_limits<double>::infinity() : parts - 1;
    const ZTestSettings settings{
        .alpha = alpha, .roundOffFloor = 0.0, .degreesOfFreedomA = dof, .degreesOfFreedomB = dof};
    int failures = 0;
    for (int i = 0; i < trials; ++i) {
      const Noisy a = render(random, 32, 0.05, 0.0, parts), b = render(random, 32, 0.08, 0.0, parts);
      failures += zTest(a.image, &a.stdErr, b.image, &b.stdErr, settings).passed ? 0 : 1;
    }
    const double tolerance = 4.0 * std::sqrt(alpha * (1.0 - alpha) / trials);
    EXPECT_NEAR(failures / static_cast<double>(trials), alpha, tolerance) << parts;
  }
}

/// Blocks of 2 x 2 correlated pixels, as if they shared all of their paths.
TEST(ZTest, CorrelatedPixelsAreNoReasonToFail) {
  constexpr int trials = 100;
  std::mt19937 random(11);
  int taken = 0, ignored = 0;
  for (int i = 0; i < trials; ++i) {
    Noisy a = render(random, 32, 0.05, 0.0, 8), b = render(random, 32, 0.05, 0.0, 8);
    for (Noisy* one : {&a, &b}) {
      for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 32; ++x) {
          for (int c = 0; c < one->image.channelCount(); ++c) {
            one->image.at(x, y, c) = one->image.at(x & ~1, y & ~1, c);
          }
          for (int c = 0; c < one->stdErr.channelCount(); ++c) {
            one->stdErr.at(x, y, c) = one->stdErr.at(x & ~1, y & ~1, c);
          }
        }
      }
    }
    ZTestSettings settings{.alpha = 0.1, .roundOffFloor = 0.0};
    ignored += zTest(a.image, &a.stdErr, b.image, &b.stdErr, settings).passed ? 0 : 1;
    settings.correlatedPixelsA = settings.correlatedPixelsB = 4.0;
    taken += zTest(a.image, &a.stdErr, b.image, &b.stdErr, settings).passed ? 0 : 1;
  }
  EXPECT_LE(taken, 22);
  EXPECT_GE(ignored, 50);
}

/// The z of blocks of one pixel follows Student's t with 7 degrees of freedom: taken as normal, it fails far too often.
TEST(ZTest, DegreesOfFreedomMatter) {
  std::mt19937 random(3);
  const Noisy a = render(random, 64, 0.05, 0.0, 8);
  Image exact(64, 64, {"R", "G", "B"});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      for (int c = 0; c < 3; ++c) exact.at(x, y, c) = 0.2f + static_cast<float>(x) / 64.0f;
    }
  }
  ZTestSettings settings{.blockSize = 1, .roundOffFloor = 0.0};
  EXPECT_TRUE(zTest(a.image, &a.stdErr, exact, nullptr, settings).passed);
  settings.degreesOfFreedomA = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(zTest(a.image, &a.stdErr, exact, nullptr, settings).passed);
}

TEST(ZTest, FindsABiasOfOnePercent) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    std::mt19937 random(seed);
    const Noisy a = render(random, 128, 0.03, 0.0, 8), b = render(random, 128, 0.03, 0.01, 8);
    const ZTestResult result = zTest(a.image, &a.stdErr, b.image, &b.stdErr);
    EXPECT_FALSE(result.passed) << seed;
    EXPECT_LT(result.imageZ, -4.0) << seed;
  }
}

TEST(ZTest, FindsOneWrongBlockAndShowsIt) {
  std::mt19937 random(5);
  const Noisy a = render(random, 64, 0.02, 0.0, 8);
  Noisy b = render(random, 64, 0.02, 0.0, 8);
  for (int y = 16; y < 24; ++y) {
    for (int x = 40; x < 48; ++x) b.image.at(x, y, 1) *= 1.05f;
  }
  const ZTestResult result = zTest(a.image, &a.stdErr, b.image, &b.stdErr);
  EXPECT_FALSE(result.passed);
  EXPECT_EQ(result.worstBlock, 2 * 8 + 5);
  EXPECT_GT(std::abs(result.worstZ), result.threshold);
  const Image map = result.map(64, 64, 8);
  EXPECT_NEAR(map.at(47, 16, 0), std::abs(result.worstZ), 1e-4);
  EXPECT_LT(map.at(48, 16, 0), result.threshold);
}

TEST(ZTest, RoundOffFloorForgivesSmallDifferences) {
  const Image a = constant(16, 16, 1.0f, 1.0f, 1.0f), b = constant(16, 16, 1.001f, 1.001f, 1.001f);
  const Image tiny = constant(16, 16, 1e-7f, 1e-7f, 1e-7f);
  EXPECT_TRUE(zTest(a, &tiny, b, &tiny).passed);
  EXPECT_FALSE(zTest(a, &tiny, b, &tiny, {.roundOffFloor = 0.0}).passed);
  const Image nan = constant(16, 16, std::numeric_limits<float>::quiet_NaN(), 1.0f, 1.0f);
  EXPECT_FALSE(zTest(a, &tiny, nan, &tiny).passed);
  const float unknown = std::numeric_limits<float>::infinity();
  const Image unknownErrors = constant(16, 16, unknown, unknown, unknown);
  EXPECT_TRUE(zTest(a, &unknownErrors, constant(16, 16, 2, 2, 2), nullptr).passed);
}

}  // namespace
}  // namespace steradian
