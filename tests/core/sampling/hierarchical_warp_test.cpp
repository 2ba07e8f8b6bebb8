#include "steradian/core/sampling/hierarchical_warp.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/samplers/rng.h"
#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using test::unitNumbers;

std::vector<float> randomWeights(std::uint32_t kind, std::size_t count) {
  std::vector<float> weights;
  for (std::size_t i = 0; i < count; ++i) {
    const auto words = randomWords(kind, static_cast<std::uint32_t>(i), 6u, 7u);
    const float x = toUnitFloat<float>(words[0]);
    weights.push_back(words[1] % 3 == 0 ? 0.0f : x * x * x);
  }
  weights[count / 2] += 0.1f;
  return weights;
}

TEST(HierarchicalWarp, DensitiesAreTheWeights) {
  for (const auto& [columns, rows] : {std::pair{1, 1}, std::pair{4, 4}, std::pair{5, 3}, std::pair{1, 9}}) {
    const auto w = static_cast<std::size_t>(columns), h = static_cast<std::size_t>(rows);
    const auto weights = randomWeights(static_cast<std::uint32_t>(columns), w * h);
    const HierarchicalWarp warp(weights, w, h);
    EXPECT_EQ(warp.columns(), w);
    EXPECT_EQ(warp.rows(), h);
    double total = 0.0;
    for (const float x : weights) total += static_cast<double>(x);
    for (std::size_t row = 0; row < h; ++row) {
      for (std::size_t column = 0; column < w; ++column) {
        const Vec2f middle{(static_cast<float>(column) + 0.5f) / static_cast<float>(w),
                           (static_cast<float>(row) + 0.5f) / static_cast<float>(h)};
        const double expected = static_cast<double>(weights[row * w + column]) / total * static_cast<double>(w * h);
        EXPECT_NEAR(warp.pdf(middle), expected, 1e-5 * (1.0 + expected)) << column << ' ' << row;
      }
    }
  }
}

TEST(HierarchicalWarp, SamplesAreWhereTheWeightsAre) {
  for (std::uint32_t kind = 1; kind < 12; ++kind) {
    const std::size_t columns = 1 + kind * 3 % 17, rows = 1 + kind * 5 % 11;
    const auto weights = randomWeights(kind, columns * rows);
    const HierarchicalWarp warp(weights, columns, rows);
    const auto us = unitNumbers(500), vs = unitNumbers(500, 1);
    for (std::size_t i = 0; i < us.size(); ++i) {
      const auto s = warp.sample(Vec2f{us[i], vs[i]});
      EXPECT_TRUE(s.point.x >= 0.0f && s.point.x < 1.0f && s.point.y >= 0.0f && s.point.y < 1.0f);
      ASSERT_TRUE(s.column < columns && s.row < rows);
      EXPECT_GT(weights[s.row * columns + s.column], 0.0f) << us[i] << ' ' << vs[i];
      EXPECT_GT(s.pdf, 0.0f);
    }
  }
}

// What the tree is for: where the weights of a quarter are in proportion to those of another, so are their samples.
TEST(HierarchicalWarp, SplitsThePointLevelByLevel) {
  const HierarchicalWarp warp(std::array{1.0f, 3.0f, 2.0f, 2.0f}, 2, 2);
  EXPECT_FLOAT_EQ(warp.sample(Vec2f{0.125f, 0.25f}).point.x, 0.25f);
  EXPECT_FLOAT_EQ(warp.sample(Vec2f{0.125f, 0.25f}).point.y, 0.25f);
  EXPECT_FLOAT_EQ(warp.sample(Vec2f{0.25f, 0.75f}).point.x, 0.25f);
  EXPECT_FLOAT_EQ(warp.sample(Vec2f{0.25f, 0.75f}).point.y, 0.75f);
  EXPECT_FLOAT_EQ(warp.sample(Vec2f{0.625f, 0.0f}).point.x, 0.75f);
  EXPECT_FLOAT_EQ(warp.sample(Vec2f{0.625f, 0.0f}).pdf, 1.5f);
}

TEST(HierarchicalWarp, EdgeCases) {
  const HierarchicalWarp none(std::vector<float>(6, 0.0f), 3, 2);
  EXPECT_NEAR(none.pdf(Vec2f{0.5f, 0.2f}), 1.0f, 1e-6f);
  EXPECT_NEAR(none.pdf(Vec2f{0.9f, 0.9f}), 1.0f, 1e-6f);
  EXPECT_EQ(none.pdf(Vec2f{1.0f, 0.9f}), 0.0f);
  EXPECT_EQ(none.pdf(Vec2f{0.2f, -0.1f}), 0.0f);
  EXPECT_EQ(none.pdf(Vec2f{std::numeric_limits<float>::quiet_NaN(), 0.5f}), 0.0f);
  // One cell of many, and cells of next to nothing beside heavy ones.
  std::vector<float> single(64, 0.0f);
  single[37] = 1e-30f;
  const HierarchicalWarp point(single, 8, 8);
  const auto s = point.sample(Vec2f{0.5f, 0.5f});
  EXPECT_EQ(s.row * 8 + s.column, 37u);
  EXPECT_FLOAT_EQ(s.pdf, 64.0f);
  const HierarchicalWarp uneven(std::array{3e38f, 1e-45f, 3e38f, 3e38f}, 2, 2);
  EXPECT_GT(uneven.pdf(Vec2f{0.75f, 0.25f}), 0.0f);
  EXPECT_EQ(uneven.sample(Vec2f{kOneMinusEpsilon, 0.1f}).column, 1u);
}

TEST(HierarchicalWarp, RejectsBadInput) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(HierarchicalWarp(std::span<const float>{}, 0, 0), Error);
  EXPECT_THROW(HierarchicalWarp(std::array{1.0f, 2.0f, 3.0f}, 2, 2), Error);
  EXPECT_THROW(HierarchicalWarp(std::vector<float>(4097, 1.0f), 4097, 1), Error);
  for (const float weight : {-1.0f, nan, kInfinity}) {
    EXPECT_THROW(HierarchicalWarp(std::array{1.0f, weight}, 2, 1), Error) << weight;
  }
}

}  // namespace
}  // namespace steradian
