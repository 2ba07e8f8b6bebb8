#pragma once
/// Densities on an interval with inverses in closed form ("The Rest of Your Life", chapter 3): linear ones and powers.
///
/// Each has `sample(u)`, `pdf(x)` per unit of x, and `invert(x)`: invert(sample(u)) is u up to rounding. Where the
/// density starts at 0, the random number 0 counts as 2^-25, so that no sample has the density 0.
#include "steradian/core/math/math.h"

namespace STERADIAN_API steradian {

namespace detail {
/// u, or 2^-25, half a step of the random numbers, in place of 0.
template <class F>
F positiveUnit(F u) {
  return maximum(u, F(0x1p-25f));
}
}  // namespace detail

/// A density on [low, high] that is linear from a multiple of `atLow` to the same multiple of `atHigh`; both are in [0,
/// 1e18], at least one of them is 1e-18 or more. The book's x / 2 on [0, 2] is {0, 2, 0, 1}. The inverse of the
/// cumulative is written so that it does not cancel for nearly equal ends (Pharr, Jakob & Humphreys, "Physically Based
/// Rendering", 4th ed., 2.3.2).
template <class F>
struct LinearDensity {
  F low, high;
  F atLow, atHigh;

  F sample(F u) const {
    const F v = detail::positiveUnit(u);
    const F root = squareRoot(atLow * atLow * (F(1.0f) - v) + atHigh * atHigh * v);
    const F t = minimum(v * (atLow + atHigh) / (atLow + root), F(kOneMinusEpsilon));
    return minimum(low + (high - low) * t, high);
  }
  F pdf(F x) const {
    const F t = (x - low) / (high - low);
    const MaskOf<F> inside = (t >= F(0.0f)) & (t <= F(1.0f));
    const F value = atLow * (F(1.0f) - t) + atHigh * t;
    return select(inside, F(2.0f) * value / ((atLow + atHigh) * (high - low)), F(0.0f));
  }
  F invert(F x) const {
    const F t = clamp((x - low) / (high - low), F(0.0f), F(1.0f));
    const F u = t * (atLow * (F(2.0f) - t) + atHigh * t) / (atLow + atHigh);
    return minimum(u, F(kOneMinusEpsilon));
  }
};

/// The density (n + 1) x^n / end^(n + 1) on [0, end], n > -1: x = end u^(1 / (n + 1)). The book's 3/8 x^2 on [0, 2] is
/// {2, 2}, whose inverse is 2 u^(1/3) (the book prints 8 u^(1/3)). Relative error of x below 1e-5, of the pdf below
/// 1e-5 (1 + n).
template <class F>
struct PowerDensity {
  F end;
  F exponent;

  F sample(F u) const { return end * minimum(power(detail::positiveUnit(u), F(1.0f) / (exponent + F(1.0f))), F(1.0f)); }
  F pdf(F x) const {
    const MaskOf<F> inside = (x > F(0.0f)) & (x <= end);
    return select(inside, (exponent + F(1.0f)) / end * power(x / end, exponent), F(0.0f));
  }
  F invert(F x) const { return clamp(power(x / end, exponent + F(1.0f)), F(0.0f), F(kOneMinusEpsilon)); }
};

}  // namespace steradian
