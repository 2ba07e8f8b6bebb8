#include "steradian/core/sampling/hierarchical_warp.h"

#include <gtest/gtest.h>

#include "steradian/tests/support/proof.h"

namespace steradian {
namespace {

using namespace test;

TEST(HierarchicalWarpStatistics, RandomTables) {
  for (const auto& [columns, rows] : {std::pair{1u, 1u}, std::pair{8u, 8u}, std::pair{5u, 3u}, std::pair{1u, 6u}}) {
    std::vector<float> weights;
    for (std::uint32_t i = 0; i < columns * rows; ++i) {
      weights.push_back(i % 4 == 1 ? 0.0f : toUnitFloat<float>(mixBits(i + columns)));
    }
    CheckOptions options;
    options.columns = static_cast<int>(columns) * 2;
    options.rows = static_cast<int>(rows) * 2;
    options.edgeShare = 1e-4;  // samples on the edge of a cell
    options.inverseTolerance = 5e-6;
    EXPECT_TRUE(prove(HierarchicalWarp(weights, columns, rows), options)) << columns << " x " << rows;
  }
}

TEST(HierarchicalWarpStatistics, DeepTablesKeepTheirDensity) {
  // A peak on a faint ground: 2^14 cells of which a few hold nearly everything, counted in the squares of 8 x 8.
  constexpr std::uint32_t side = 128;
  std::vector<float> weights;
  for (std::uint32_t i = 0; i < side * side; ++i) {
    const std::uint32_t column = i % side, row = i / side;
    const float dx = static_cast<float>(column) - 40.0f, dy = static_cast<float>(row) - 77.0f;
    weights.push_back(1e-3f + exponential(-0.05f * (dx * dx + dy * dy)));
  }
  const HierarchicalWarp warp(weights, side, side);
  std::vector<double> observed(256, 0.0), expected(256, 0.0);
  constexpr int samples = 200000;
  double total = 0.0;
  for (const float w : weights) total += static_cast<double>(w);
  for (std::uint32_t i = 0; i < side * side; ++i) {
    expected[i / side / 8 * 16 + i % side / 8] += samples * static_cast<double>(weights[i]) / total;
  }
  for (std::uint32_t i = 0; i < samples; ++i) {
    const auto words = randomWords(i, 1u, 2u, 3u);
    const auto s = warp.sample(Vec2f{toUnitFloat<float>(words[0]), toUnitFloat<float>(words[1])});
    observed[s.row / 8 * 16 + s.column / 8] += 1.0;
  }
  EXPECT_GT(chiSquareTest(observed, expected).pValue, suiteLevel());
}

}  // namespace
}  // namespace steradian
