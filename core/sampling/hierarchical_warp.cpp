#include "steradian/core/sampling/hierarchical_warp.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "steradian/core/base/diagnostics.h"

namespace steradian {

namespace {

constexpr std::size_t kMaxSide = 4096;

/// The weights, filled up to a square of a power of two, in double: sums of large weights need not be floats.
std::vector<double> filledUp(std::span<const float> weights, std::size_t columns, std::size_t rows, std::size_t side) {
  std::vector<double> cells(side * side, 0.0);
  double sum = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] >= 0.0f) || std::isinf(weights[i])) {
      throw Error(ErrorKind::Usage, fmt::format("weight {} of a warp is {}: not a finite number >= 0", i, weights[i]));
    }
    sum += static_cast<double>(weights[i]);
    cells[i / columns * side + i % columns] = static_cast<double>(weights[i]);
  }
  if (sum > 0.0) return cells;
  for (std::size_t row = 0; row < rows; ++row) {
    std::fill_n(cells.begin() + static_cast<std::ptrdiff_t>(row * side), columns, 1.0);
  }
  return cells;
}

/// a / (a + b) in steps of 2^-24; 0 or 1 only where the other part is empty. Nothing in both: 1/2.
float shareOf(double a, double b) {
  if (a == 0.0 && b == 0.0) return 0.5f;
  if (b == 0.0) return 1.0f;
  if (a == 0.0) return 0.0f;
  const double steps = std::round(a / (a + b) * 0x1p24);
  return static_cast<float>(std::clamp(steps, 1.0, 0x1p24 - 1.0) * 0x1p-24);
}

}  // namespace

HierarchicalWarp::HierarchicalWarp(std::span<const float> weights, std::size_t columns, std::size_t rows)
    : columns_(static_cast<std::uint32_t>(columns)), rows_(static_cast<std::uint32_t>(rows)) {
  if (columns == 0 || rows == 0 || columns > kMaxSide || rows > kMaxSide || weights.size() != columns * rows) {
    throw Error(ErrorKind::Usage, fmt::format("a warp of {} x {} cells, each at most {}, has {} weights", columns, rows,
                                              kMaxSide, weights.size()));
  }
  std::size_t side = std::bit_ceil(std::max(columns, rows));
  levels_ = std::countr_zero(side);
  std::vector<double> sums = filledUp(weights, columns, rows, side);
  // From the leaves to the root; each level goes before those that are there.
  std::vector<std::vector<float>> levels;
  for (; side > 1; side /= 2) {
    const std::size_t half = side / 2;
    std::vector<double> parents;
    std::vector<float> splits;
    for (std::size_t row = 0; row < half; ++row) {
      for (std::size_t column = 0; column < half; ++column) {
        const double* above = sums.data() + 2 * row * side + 2 * column;
        const double* below = above + side;
        const double top = above[0] + above[1], bottom = below[0] + below[1];
        splits.insert(splits.end(), {shareOf(top, bottom), shareOf(above[0], above[1]), shareOf(below[0], below[1])});
        parents.push_back(top + bottom);
      }
    }
    levels.push_back(std::move(splits));
    sums = std::move(parents);
  }
  for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
    splits_.insert(splits_.end(), level->begin(), level->end());
  }
}

}  // namespace steradian
