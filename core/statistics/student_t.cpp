#include "steradian/core/statistics/student_t.h"

#include <cmath>

namespace steradian {
namespace {

/// ln Gamma(x) for x > 0. The standard function writes the sign to a global variable, which threads must not share.
double logGamma(double x) {
  int sign = 0;
  return ::lgamma_r(x, &sign);
}

/// The continued fraction 1 + d1/(1 + d2/(1 + ...)) of I_x(a, b), evaluated from its front (modified Lentz).
double betaFraction(double a, double b, double x) {
  constexpr double tiny = 1e-300;
  constexpr double precision = 1e-15;
  constexpr int maxTerms = 20000;
  const auto away = [](double v) { return std::abs(v) < tiny ? tiny : v; };
  double c = 1.0, d = 0.0, value = 1.0;
  for (int k = 1; k < maxTerms; ++k) {
    const int pair = k / 2;
    const double m = pair;
    const double term = k % 2 == 0 ? m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m))
                                   : -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
    d = 1.0 / away(1.0 + term * d);
    c = away(1.0 + term / c);
    value *= c * d;
    if (std::abs(c * d - 1.0) < precision) break;
  }
  return value;
}

}  // namespace

double incompleteBeta(double a, double b, double x) {
  if (x <= 0.0) return 0.0;
  if (x >= 1.0) return 1.0;
  // The fraction converges quickly below the mean of the distribution.
  if (x > (a + 1.0) / (a + b + 2.0)) return 1.0 - incompleteBeta(b, a, 1.0 - x);
  const double scale = a * std::log(x) + b * std::log1p(-x) + logGamma(a + b) - logGamma(a) - logGamma(b);
  return std::exp(scale) / (a * betaFraction(a, b, x));
}

double studentTwoSidedP(double t, double degreesOfFreedom) {
  constexpr double practicallyNormal = 1e7;
  if (std::isinf(t)) return 0.0;
  if (degreesOfFreedom > practicallyNormal) return std::erfc(std::abs(t) / std::sqrt(2.0));
  return incompleteBeta(0.5 * degreesOfFreedom, 0.5, degreesOfFreedom / (degreesOfFreedom + t * t));
}

double studentTwoSidedQuantile(double p, double degreesOfFreedom) {
  double low = 0.0, high = 1.0;
  while (studentTwoSidedP(high, degreesOfFreedom) > p && high < 1e300) high *= 2.0;
  for (int i = 0; i < 200 && high - low > 1e-14 * high; ++i) {
    const double middle = 0.5 * (low + high);
    (studentTwoSidedP(middle, degreesOfFreedom) > p ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace steradian
