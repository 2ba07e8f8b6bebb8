#pragma once
/// Tabulated distributions: piecewise-constant densities in one and two dimensions (inverse of the cumulative sum), and
/// the alias method.
///
/// Built from weights >= 0 of any sum; all weights zero: uniform. An empty table, a negative, infinite or NaN weight
/// throws `Error` (kind Usage). Lookups are lane-generic, read-only and never throw.
///
/// Cumulative sums are whole multiples of 2^-24, the grid of the random numbers, and every bin of positive weight gets
/// at least one of them: densities are exact for the numbers that samplers give, and no support is ever lost. A table
/// has at most 2^22 bins.
#include <cstdint>
#include <span>
#include <vector>

#include "steradian/core/math/vec.h"

namespace STERADIAN_API steradian {

namespace detail {
/// Cumulative sums of the weights in steps of 2^-24, from 0 to 1: one more than there are weights. Throws.
std::vector<float> cumulative(std::span<const float> weights);
/// The last bin i with cumulative[offset + i] <= u, which never is one of probability 0; u < 1. `bins` bins.
template <class F>
UintOf<F> findBin(const float* cumulative, UintOf<F> offset, std::uint32_t bins, F u) {
  UintOf<F> first = offset;
  for (std::uint32_t count = bins; count > 1;) {
    const std::uint32_t half = count / 2;
    const UintOf<F> middle = first + UintOf<F>(half);
    first = select(gather(cumulative, middle) <= u, middle, first);
    count -= half;
  }
  return first - offset;
}
/// bin + fraction, not rounded up to the next bin.
template <class F>
F positionInBins(UintOf<F> bin, F fraction) {
  const F left = toFloat(toSigned(bin));
  return minimum(left + fraction, (left + F(1.0f)) * F(kOneMinusEpsilon));
}
/// The bin of x in units of bins, clamped to the table.
template <class F>
UintOf<F> binOf(F x, std::uint32_t bins) {
  return toUnsigned(toInt(clamp(x, F(0.0f), F(static_cast<float>(bins - 1)))));
}
}  // namespace detail

/// A density on [low, high) that is constant in each of n bins of equal width.
class PiecewiseConstant1D {
 public:
  template <class F>
  struct Sample {
    F x;
    F pdf;  ///< per unit of x
    UintOf<F> bin;
  };

  explicit PiecewiseConstant1D(std::span<const float> weights, float low = 0.0f, float high = 1.0f);

  std::size_t size() const { return cumulative_.size() - 1; }
  /// Probability of a bin.
  float probability(std::size_t bin) const { return cumulative_[bin + 1] - cumulative_[bin]; }
  template <class F>
  F probabilityOf(UintOf<F> bin) const {
    return shareOf(bin);
  }

  template <class F>
  Sample<F> sample(F u) const {
    const UintOf<F> bin = detail::findBin(cumulative_.data(), UintOf<F>(0u), bins(), u);
    const F left = gather(cumulative_.data(), bin);
    const F share = gather(cumulative_.data() + 1, bin) - left;
    const F position = detail::positionInBins(bin, (u - left) / share);
    return {minimum(F(low_) + position * F(binWidth_), F(last_)), share * F(1.0f / binWidth_), bin};
  }
  /// 0 outside of [low, high).
  template <class F>
  F pdf(F x) const {
    const F position = (x - F(low_)) / F(binWidth_);
    const MaskOf<F> inside = (position >= F(0.0f)) & (x < F(high_));
    return select(inside, shareOf(detail::binOf(position, bins())) * F(1.0f / binWidth_), F(0.0f));
  }
  /// Inverse of sample(): the random number that gives x; x outside counts as the nearer end.
  template <class F>
  F invert(F x) const {
    const F position = clamp((x - F(low_)) / F(binWidth_), F(0.0f), F(static_cast<float>(size())));
    const UintOf<F> bin = detail::binOf(position, bins());
    const F fraction = position - toFloat(toSigned(bin));
    return minimum(gather(cumulative_.data(), bin) + fraction * shareOf(bin), F(kOneMinusEpsilon));
  }

 private:
  std::uint32_t bins() const { return static_cast<std::uint32_t>(size()); }
  template <class U>
  auto shareOf(U bin) const {
    return gather(cumulative_.data() + 1, bin) - gather(cumulative_.data(), bin);
  }

  std::vector<float> cumulative_;
  float low_, high_, binWidth_;
  float last_;  ///< the largest float below high
};

/// A density on [0, 1)^2 that is constant in each cell of a grid: a marginal of the rows, and a conditional per row.
class PiecewiseConstant2D {
 public:
  template <class F>
  struct Sample {
    Vec2<F> point;
    F pdf;  ///< per unit of area
    UintOf<F> column, row;
  };

  /// columns * rows weights, row by row (y = 0 first). Each of columns and rows is at most 2^22.
  PiecewiseConstant2D(std::span<const float> weights, std::size_t columns, std::size_t rows);

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }

  template <class F>
  Sample<F> sample(Vec2<F> u) const {
    const auto y = marginal_.sample(u.y);
    const UintOf<F> offset = offsetOf<F>(y.bin);
    const UintOf<F> column = detail::findBin(conditional_.data(), offset, columns_, u.x);
    const F left = gather(conditional_.data(), offset + column);
    const F share = gather(conditional_.data() + 1, offset + column) - left;
    const F count(static_cast<float>(columns_));
    const F x = detail::positionInBins(column, (u.x - left) / share) / count;
    return {{minimum(x, F(kOneMinusEpsilon)), y.x}, share * count * y.pdf, column, y.bin};
  }
  /// 0 outside of the square.
  template <class F>
  F pdf(Vec2<F> p) const {
    const MaskOf<F> inside = (p.x >= F(0.0f)) & (p.x < F(1.0f));
    const Cell<F> c = cellOf(p);
    return select(inside, c.share * F(static_cast<float>(columns_)) * marginal_.pdf(p.y), F(0.0f));
  }
  /// Inverse of sample(): the random numbers that give p; coordinates outside count as the nearer edge.
  template <class F>
  Vec2<F> invert(Vec2<F> p) const {
    const Cell<F> c = cellOf(p);
    return {minimum(c.left + c.fraction * c.share, F(kOneMinusEpsilon)), marginal_.invert(p.y)};
  }

 private:
  template <class F>
  struct Cell {
    F left, share, fraction;  ///< of the conditional; the place in the cell
  };
  template <class F>
  UintOf<F> offsetOf(UintOf<F> row) const {
    return row * UintOf<F>(columns_ + 1);
  }
  template <class F>
  Cell<F> cellOf(Vec2<F> p) const {
    const UintOf<F> row = detail::binOf(p.y * F(static_cast<float>(rows_)), rows_);
    const F x = clamp(p.x, F(0.0f), F(1.0f)) * F(static_cast<float>(columns_));
    const UintOf<F> column = detail::binOf(x, columns_);
    const UintOf<F> index = offsetOf<F>(row) + column;
    const F left = gather(conditional_.data(), index);
    return {left, gather(conditional_.data() + 1, index) - left, x - toFloat(toSigned(column))};
  }

  std::uint32_t columns_, rows_;
  PiecewiseConstant1D marginal_;
  std::vector<float> conditional_;  ///< per row its cumulative sums, columns + 1 of them
};

/// Draws an index in constant time (Walker 1974; built after Vose 1991). The inverse of the cumulative sum keeps the
/// order of stratified and low-discrepancy numbers, which this does not: prefer it for many entries only.
///
/// The number of slots is the next power of two, so that a slot is a whole number of steps of 2^-24 and each entry gets
/// exactly its probability.
class AliasTable {
 public:
  template <class F>
  struct Sample {
    UintOf<F> index;
    F probability;
    F rest;  ///< the random number that remains in [0, 1): of its 24 bits, those that the choice left
  };

  explicit AliasTable(std::span<const float> weights);

  std::size_t size() const { return probability_.size(); }
  float probability(std::size_t index) const { return probability_[index]; }

  template <class F>
  Sample<F> sample(F u) const {
    const auto slots = static_cast<std::uint32_t>(alias_.size());
    const F scaled = u * F(static_cast<float>(slots));
    const UintOf<F> slot = detail::binOf(scaled, slots);
    const F place = scaled - toFloat(toSigned(slot));
    const F threshold = gather(threshold_.data(), slot);
    const MaskOf<F> own = place < threshold;
    const UintOf<F> index = select(own, slot, gather(alias_.data(), slot));
    const F rest = select(own, place / threshold, (place - threshold) / (F(1.0f) - threshold));
    return {index, gather(probability_.data(), index), minimum(rest, F(kOneMinusEpsilon))};
  }

 private:
  std::vector<float> probability_;    ///< per entry
  std::vector<float> threshold_;      ///< per slot: below it the slot gives its own index, else the alias
  std::vector<std::uint32_t> alias_;  ///< per slot
};

}  // namespace steradian
