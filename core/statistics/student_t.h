#pragma once
/// Student's t distribution: what a mean divided by its own estimated standard error follows.
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// I_x(a, b), the regularised incomplete beta function, for a, b > 0 and x in [0, 1].
/// Source: NIST Digital Library of Mathematical Functions, 8.17.22 (continued fraction) and 8.17.4 (symmetry).
double incompleteBeta(double a, double b, double x);

/// P(|T| >= |t|) for `degreesOfFreedom` > 0, which need not be whole; infinity makes it the normal distribution.
/// Accurate also where it is tiny. 0 for infinite t.
double studentTwoSidedP(double t, double degreesOfFreedom);

/// The t >= 0 for which `studentTwoSidedP` is p, for p in (0, 1].
double studentTwoSidedQuantile(double p, double degreesOfFreedom);

}  // namespace steradian
