#pragma once
/// Statistical proof for tests: p-values, deterministic quadrature, and checks of functions that sample.
///
///     EXPECT_TRUE(checkDirectionSampler([&](float, Vec2f u) { return cosine.sample(u); },
///                                       [&](Vec3f wi) { return cosine.pdf(wi); }));
///
/// Types with members `sample` and `pdf` are tested by prove() in proof.h, which also checks inverses and lanes.
///
/// The check is deterministic: its random numbers come from a fixed key. It takes about 0.1 s in a release build, so it
/// belongs into files named *_stat_test.cpp.
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "steradian/core/statistics/running_mean.h"
#include "steradian/core/transport/scattering.h"

namespace steradian::test {

// --- p-values ---------------------------------------------------------------------------------------------------

/// Family-wise error rate of the whole suite, and the number of tests that share it.
inline constexpr double kSuiteLevel = 0.01;
inline constexpr int kSuiteTests = 500;

/// The level of one of `tests` independent tests whose family-wise error rate is `family` (Sidak 1967).
double sidakLevel(double family, int tests);
/// The level of each test of the suite: 2e-5.
double suiteLevel();

/// Regularised upper incomplete gamma function Q(a, x), a > 0, x >= 0 (DLMF 8.2.4).
double upperIncompleteGamma(double a, double x);
/// P(|Z| >= |z|) of a standard normal Z.
double normalPValue(double z);
/// P(|T| >= |t|) of Student's t with that many degrees of freedom.
double studentPValue(double t, int degreesOfFreedom);
/// Kolmogorov-Smirnov p-value of values against the uniform distribution on [0, 1); sorts its copy. For 100 values or
/// more.
double uniformityPValue(std::vector<double> values);

struct ChiSquare {
  double statistic = 0.0;
  int degreesOfFreedom = 0;
  double pValue = 1.0;
};
/// Pearson's test of counts against expected counts of equal sum. Cells expected to hold fewer than 5 are pooled, the
/// smallest first; a pool that stays below 5 is compared with Poisson's distribution, and the smaller p-value counts,
/// doubled. A count where next to nothing (below 1e-6) is expected gives p = 0.
ChiSquare chiSquareTest(std::span<const double> observed, std::span<const double> expected);
/// The same against equal counts in all cells.
ChiSquare chiSquareUniform(std::span<const double> observed);

/// Two-sided test of an estimate and its standard error against `expected`; differences below `roundoffFloor`
/// (absolute) do not count: no estimate is better than the arithmetic it was made with.
double zTestPValue(double estimate, double standardError, double expected, double roundoffFloor);

using steradian::RunningMean;

// --- Quadrature -------------------------------------------------------------------------------------------------

struct Rectangle {
  double x0, x1, y0, y1;
};

/// The integral of f over a rectangle: 4x4-point Gauss-Legendre, split in four (twice in any case, at most 11 times)
/// where a cell and its parts differ by more than `tolerance` (absolute, per cell). Smooth functions to the tolerance;
/// a jump to about 1e-4 of its height. What is smaller than 1/30 of the rectangle may be missed.
double integrate(const std::function<double(double, double)>& f, const Rectangle& domain, double tolerance = 1e-7);
/// The same over an interval, split at most 25 times: a jump to about 1e-7 of its height.
double integrate(const std::function<double(double)>& f, double x0, double x1, double tolerance = 1e-7);

/// The grid of directions over which densities are integrated.
struct SphereGrid {
  Vec3f axis{0.0f, 0.0f, 1.0f};  ///< unit; the pole of the grid: the normal, or towards a small light
  /// Angle around the axis, radians, that gets half of the rings; set it to about 1.5 times the angle that a small
  /// light subtends. From pi/2 (the default: rings of equal solid angle) downwards; below 0.1 the rings beyond it grow
  /// by equal ratios, for the tails of narrow lobes.
  double focus = 1.57079632679489662;
  int rings = 12, sectors = 16;
};

/// Integrals of a density per steradian over the cells of the grid, ring by ring from the axis.
std::vector<double> integrateCells(const std::function<double(Vec3f)>& density, const SphereGrid& grid,
                                   double tolerance = 1e-7);
/// The integral over all directions, or over those within pi/2 of the axis.
double integrateSphere(const std::function<double(Vec3f)>& density, const SphereGrid& grid = {},
                       double tolerance = 1e-7);
double integrateHemisphere(const std::function<double(Vec3f)>& density, Vec3f axis, double tolerance = 1e-7);

// --- Checks of samplers -----------------------------------------------------------------------------------------

/// The options of all checks of samplers; the defaults are the strictest.
struct CheckOptions {
  int samples = 300000;
  std::uint32_t seed = 1;
  /// Probability that the sampler gives no sample (pdf 0): a cell of the chi-square test, and missing from the integral
  /// of the pdf. 0: never, not for awkward numbers either. std::nullopt: 1 less the integral of the pdf.
  std::optional<double> noSample = 0.0;
  /// |integral of the pdf + noSample - 1|.
  double normalisationTolerance = 1e-3;
  double quadratureTolerance = 1e-7;
  /// Relative difference between the pdf of a sample and pdf() of its place.
  double pdfTolerance = 1e-3;
  /// Share of the samples whose pdf() may differ: those on an edge, where pdf() may be that of the other side of a
  /// jump. If it is not 0, those of the adversarial random numbers (which make corners) may differ too.
  double edgeShare = 0.0;
  double level = suiteLevel();

  SphereGrid grid{};  ///< directions: the cells
  Rectangle domain{0.0, 1.0, 0.0,
                   1.0};        ///< planes, and x0 to x1 lines: encloses the support; samples outside are errors
  int columns = 12, rows = 12;  ///< planes: the cells; lines have columns * rows of equal width

  /// For prove() alone: does invert() exist, does Lanes<N>? The answer has to be the truth.
  bool inverse = true, lanes = true;
  /// |invert(sample(u)) - u|, or of the two samples in units of the domain.
  double inverseTolerance = 2e-6;
};

/// Checks that `sample(choice, u)` draws directions with density `pdf`:
/// - pdf >= 0 and its integral (quadrature) is 1 less the probability of no sample;
/// - chi-square of `samples` draws over the cells of the grid, with a cell for "no sample";
/// - a sample is a finite unit vector, and the pdf that comes with it is finite and equals pdf(direction);
/// - the same for adversarial random numbers: 0, the largest float below 1, their neighbours, 1/2 and its neighbours.
/// A failure says which of them failed and by how much.
testing::AssertionResult checkDirectionSampler(
    const std::function<DirectionSample<float>(float choice, Vec2f u)>& sample, const std::function<double(Vec3f)>& pdf,
    const CheckOptions& options = {});

/// A point of a plane with its density per unit of area.
struct PlaneSample {
  Vec2f point;
  double pdf = 0.0;
};
/// The same for samplers of points in a plane (disks, triangles, filters, tables).
testing::AssertionResult checkPlaneSampler(const std::function<PlaneSample(float choice, Vec2f u)>& sample,
                                           const std::function<double(Vec2f)>& pdf, const CheckOptions& options = {});

/// A number with its density per unit of length.
struct LineSample {
  float x = 0.0f;
  double pdf = 0.0;
};
/// The same for samplers of numbers (flights, one-dimensional densities and tables).
testing::AssertionResult checkLineSampler(const std::function<LineSample(float choice, Vec2f u)>& sample,
                                          const std::function<double(float)>& pdf, const CheckOptions& options = {});

/// One of several, with its probability.
struct IndexSample {
  std::uint32_t index = 0;
  double pdf = 0.0;
};
/// The same for samplers of indices (alias tables, selections, reservoirs): one cell per index.
testing::AssertionResult checkIndexSampler(const std::function<IndexSample(float choice, Vec2f u)>& sample,
                                           std::span<const double> probabilities, const CheckOptions& options = {});

}  // namespace steradian::test
