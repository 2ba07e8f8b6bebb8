#include "steradian/apps/montecarlo/jittered_circle.h"

#include <algorithm>
#include <cmath>

namespace steradian::montecarlo {

namespace {

/// The integral of sqrt(1 - x^2) from 0.
double segment(double x) { return 0.5 * (x * std::sqrt(1.0 - x * x) + std::asin(x)); }
double heightAt(double x) { return std::sqrt(std::max(1.0 - x * x, 0.0)); }

/// The area of the disk within [x0, x1] x [y0, y1], all >= 0 and <= 1.
double areaWithin(double x0, double x1, double y0, double y1) {
  // Left of `full` the circle passes above the cell, right of `none` below it.
  const double full = std::clamp(heightAt(y1), x0, x1), none = std::clamp(heightAt(y0), x0, x1);
  return (full - x0) * (y1 - y0) + segment(none) - segment(full) - y0 * (none - full);
}

}  // namespace

double jitteredCircleError(std::uint32_t n) {
  const std::uint32_t half = n / 2;
  const double cell = 1.0 / half;
  const auto edge = [&](std::uint32_t i) { return std::min(i * cell, 1.0); };
  double variance = 0.0;  // of the number of points inside, in one quarter
  for (std::uint32_t i = 0; i < half; ++i) {
    const auto lowest = static_cast<std::uint32_t>(heightAt(edge(i + 1)) * half);
    const auto highest = std::min(static_cast<std::uint32_t>(heightAt(edge(i)) * half), half - 1);
    for (std::uint32_t j = lowest; j <= highest; ++j) {
      const double share = std::clamp(areaWithin(edge(i), edge(i + 1), edge(j), edge(j + 1)) / (cell * cell), 0.0, 1.0);
      variance += share * (1.0 - share);
    }
  }
  return 4.0 * std::sqrt(4.0 * variance) / (static_cast<double>(n) * n);
}

}  // namespace steradian::montecarlo
