#include <array>
#include <cmath>
#include <functional>

#include "steradian/tests/support/statistics.h"

namespace steradian::test {

namespace {

constexpr int kMinSplits = 2, kMaxSplits = 10, kMaxHalvings = 24;

using Function = std::function<double(double, double)>;
using LineFunction = std::function<double(double)>;

constexpr std::array<double, 4> node{-0.861136311594052575, -0.339981043584856265, 0.339981043584856265,
                                     0.861136311594052575};
constexpr std::array<double, 4> weight{0.347854845137453857, 0.652145154862546143, 0.652145154862546143,
                                       0.347854845137453857};

/// 4x4-point Gauss-Legendre: exact for polynomials of degree 7 in each variable.
double gauss(const Function& f, const Rectangle& r) {
  const double cx = 0.5 * (r.x0 + r.x1), hx = 0.5 * (r.x1 - r.x0);
  const double cy = 0.5 * (r.y0 + r.y1), hy = 0.5 * (r.y1 - r.y0);
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) sum += weight[i] * weight[j] * f(cx + hx * node[i], cy + hy * node[j]);
  }
  return sum * hx * hy;
}

/// Splits off the middle: with equal halves, the nodes of a cell and those of its halves agree about a jump at too many
/// positions.
constexpr double kSplit = 0.45;

double refine(const Function& f, const Rectangle& r, double coarse, double tolerance, int depth) {
  const double mx = r.x0 + kSplit * (r.x1 - r.x0), my = r.y0 + kSplit * (r.y1 - r.y0);
  const std::array<Rectangle, 4> parts{Rectangle{r.x0, mx, r.y0, my}, Rectangle{mx, r.x1, r.y0, my},
                                       Rectangle{r.x0, mx, my, r.y1}, Rectangle{mx, r.x1, my, r.y1}};
  std::array<double, 4> fine;
  for (std::size_t i = 0; i < 4; ++i) fine[i] = gauss(f, parts[i]);
  const double sum = fine[0] + fine[1] + fine[2] + fine[3];
  // "Not above": a NaN ends the refinement and is returned.
  const bool converged = depth >= kMinSplits && !(std::abs(sum - coarse) > tolerance);
  if (converged || depth >= kMaxSplits) return sum;
  double refined = 0.0;
  for (std::size_t i = 0; i < 4; ++i) refined += refine(f, parts[i], fine[i], tolerance, depth + 1);
  return refined;
}

double gauss(const LineFunction& f, double x0, double x1) {
  const double c = 0.5 * (x0 + x1), h = 0.5 * (x1 - x0);
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) sum += weight[i] * f(c + h * node[i]);
  return sum * h;
}

double refine(const LineFunction& f, double x0, double x1, double coarse, double tolerance, int depth) {
  const double middle = x0 + kSplit * (x1 - x0);
  const double left = gauss(f, x0, middle), right = gauss(f, middle, x1);
  const bool converged = depth >= kMinSplits && !(std::abs(left + right - coarse) > tolerance);
  if (converged || depth >= kMaxHalvings) return left + right;
  return refine(f, x0, middle, left, tolerance, depth + 1) + refine(f, middle, x1, right, tolerance, depth + 1);
}

}  // namespace

double integrate(const LineFunction& f, double x0, double x1, double tolerance) {
  return refine(f, x0, x1, gauss(f, x0, x1), tolerance, 0);
}

double integrate(const Function& f, const Rectangle& domain, double tolerance) {
  return refine(f, domain, gauss(f, domain), tolerance, 0);
}

}  // namespace steradian::test
