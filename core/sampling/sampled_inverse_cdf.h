#pragma once
/// The tabulated inverse of a cumulative distribution that is only known by samples ("The Rest of Your Life", 3.3 and
/// 3.4: sort them, add them up, halve the sum, and halve the halves).
#include <cstdint>
#include <span>
#include <vector>

#include "steradian/core/sampling/distribution.h"

namespace STERADIAN_API steradian {

/// A place with its share of the distribution, in any unit. Of places that are uniform on the interval: the density
/// there, not normalised (the book's p(x)); of places that have the density q: p(x) / q(x); of draws from the
/// distribution itself: 1 for all.
struct WeightedPlace {
  float x = 0.0f;
  float weight = 0.0f;
};

/// A density on [low, high] of 2^depth bins of equal probability: its edges are the quantiles of the samples, a nested
/// binary partition of that depth. More samples per bin make the bins truer, fewer bins make them coarser: with n
/// samples the probability of a bin is off by a share of about sqrt(2^depth / n).
///
/// Half of the weight of a place lies before it and half after it, spread evenly up to the next place or the end of the
/// interval, so that no part of the interval between places of positive weight is lost. Weights are >= 0 and finite,
/// places lie within the interval, in any order; those at the same place count together. All weights zero: uniform.
/// Lookups are lane-generic, read-only and never throw.
class SampledInverseCdf {
 public:
  template <class F>
  struct Sample {
    F x;
    F pdf;  ///< per unit of x
    UintOf<F> bin;
  };

  /// `depth` in [0, 16]. Throws `Error` (kind Usage) without samples, for a place outside of the interval, a weight
  /// that is negative or not finite, or an interval with fewer floats than bins.
  SampledInverseCdf(std::span<const WeightedPlace> samples, float low, float high, int depth = 8);

  std::size_t size() const { return edges_.size() - 1; }
  float low() const { return edges_.front(); }
  float high() const { return edges_.back(); }
  /// The edge before bin i: the quantile i / size().
  float edge(std::size_t i) const { return edges_[i]; }
  /// The point that half of the distribution lies before, where depth > 0.
  float halfway() const { return edges_[size() / 2]; }

  template <class F>
  Sample<F> sample(F u) const {
    const F scaled = u * F(static_cast<float>(size()));
    const UintOf<F> bin = detail::binOf(scaled, bins());
    const F left = gather(edges_.data(), bin), right = gather(edges_.data() + 1, bin);
    const F x = left + (right - left) * (scaled - toFloat(toSigned(bin)));
    return {minimum(x, right), densityOf<F>(bin), bin};
  }
  /// 0 outside of [low, high].
  template <class F>
  F pdf(F x) const {
    const F first(low()), last(high());
    const MaskOf<F> inside = (x >= first) & (x <= last);
    return select(inside, densityOf<F>(binAt(x)), F(0.0f));
  }
  /// Inverse of sample(): the random number that gives x; x outside counts as the nearer end.
  template <class F>
  F invert(F x) const {
    const F c = clamp(x, F(low()), F(high()));
    const UintOf<F> bin = binAt(c);
    const F left = gather(edges_.data(), bin), width = gather(edges_.data() + 1, bin) - left;
    const F u = (toFloat(toSigned(bin)) + (c - left) / width) * F(1.0f / static_cast<float>(size()));
    return minimum(u, F(kOneMinusEpsilon));
  }

 private:
  std::uint32_t bins() const { return static_cast<std::uint32_t>(size()); }
  template <class F>
  UintOf<F> binAt(F x) const {
    return detail::findBin(edges_.data(), UintOf<F>(0u), bins(), x);
  }
  template <class F>
  F densityOf(UintOf<F> bin) const {
    const F width = gather(edges_.data() + 1, bin) - gather(edges_.data(), bin);
    return F(1.0f / static_cast<float>(size())) / width;
  }

  std::vector<float> edges_;  ///< strictly increasing, one more than there are bins
};

}  // namespace steradian
