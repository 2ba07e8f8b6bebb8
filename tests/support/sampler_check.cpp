#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>

#include "steradian/core/samplers/rng.h"
#include "steradian/tests/support/sphere_cells.h"
#include "steradian/tests/support/statistics.h"

namespace steradian::test {

namespace {

/// A draw in the form that the check uses for all domains.
struct Draw {
  double pdf = 0.0;  ///< as the sampler says; 0: no sample
  double pdfThere = 0.0;
  std::size_t cell = 0;
  bool valid = true;  ///< a finite unit vector, a point of the domain
};
using Drawer = std::function<Draw(float choice, Vec2f u)>;

constexpr double kSliver = 0.05;  // samples

bool agree(const Draw& d, double tolerance) {
  return std::abs(d.pdf - d.pdfThere) <= tolerance * std::max(d.pdf, d.pdfThere);
}

testing::AssertionResult checkDraw(const Draw& d, float choice, Vec2f u, bool mayDiffer, const CheckOptions& options) {
  const auto failure = [&] {
    return testing::AssertionFailure() << "random numbers (" << choice << "; " << u.x << ", " << u.y << "): ";
  };
  // The negation catches NaN.
  if (!(d.pdf >= 0.0) || std::isinf(d.pdf)) return failure() << "the pdf of the sample is " << d.pdf;
  if (d.pdf == 0.0) {
    if (options.noSample != 0.0) return testing::AssertionSuccess();
    return failure() << "no sample, where there has to be one";
  }
  if (!d.valid) return failure() << "the sample is not finite, not a unit vector or outside of the domain";
  if (!mayDiffer && !agree(d, options.pdfTolerance)) {
    return failure() << "the sample says pdf " << d.pdf << ", pdf() says " << d.pdfThere;
  }
  return testing::AssertionSuccess();
}

testing::AssertionResult checkAdversarial(const Drawer& draw, const CheckOptions& options) {
  constexpr std::array<float, 10> values{0.0f, 0x1p-24f,       0x1p-12f, 0.25f,          0x1.fffffep-2f,
                                         0.5f, 0x1.000002p-1f, 0.75f,    0x1.fffffcp-1f, kOneMinusEpsilon};
  for (const float choice : values) {
    for (const float x : values) {
      for (const float y : values) {
        const auto result = checkDraw(draw(choice, {x, y}), choice, {x, y}, options.edgeShare > 0.0, options);
        if (!result) return result;
      }
    }
  }
  return testing::AssertionSuccess();
}

/// `expected` are the probabilities of the cells.
testing::AssertionResult checkDraws(const Drawer& draw, std::vector<double> expected, const CheckOptions& options) {
  const double integral = std::accumulate(expected.begin(), expected.end(), 0.0);
  const double noSample = options.noSample.value_or(std::max(0.0, 1.0 - integral));
  if (!(std::abs(integral + noSample - 1.0) <= options.normalisationTolerance)) {
    return testing::AssertionFailure() << "the pdf integrates to " << integral << ", not to " << 1.0 - noSample;
  }
  if (const auto result = checkAdversarial(draw, options); !result) return result;
  // Both sums are the number of samples: what quadrature misses or adds is spread over the cells. A cell that it finds
  // empty may hold a sliver of the support.
  for (double& e : expected) e = std::max(e * (1.0 - noSample) / integral * options.samples, kSliver);
  expected.push_back(noSample * options.samples);
  std::vector<double> observed(expected.size(), 0.0);
  int differences = 0;
  for (int i = 0; i < options.samples; ++i) {
    const auto words = randomWords<std::uint32_t>(static_cast<std::uint32_t>(i), 0x5eedu, 0u, options.seed);
    const float choice = toUnitFloat<float>(words[0]);
    const Vec2f u{toUnitFloat<float>(words[1]), toUnitFloat<float>(words[2])};
    const Draw d = draw(choice, u);
    const bool differs = d.pdf > 0.0 && !agree(d, options.pdfTolerance);
    if (differs) ++differences;
    const bool mayDiffer = differences <= options.edgeShare * options.samples;
    if (const auto result = checkDraw(d, choice, u, mayDiffer, options); !result) return result;
    observed[d.pdf > 0.0 ? d.cell : expected.size() - 1] += 1.0;
  }
  const ChiSquare test = chiSquareTest(observed, expected);
  if (!(test.pValue >= options.level)) {
    return testing::AssertionFailure() << "chi-square " << test.statistic << " at " << test.degreesOfFreedom
                                       << " degrees of freedom: p = " << test.pValue << " < " << options.level
                                       << "; no sample: " << observed.back() << " observed, " << expected.back()
                                       << " expected";
  }
  return testing::AssertionSuccess();
}

/// The cell of x among `count` equal ones.
int cellOf(double x, double low, double high, int count) {
  return std::clamp(static_cast<int>((x - low) / (high - low) * count), 0, count - 1);
}

/// Wraps the density so that a negative or infinite value is remembered.
template <class Point>
auto guarded(const std::function<double(Point)>& pdf, bool& bad) {
  return [&pdf, &bad](Point x) {
    const double value = pdf(x);
    if (!(value >= 0.0) || std::isinf(value)) bad = true;
    return value;
  };
}

}  // namespace

testing::AssertionResult checkDirectionSampler(
    const std::function<DirectionSample<float>(float choice, Vec2f u)>& sample, const std::function<double(Vec3f)>& pdf,
    const CheckOptions& options) {
  const SphereCells cells(options.grid);
  bool bad = false;
  const std::vector<double> expected = cells.integrate(guarded<Vec3f>(pdf, bad), options.quadratureTolerance);
  if (bad) return testing::AssertionFailure() << "pdf() is negative or not finite somewhere";
  const auto draw = [&](float choice, Vec2f u) {
    const DirectionSample<float> s = sample(choice, u);
    Draw d{s.pdf, 0.0, 0, true};
    if (!(s.pdf > 0.0f)) return d;
    d.valid = std::abs(length(s.wi) - 1.0f) < 1e-5f;
    if (!d.valid) return d;
    d.pdfThere = pdf(s.wi);
    d.cell = cells.cellOf(s.wi);
    return d;
  };
  return checkDraws(draw, expected, options);
}

testing::AssertionResult checkPlaneSampler(const std::function<PlaneSample(float choice, Vec2f u)>& sample,
                                           const std::function<double(Vec2f)>& pdf, const CheckOptions& options) {
  const Rectangle& r = options.domain;
  const double width = (r.x1 - r.x0) / options.columns, height = (r.y1 - r.y0) / options.rows;
  bool bad = false;
  const auto density = guarded<Vec2f>(pdf, bad);
  const auto f = [&](double x, double y) { return density({static_cast<float>(x), static_cast<float>(y)}); };
  std::vector<double> expected;
  for (int j = 0; j < options.rows; ++j) {
    for (int i = 0; i < options.columns; ++i) {
      const Rectangle cell{r.x0 + i * width, r.x0 + (i + 1) * width, r.y0 + j * height, r.y0 + (j + 1) * height};
      expected.push_back(integrate(f, cell, options.quadratureTolerance));
    }
  }
  if (bad) return testing::AssertionFailure() << "pdf() is negative or not finite somewhere";
  const auto draw = [&](float choice, Vec2f u) {
    const PlaneSample s = sample(choice, u);
    Draw d{s.pdf, 0.0, 0, true};
    if (!(s.pdf > 0.0)) return d;
    d.valid = s.point.x >= r.x0 && s.point.x <= r.x1 && s.point.y >= r.y0 && s.point.y <= r.y1;
    if (!d.valid) return d;
    d.pdfThere = pdf(s.point);
    const int column = cellOf(s.point.x, r.x0, r.x1, options.columns);
    const int row = cellOf(s.point.y, r.y0, r.y1, options.rows);
    d.cell =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(options.columns) + static_cast<std::size_t>(column);
    return d;
  };
  return checkDraws(draw, expected, options);
}

testing::AssertionResult checkLineSampler(const std::function<LineSample(float choice, Vec2f u)>& sample,
                                          const std::function<double(float)>& pdf, const CheckOptions& options) {
  const double low = options.domain.x0, high = options.domain.x1;
  const int cells = options.columns * options.rows;
  bool bad = false;
  const auto density = guarded<float>(pdf, bad);
  const auto f = [&](double x) { return density(static_cast<float>(x)); };
  std::vector<double> expected;
  for (int i = 0; i < cells; ++i) {
    const auto edge = [&](int k) { return low + (high - low) * k / cells; };
    expected.push_back(integrate(f, edge(i), edge(i + 1), options.quadratureTolerance));
  }
  if (bad) return testing::AssertionFailure() << "pdf() is negative or not finite somewhere";
  const auto draw = [&](float choice, Vec2f u) {
    const LineSample s = sample(choice, u);
    Draw d{s.pdf, 0.0, 0, true};
    if (!(s.pdf > 0.0)) return d;
    d.valid = s.x >= low && s.x <= high;
    if (!d.valid) return d;
    d.pdfThere = pdf(s.x);
    d.cell = static_cast<std::size_t>(cellOf(s.x, low, high, cells));
    return d;
  };
  return checkDraws(draw, expected, options);
}

testing::AssertionResult checkIndexSampler(const std::function<IndexSample(float choice, Vec2f u)>& sample,
                                           std::span<const double> probabilities, const CheckOptions& options) {
  const bool bad =
      std::any_of(probabilities.begin(), probabilities.end(), [](double p) { return !(p >= 0.0) || std::isinf(p); });
  if (bad) return testing::AssertionFailure() << "a probability is negative or not finite";
  const auto draw = [&](float choice, Vec2f u) {
    const IndexSample s = sample(choice, u);
    Draw d{s.pdf, 0.0, 0, s.index < probabilities.size()};
    if (!d.valid || !(s.pdf > 0.0)) return d;
    d.pdfThere = probabilities[s.index];
    d.cell = s.index;
    return d;
  };
  return checkDraws(draw, {probabilities.begin(), probabilities.end()}, options);
}

}  // namespace steradian::test
