#pragma once
/// Deterministic integrals in double precision: exact values for what is estimated elsewhere.
#include <array>
#include <cmath>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

namespace detail {

/// Kronrod's integral of one interval and how far Gauss' is from it.
struct GaussKronrod {
  double integral, difference;
};

/// The pair of 7 and 15 points; nodes and weights as tabulated by Piessens et al. 1983, "QUADPACK" (qk15). Kronrod's is
/// exact for polynomials of degree 22, Gauss' of degree 13.
template <class Function>
GaussKronrod gaussKronrod(const Function& f, double low, double high) {
  struct Node {
    double x, kronrod, gauss;
  };
  constexpr std::array<Node, 7> nodes{{{0.991455371120812639, 0.022935322010529225, 0.0},
                                       {0.949107912342758525, 0.063092092629978553, 0.129484966168869693},
                                       {0.864864423359769073, 0.104790010322250184, 0.0},
                                       {0.741531185599394440, 0.140653259715525919, 0.279705391489276668},
                                       {0.586087235467691130, 0.169004726639267903, 0.0},
                                       {0.405845151377397167, 0.190350578064785410, 0.381830050505118945},
                                       {0.207784955007898468, 0.204432940075298892, 0.0}}};
  const double centre = 0.5 * (low + high), half = 0.5 * (high - low);
  const double middle = f(centre);
  double kronrod = 0.209482141084727828 * middle, gauss = 0.417959183673469388 * middle;
  for (const Node& node : nodes) {
    const double both = f(centre - half * node.x) + f(centre + half * node.x);
    kronrod += node.kronrod * both;
    gauss += node.gauss * both;
  }
  return {half * kronrod, std::abs(half * (kronrod - gauss))};
}

template <class Function>
double integrateParts(const Function& f, double low, double high, double tolerance, int splits) {
  constexpr int minSplits = 2, maxSplits = 50;
  const GaussKronrod whole = gaussKronrod(f, low, high);
  // "Not above": a NaN ends the refinement and is returned.
  if (splits >= maxSplits || (splits >= minSplits && !(whole.difference > tolerance))) return whole.integral;
  const double middle = 0.5 * (low + high);
  return integrateParts(f, low, middle, tolerance, splits + 1) + integrateParts(f, middle, high, tolerance, splits + 1);
}

}  // namespace detail

/// The integral of f(x) over [low, high] by adaptive Gauss-Kronrod quadrature: intervals are halved (twice in any case,
/// at most 50 times) until the two rules of each differ by at most `tolerance` (absolute). Smooth functions to about
/// 1e-14 of their size. The ends are never evaluated, so f may be infinite there if it is integrable; jumps and
/// integrable singularities cost about 50 halvings and come out to 1e-9 or better. What is narrower than 1/60 of the
/// range may be missed.
template <class Function>
double integrate(const Function& f, double low, double high, double tolerance = 1e-12) {
  return detail::integrateParts(f, low, high, tolerance, 0);
}

/// The integral of f(x, y) over the rectangle [x0, x1] x [y0, y1], as an integral over x of integrals over y. For
/// smooth functions; a jump costs accuracy (a disk comes out to 1e-4), so integrate up to it instead.
template <class Function>
double integrate2D(const Function& f, double x0, double x1, double y0, double y1, double tolerance = 1e-11) {
  const auto column = [&](double x) { return integrate([&](double y) { return f(x, y); }, y0, y1, 0.1 * tolerance); };
  return integrate(column, x0, x1, tolerance);
}

}  // namespace steradian
