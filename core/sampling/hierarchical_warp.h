#pragma once
/// Hierarchical sample warping (Clarberg, Jarosz, Akenine-Moeller & Jensen 2005, "Wavelet importance sampling:
/// efficiently evaluating products of complex functions").
#include <cstdint>
#include <span>
#include <vector>

#include "steradian/core/sampling/distribution.h"

namespace STERADIAN_API steradian {

/// A density on [0, 1)^2 that is constant in each cell of a grid. A quad-tree of sums moves a point level by level: it
/// goes to the upper or lower half, then to the left or right quarter, and is stretched to fill what it fell into.
/// Neighbouring points stay neighbours in both directions, while the marginal and conditional of `PiecewiseConstant2D`
/// shear rows against each other; and when one cell changes, only the splits above it do.
///
/// Built from weights >= 0 of any sum; all weights zero: uniform. A side that is no power of two is filled up with
/// empty cells. Each split uses up some of the 24 bits of a random number. The smallest probability of a half is 2^-24,
/// unless it is 0. Lookups are lane-generic, read-only and never throw.
class HierarchicalWarp {
 public:
  template <class F>
  struct Sample {
    Vec2<F> point;
    F pdf;  ///< per unit of area
    UintOf<F> column, row;
  };

  /// columns * rows weights, row by row (y = 0 first); each of columns and rows is at most 2^12. Throws `Error` (kind
  /// Usage) for another number of weights, none, or one that is negative or not finite.
  HierarchicalWarp(std::span<const float> weights, std::size_t columns, std::size_t rows);

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }

  template <class F>
  Sample<F> sample(Vec2<F> u) const {
    UintOf<F> column(0u), row(0u);
    F density(scale());
    for (int level = 0; level < levels_; ++level) {
      const Node<F> node = nodeAt<F>(level, column, row);
      const MaskOf<F> below = u.y >= node.top;
      const F left = select(below, node.leftBelow, node.leftAbove);
      const MaskOf<F> beside = u.x >= left;
      density *= node.share(below, beside);
      u = {stretched(u.x, left, beside), stretched(u.y, node.top, below)};
      column = (column << 1) + bit<F>(beside);
      row = (row << 1) + bit<F>(below);
    }
    const F x = detail::positionInBins(column, u.x) / F(static_cast<float>(columns_));
    const F y = detail::positionInBins(row, u.y) / F(static_cast<float>(rows_));
    return {{minimum(x, F(kOneMinusEpsilon)), minimum(y, F(kOneMinusEpsilon))}, density, column, row};
  }
  /// 0 outside of the square.
  template <class F>
  F pdf(Vec2<F> p) const {
    const MaskOf<F> inside = (p.x >= F(0.0f)) & (p.x < F(1.0f)) & (p.y >= F(0.0f)) & (p.y < F(1.0f));
    const UintOf<F> column = detail::binOf(p.x * F(static_cast<float>(columns_)), columns_);
    const UintOf<F> row = detail::binOf(p.y * F(static_cast<float>(rows_)), rows_);
    F density(scale());
    for (int level = 0; level < levels_; ++level) {
      const int rest = levels_ - level;
      const Node<F> node = nodeAt<F>(level, column >> rest, row >> rest);
      density *= node.share(isOdd<F>(row >> (rest - 1)), isOdd<F>(column >> (rest - 1)));
    }
    return select(inside, density, F(0.0f));
  }
  /// Inverse of sample(): the random numbers that give p; coordinates outside count as the nearer edge.
  template <class F>
  Vec2<F> invert(Vec2<F> p) const {
    const F x = clamp(p.x, F(0.0f), F(1.0f)) * F(static_cast<float>(columns_));
    const F y = clamp(p.y, F(0.0f), F(1.0f)) * F(static_cast<float>(rows_));
    const UintOf<F> column = detail::binOf(x, columns_), row = detail::binOf(y, rows_);
    Vec2<F> u{x - toFloat(toSigned(column)), y - toFloat(toSigned(row))};
    for (int level = levels_; level-- > 0;) {
      const int rest = levels_ - level;
      const Node<F> node = nodeAt<F>(level, column >> rest, row >> rest);
      const MaskOf<F> below = isOdd<F>(row >> (rest - 1)), beside = isOdd<F>(column >> (rest - 1));
      const F left = select(below, node.leftBelow, node.leftAbove);
      u = {shrunk(u.x, left, beside), shrunk(u.y, node.top, below)};
    }
    return {minimum(u.x, F(kOneMinusEpsilon)), minimum(u.y, F(kOneMinusEpsilon))};
  }

 private:
  /// How the probability of a square splits: the upper half (smaller y), and the left quarter of each half.
  template <class F>
  struct Node {
    F top, leftAbove, leftBelow;

    F share(MaskOf<F> below, MaskOf<F> beside) const {
      const F left = select(below, leftBelow, leftAbove);
      return select(below, F(1.0f) - top, top) * select(beside, F(1.0f) - left, left);
    }
  };

  template <class F>
  Node<F> nodeAt(int level, UintOf<F> column, UintOf<F> row) const {
    // The levels before this one hold (4^level - 1) / 3 nodes.
    const std::uint32_t before = ((1u << (2 * level)) - 1u) / 3u;
    const UintOf<F> at = (UintOf<F>(before) + (row << level) + column) * UintOf<F>(3u);
    const float* splits = splits_.data();
    return {gather(splits, at), gather(splits + 1, at), gather(splits + 2, at)};
  }
  /// The cells per unit of area.
  float scale() const { return static_cast<float>(columns_) * static_cast<float>(rows_); }
  template <class F>
  static MaskOf<F> isOdd(UintOf<F> x) {
    return (x & UintOf<F>(1u)) != UintOf<F>(0u);
  }
  template <class F>
  static UintOf<F> bit(MaskOf<F> m) {
    return select(m, UintOf<F>(1u), UintOf<F>(0u));
  }
  /// From [0, split) or [split, 1) to [0, 1), and back.
  template <class F>
  static F stretched(F u, F split, MaskOf<F> second) {
    const F low = select(second, split, F(0.0f)), width = select(second, F(1.0f) - split, split);
    return minimum((u - low) / width, F(kOneMinusEpsilon));
  }
  template <class F>
  static F shrunk(F u, F split, MaskOf<F> second) {
    return select(second, split + u * (F(1.0f) - split), u * split);
  }

  std::uint32_t columns_, rows_;
  int levels_ = 0;
  std::vector<float> splits_;  ///< three per node, level by level from the root, row by row
};

}  // namespace steradian
