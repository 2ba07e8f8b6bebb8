#include "steradian/core/sampling/distribution.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "steradian/core/base/diagnostics.h"
#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using test::unitNumbers;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// Weights of many sizes, a third of them zero; `kind` 0 is the single bin.
std::vector<float> randomWeights(std::uint32_t kind) {
  const std::size_t count = kind == 0 ? 1 : 1 + mixBits(kind) % 300;
  std::vector<float> weights;
  for (std::size_t i = 0; i < count; ++i) {
    const auto words = randomWords(kind, static_cast<std::uint32_t>(i), 6u, 7u);
    const float x = toUnitFloat<float>(words[0]);
    weights.push_back(words[1] % 3 == 0 ? 0.0f : x * x * x);
  }
  weights[count / 2] += 0.1f;
  return weights;
}

TEST(PiecewiseConstant1D, ProbabilitiesAreTheWeights) {
  for (std::uint32_t kind = 0; kind < 30; ++kind) {
    const auto weights = randomWeights(kind);
    const PiecewiseConstant1D d(weights, -2.0f, 3.0f);
    double total = 0.0, sum = 0.0;
    for (const float w : weights) total += w;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      EXPECT_NEAR(d.probability(i), weights[i] / total, 1.2e-7) << kind;
      EXPECT_EQ(d.probability(i) == 0.0f, weights[i] == 0.0f);
      sum += d.probability(i);
    }
    EXPECT_EQ(sum, 1.0) << "exactly: steps of 2^-24";
  }
}

TEST(PiecewiseConstant1D, SamplesInvertAndHaveTheirDensity) {
  for (std::uint32_t kind = 0; kind < 30; ++kind) {
    const auto weights = randomWeights(kind);
    const PiecewiseConstant1D d(weights);
    for (const float u : unitNumbers(300)) {
      const auto s = d.sample(u);
      EXPECT_TRUE(s.x >= 0.0f && s.x < 1.0f);
      ASSERT_LT(s.bin, weights.size());
      EXPECT_GT(weights[s.bin], 0.0f);
      EXPECT_FLOAT_EQ(s.pdf, d.probability(s.bin) * static_cast<float>(weights.size()));
      // The position in the bin is rounded: near an edge it may fall into the neighbouring bin.
      const float inside = s.x * static_cast<float>(weights.size()) - static_cast<float>(s.bin);
      if (inside > 1e-4f && inside < 0.9999f) {
        EXPECT_EQ(d.pdf(s.x), s.pdf) << kind << ' ' << u;
        EXPECT_NEAR(d.invert(s.x), u, 1e-6f * (1.0f + s.pdf));
      }
    }
  }
}

TEST(PiecewiseConstant1D, OtherDomains) {
  const PiecewiseConstant1D d(std::array{1.0f, 0.0f, 3.0f}, 2.0f, 8.0f);
  EXPECT_FLOAT_EQ(d.pdf(3.0f), 0.125f);
  EXPECT_EQ(d.pdf(5.0f), 0.0f);
  EXPECT_FLOAT_EQ(d.pdf(7.9f), 0.375f);
  EXPECT_EQ(d.pdf(1.9f), 0.0f);
  EXPECT_EQ(d.pdf(8.0f), 0.0f);
  EXPECT_EQ(d.pdf(kNan), 0.0f);
  EXPECT_FLOAT_EQ(d.sample(0.125f).x, 3.0f);
  EXPECT_FLOAT_EQ(d.sample(0.625f).x, 7.0f);
  EXPECT_FLOAT_EQ(d.invert(7.0f), 0.625f);
  EXPECT_EQ(d.invert(-5.0f), 0.0f);
  EXPECT_EQ(d.invert(50.0f), kOneMinusEpsilon);
}

TEST(PiecewiseConstant1D, EdgeCases) {
  // All zero: uniform.
  const PiecewiseConstant1D none(std::array{0.0f, 0.0f, 0.0f, 0.0f});
  for (const float x : {0.1f, 0.3f, 0.6f, 0.9f}) EXPECT_EQ(none.pdf(x), 1.0f);
  // Zeros at both ends are never chosen, nor is the end itself.
  const PiecewiseConstant1D middle(std::array{0.0f, 5.0f, 0.0f});
  EXPECT_EQ(middle.sample(0.0f).bin, 1u);
  EXPECT_EQ(middle.sample(kOneMinusEpsilon).bin, 1u);
  // A bin of next to no weight keeps one step, however heavy the others are.
  const PiecewiseConstant1D uneven(std::array{1e-30f, 3e38f, 1e-30f, 3e38f, 1e-45f});
  for (const std::size_t i : {0u, 2u, 4u}) EXPECT_EQ(uneven.probability(i), 0x1p-24f);
  EXPECT_EQ(uneven.sample(0.0f).bin, 0u);
  EXPECT_EQ(uneven.sample(kOneMinusEpsilon).bin, 4u);
}

TEST(PiecewiseConstant1D, SamplesOfAHeavyBinStayInIt) {
  // 4096 bins of one step each, but for number 4000: the last number of that one must not be rounded up to 4001.
  std::vector<float> weights(4096, 1.0f);
  weights[4000] = 1e12f;
  const PiecewiseConstant1D d(weights);
  const auto s = d.sample(1.0f - 96 * 0x1p-24f);
  EXPECT_EQ(s.bin, 4000u);
  EXPECT_LT(s.x, 4001.0f / 4096.0f);
  EXPECT_EQ(d.pdf(s.x), s.pdf);
  const PiecewiseConstant2D square(weights, 4096, 1);
  const auto p = square.sample(Vec2f{1.0f - 96 * 0x1p-24f, 0.5f});
  EXPECT_EQ(p.column, 4000u);
  EXPECT_EQ(square.pdf(p.point), p.pdf);
}

TEST(Distribution, RejectsBadInput) {
  EXPECT_THROW(PiecewiseConstant1D(std::span<const float>{}), Error);
  EXPECT_THROW(PiecewiseConstant1D(std::array{1.0f, -1.0f}), Error);
  EXPECT_THROW(PiecewiseConstant1D(std::array{1.0f, kNan}), Error);
  EXPECT_THROW(PiecewiseConstant1D(std::array{kInfinity}), Error);
  EXPECT_THROW(PiecewiseConstant1D(std::array{1.0f}, 2.0f, 2.0f), Error);
  EXPECT_THROW(PiecewiseConstant1D(std::array{1.0f}, 0.0f, kInfinity), Error);
  EXPECT_THROW(PiecewiseConstant1D(std::vector<float>((1u << 22) + 1, 1.0f)), Error);
  EXPECT_THROW(PiecewiseConstant2D(std::array{1.0f, 2.0f, 3.0f}, 2, 2), Error);
  EXPECT_THROW(PiecewiseConstant2D(std::span<const float>{}, 0, 0), Error);
  EXPECT_THROW(PiecewiseConstant2D(std::array{1.0f, 2.0f, 3.0f, -1.0f}, 2, 2), Error);
  EXPECT_THROW(AliasTable(std::span<const float>{}), Error);
  EXPECT_THROW(AliasTable(std::array{1.0f, -1e-30f}), Error);
  try {
    const PiecewiseConstant1D negative(std::array{1.0f, -2.0f});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::Usage);
    EXPECT_NE(std::string(e.what()).find("-2"), std::string::npos);
  }
}

TEST(PiecewiseConstant2D, IsMarginalTimesConditional) {
  // Rows of 4: the second is empty.
  const std::array<float, 12> weights{1.0f, 0.0f, 2.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 12.0f};
  const PiecewiseConstant2D d(weights, 4, 3);
  EXPECT_EQ(d.columns(), 4u);
  EXPECT_EQ(d.rows(), 3u);
  const auto density = [&](float x, float y) { return d.pdf(Vec2f{x, y}); };
  EXPECT_NEAR(density(0.1f, 0.1f), 1.0f / 16.0f * 12.0f, 2e-6f);
  EXPECT_EQ(density(0.3f, 0.1f), 0.0f);
  EXPECT_NEAR(density(0.6f, 0.2f), 2.0f / 16.0f * 12.0f, 2e-6f);
  EXPECT_EQ(density(0.6f, 0.5f), 0.0f);
  EXPECT_NEAR(density(0.9f, 0.9f), 12.0f / 16.0f * 12.0f, 1e-5f);
  EXPECT_EQ(density(1.0f, 0.9f), 0.0f);
  EXPECT_EQ(density(-0.1f, 0.9f), 0.0f);
  EXPECT_EQ(density(0.9f, 1.0f), 0.0f);
}

TEST(PiecewiseConstant2D, SamplesInvertAndHaveTheirDensity) {
  const auto weights = randomWeights(8);
  for (const std::size_t columns : {std::size_t{1}, std::size_t{7}, std::size_t{16}}) {
    const std::size_t rows = weights.size() / columns;
    const std::span<const float> used(weights.data(), rows * columns);
    const PiecewiseConstant2D d(used, columns, rows);
    const auto us = unitNumbers(500), vs = unitNumbers(500, 1);
    for (std::size_t i = 0; i < us.size(); ++i) {
      const auto s = d.sample(Vec2f{us[i], vs[i]});
      EXPECT_TRUE(s.point.x >= 0.0f && s.point.x < 1.0f && s.point.y >= 0.0f && s.point.y < 1.0f);
      EXPECT_GT(used[s.row * columns + s.column], 0.0f);
      const float x = s.point.x * static_cast<float>(columns) - static_cast<float>(s.column);
      const float y = s.point.y * static_cast<float>(rows) - static_cast<float>(s.row);
      if (x < 1e-4f || x > 0.9999f || y < 1e-4f || y > 0.9999f) continue;
      EXPECT_FLOAT_EQ(d.pdf(s.point), s.pdf);
      const Vec2f back = d.invert(s.point);
      EXPECT_NEAR(back.x, us[i], 1e-5f);
      EXPECT_NEAR(back.y, vs[i], 1e-5f);
    }
  }
}

TEST(PiecewiseConstant2D, ARowOfTinyWeightsKeepsItsProbability) {
  // The ratio of the rows' sums is no float.
  const PiecewiseConstant2D d(std::array{3e38f, 3e38f, 0.0f, 1e-45f}, 2, 2);
  EXPECT_GT(d.pdf(Vec2f{0.75f, 0.75f}), 0.0f);
  EXPECT_EQ(d.pdf(Vec2f{0.25f, 0.75f}), 0.0f);
  EXPECT_EQ(d.sample(Vec2f{0.5f, kOneMinusEpsilon}).row, 1u);
}

TEST(PiecewiseConstant2D, AllZeroIsUniform) {
  const PiecewiseConstant2D d(std::vector<float>(6, 0.0f), 3, 2);
  EXPECT_NEAR(d.pdf(Vec2f{0.5f, 0.2f}), 1.0f, 1e-6f);
  EXPECT_NEAR(d.pdf(Vec2f{0.9f, 0.9f}), 1.0f, 1e-6f);
}

TEST(AliasTable, ProbabilitiesAreTheWeights) {
  for (std::uint32_t kind = 0; kind < 30; ++kind) {
    const auto weights = randomWeights(kind);
    const AliasTable table(weights);
    ASSERT_EQ(table.size(), weights.size());
    double total = 0.0;
    for (const float w : weights) total += w;
    for (std::size_t i = 0; i < weights.size(); ++i) EXPECT_NEAR(table.probability(i), weights[i] / total, 1.2e-7);
    for (const float u : unitNumbers(300, kind)) {
      const auto s = table.sample(u);
      ASSERT_LT(s.index, weights.size());
      EXPECT_GT(weights[s.index], 0.0f);
      EXPECT_EQ(s.probability, table.probability(s.index));
      EXPECT_TRUE(s.rest >= 0.0f && s.rest < 1.0f);
    }
  }
  const AliasTable uniform(std::array{0.0f, 0.0f, 0.0f});
  for (const std::size_t i : {0u, 1u, 2u}) EXPECT_NEAR(uniform.probability(i), 1.0f / 3.0f, 1e-7f);
}

TEST(Distribution, BinsAndRestsOfLanesAgreeWithScalars) {
  const auto us = unitNumbers(256);
  const auto weights = randomWeights(8);
  const PiecewiseConstant1D line(weights);
  const AliasTable table(weights);
  EXPECT_TRUE(test::sameInLanes<8>([&](auto u) { return line.sample(u).bin; }, us));
  EXPECT_TRUE(test::sameInLanes<8>([&](auto u) { return table.sample(u).rest; }, us));
}

}  // namespace
}  // namespace steradian
