#include <gtest/gtest.h>

#include <array>

#include "steradian/core/samplers/rng.h"
#include "steradian/core/sampling/distribution.h"
#include "steradian/tests/support/proof.h"

namespace steradian {
namespace {

using namespace test;

/// Every random number that a sampler can give, once.
template <class Visitor>
void forEachUnitFloat(Visitor&& visit) {
  for (std::uint32_t i = 0; i < (1u << 24); ++i) visit(toUnitFloat<float>(i << 8));
}

TEST(DistributionExhaustive, TablesDrawExactlyTheirProbabilities) {
  const std::array<float, 7> weights{0.3f, 0.0f, 1e-12f, 2.0f, 0.7f, 0.0f, 0.11f};
  const PiecewiseConstant1D line(weights);
  const AliasTable table(weights);
  std::array<std::uint32_t, 7> fromLine{}, fromTable{};
  std::array<double, 7> rest{};
  forEachUnitFloat([&](float u) {
    ++fromLine[line.sample(u).bin];
    const auto s = table.sample(u);
    ++fromTable[s.index];
    rest[s.index] += s.rest;
  });
  for (std::size_t i = 0; i < weights.size(); ++i) {
    EXPECT_EQ(static_cast<float>(fromLine[i]) * 0x1p-24f, line.probability(i)) << i;
    EXPECT_EQ(static_cast<float>(fromTable[i]) * 0x1p-24f, table.probability(i)) << i;
    // What remains of the random number is uniform too.
    if (weights[i] > 0.01f) {
      EXPECT_NEAR(rest[i] / fromTable[i], 0.5, 1e-5) << i;
    }
  }
}

TEST(DistributionStatistics, RemainderOfTheAliasTableIsUniform) {
  const AliasTable table(std::array{0.3f, 0.1f, 2.0f});
  std::array<std::vector<double>, 3> counts;
  for (auto& c : counts) c.assign(32, 0.0);
  for (std::uint32_t i = 0; i < 200000; ++i) {
    const auto s = table.sample(toUnitFloat<float>(randomWords(i, 1u, 2u, 3u)[0]));
    counts[s.index][static_cast<std::size_t>(s.rest * 32.0f)] += 1.0;
  }
  for (const auto& c : counts) EXPECT_GT(chiSquareUniform(c).pValue, suiteLevel());
}

/// Weights of many sizes, a quarter of them zero; a single one for `count` 1.
std::vector<float> randomWeights(std::uint32_t count) {
  std::vector<float> weights;
  for (std::uint32_t i = 0; i < count; ++i) {
    weights.push_back(i % 4 == 1 ? 0.0f : toUnitFloat<float>(mixBits(i + 100 * (count % 15))));
  }
  return weights;
}

TEST(DistributionStatistics, Lines) {
  for (const std::uint32_t bins : {1u, 7u, 48u, 300u}) {
    CheckOptions options;
    options.domain = {-1.0, 2.0, 0.0, 1.0};
    options.edgeShare = 1e-3;  // samples on the edge of a bin
    options.inverseTolerance = 1e-5;
    EXPECT_TRUE(prove(PiecewiseConstant1D(randomWeights(bins), -1.0f, 2.0f), options)) << bins;
  }
}

TEST(DistributionStatistics, Squares) {
  for (const auto& [columns, rows] : {std::pair{1u, 1u}, std::pair{5u, 3u}, std::pair{1u, 6u}}) {
    CheckOptions options;
    options.columns = static_cast<int>(columns) * 2;
    options.rows = static_cast<int>(rows) * 3;
    options.edgeShare = 1e-4;  // samples on the edge of a cell
    options.inverseTolerance = 1e-5;
    EXPECT_TRUE(prove(PiecewiseConstant2D(randomWeights(columns * rows), columns, rows), options));
  }
}

TEST(DistributionStatistics, ATransposedSquareIsRejected) {
  const PiecewiseConstant2D d(randomWeights(15), 5, 3);
  CheckOptions options;
  options.columns = 10;
  options.rows = 9;
  options.edgeShare = 1e-4;
  EXPECT_FALSE(checkPlaneSampler(
      [&](float, Vec2f u) {
        const auto s = d.sample(Vec2f{u.y, u.x});
        return PlaneSample{{s.point.y, s.point.x}, s.pdf};
      },
      [&](Vec2f p) { return d.pdf(p); }, options));
}

TEST(DistributionStatistics, AliasTables) {
  for (const std::uint32_t entries : {1u, 2u, 7u, 100u}) {
    EXPECT_TRUE(prove(AliasTable(randomWeights(entries)), {.inverse = false})) << entries;
  }
}

}  // namespace
}  // namespace steradian
