#include "steradian/tests/support/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace steradian::test {

double sidakLevel(double family, int tests) { return -std::expm1(std::log1p(-family) / tests); }

double suiteLevel() { return sidakLevel(kSuiteLevel, kSuiteTests); }

namespace {

constexpr double kTiny = 1e-300;

/// P(a, x) by its power series (DLMF 8.7.1), for x < a + 1.
double lowerGammaSeries(double a, double x) {
  double term = 1.0 / a, sum = term;
  for (int n = 1; n < 100000 && term > sum * 1e-17; ++n) {
    term *= x / (a + n);
    sum += term;
  }
  return sum * std::exp(a * std::log(x) - x - std::lgamma(a));
}

/// Q(a, x) by its continued fraction (DLMF 8.9.2, evaluated after Lentz), for x >= a + 1.
double upperGammaFraction(double a, double x) {
  double b = x + 1.0 - a, c = 1.0 / kTiny, d = 1.0 / b, h = d;
  for (int n = 1; n < 100000; ++n) {
    const double an = -n * (n - a);
    b += 2.0;
    d = 1.0 / std::copysign(std::max(std::abs(an * d + b), kTiny), an * d + b);
    c = b + an / c;
    if (std::abs(c) < kTiny) c = kTiny;
    h *= d * c;
    if (std::abs(d * c - 1.0) < 1e-16) break;
  }
  return h * std::exp(a * std::log(x) - x - std::lgamma(a));
}

}  // namespace

double upperIncompleteGamma(double a, double x) {
  if (x <= 0.0) return 1.0;
  if (std::isinf(x)) return 0.0;
  return x < a + 1.0 ? 1.0 - lowerGammaSeries(a, x) : upperGammaFraction(a, x);
}

double normalPValue(double z) { return std::erfc(std::abs(z) / std::sqrt(2.0)); }

double studentPValue(double t, int degreesOfFreedom) {
  // The closed forms for whole degrees of freedom: finite sums in cos^2 of the angle (Abramowitz &
  // Stegun 26.7.3, 26.7.4).
  const double n = degreesOfFreedom;
  const double theta = std::atan(std::abs(t) / std::sqrt(n));
  const double cosine = std::cos(theta), cosine2 = cosine * cosine;
  const bool odd = degreesOfFreedom % 2 == 1;
  double term = odd ? cosine : 1.0, sum = degreesOfFreedom == 1 ? 0.0 : term;
  for (int k = odd ? 2 : 1; k <= degreesOfFreedom - 3; k += 2) {
    term *= cosine2 * k / (k + 1.0);
    sum += term;
  }
  const double inside = odd ? (theta + std::sin(theta) * sum) * 2.0 / 3.14159265358979324 : std::sin(theta) * sum;
  return std::max(0.0, 1.0 - inside);
}

double uniformityPValue(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double n = static_cast<double>(values.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double rank = static_cast<double>(i);
    distance = std::max({distance, values[i] - rank / n, (rank + 1.0) / n - values[i]});
  }
  // Kolmogorov's distribution with Stephens' (1970) correction of the sample size.
  const double x = (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n)) * distance;
  if (x < 0.2) return 1.0;
  double sum = 0.0;
  for (int k = 1; k <= 100; ++k) sum += (k % 2 == 1 ? 2.0 : -2.0) * std::exp(-2.0 * k * k * x * x);
  return std::clamp(sum, 0.0, 1.0);
}

ChiSquare chiSquareTest(std::span<const double> observed, std::span<const double> expected) {
  std::vector<std::size_t> order(expected.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return expected[a] < expected[b]; });
  // Not NaN either: a density that is not a number fits nothing.
  const auto misfit = [&](std::size_t i) {
    return !(expected[i] >= 1e-6) && (observed[i] > 0.0 || !(expected[i] > -1e-6));
  };
  if (std::any_of(order.begin(), order.end(), misfit)) return {std::numeric_limits<double>::infinity(), 1, 0.0};
  struct Cell {
    double observed = 0.0, expected = 0.0;
  };
  std::vector<Cell> cells;
  Cell pool;
  for (const std::size_t i : order) {
    if (expected[i] >= 5.0) {
      cells.push_back({observed[i], expected[i]});
      continue;
    }
    pool.observed += observed[i];
    pool.expected += expected[i];
    if (pool.expected < 5.0) continue;
    cells.push_back(pool);
    pool = {};
  }
  ChiSquare result;
  for (const Cell& c : cells) result.statistic += (c.observed - c.expected) * (c.observed - c.expected) / c.expected;
  result.degreesOfFreedom = std::max(0, static_cast<int>(cells.size()) - 1);
  if (result.degreesOfFreedom > 0) {
    result.pValue = upperIncompleteGamma(0.5 * result.degreesOfFreedom, 0.5 * result.statistic);
  }
  if (pool.observed > 0.0) {
    // P(at least that many) of Poisson's distribution.
    const double poisson = 1.0 - upperIncompleteGamma(pool.observed, pool.expected);
    result.pValue = std::min(1.0, 2.0 * std::min(result.pValue, poisson));
  }
  return result;
}

ChiSquare chiSquareUniform(std::span<const double> observed) {
  const double total = std::accumulate(observed.begin(), observed.end(), 0.0);
  const std::vector<double> expected(observed.size(), total / static_cast<double>(observed.size()));
  return chiSquareTest(observed, expected);
}

double zTestPValue(double estimate, double standardError, double expected, double roundoffFloor) {
  const double difference = std::abs(estimate - expected);
  if (difference <= roundoffFloor) return 1.0;
  // Not above zero: also when the difference is not a number.
  if (!(difference > 0.0) || !(standardError > 0.0)) return 0.0;
  return normalPValue((difference - roundoffFloor) / standardError);
}

}  // namespace steradian::test
