/// Intervals have their nominal coverage, for every kind of points.
#include "steradian/core/sampling/estimate.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using namespace test;

constexpr int kRuns = 2000;

/// exp(-x - y) over the unit square: (1 - 1/e)^2.
double smooth(const Sampler<float>& point) {
  const Vec2f p = point.get2D(0u);
  return std::exp(-centred(p.x) - centred(p.y));
}
const double kSmooth = std::pow(1.0 - std::exp(-1.0), 2);

/// p-value of the share of intervals of level `level` that hold the exact value, against `expected`.
double coveragePValue(SamplerType type, std::uint32_t replicates, double level, double expected) {
  int hits = 0;
  for (int run = 0; run < kRuns; ++run) {
    const Estimate e = estimate(
        smooth, {.sampler = type, .samples = 256, .replicates = replicates, .stream = static_cast<std::uint32_t>(run)});
    hits += confidenceInterval(e, level).contains(kSmooth) ? 1 : 0;
  }
  const double error = std::sqrt(expected * (1.0 - expected) / kRuns);
  return zTestPValue(static_cast<double>(hits) / kRuns, error, expected, 0.0);
}

class IntervalCoverage : public testing::TestWithParam<SamplerType> {};

TEST_P(IntervalCoverage, IsTheConfidence) {
  for (const std::uint32_t replicates : {4u, 16u}) {
    EXPECT_GT(coveragePValue(GetParam(), replicates, 0.95, 0.95), suiteLevel()) << replicates;
    EXPECT_GT(coveragePValue(GetParam(), replicates, 0.50, 0.50), suiteLevel()) << replicates;
  }
}

TEST_P(IntervalCoverage, OfAnotherConfidenceIsRejected) {
  EXPECT_LT(coveragePValue(GetParam(), 16, 0.92, 0.95), suiteLevel());
  EXPECT_LT(coveragePValue(GetParam(), 16, 0.98, 0.95), suiteLevel());
}

INSTANTIATE_TEST_SUITE_P(Points, IntervalCoverage,
                         testing::Values(SamplerType::Independent, SamplerType::Stratified, SamplerType::Sobol),
                         [](const auto& type) { return std::string(nameOf(type.param)); });

TEST(EstimateVariance, IsUnbiased) {
  RunningMean variance;
  for (std::uint32_t run = 0; run < 4000; ++run)
    variance.add(estimate(smooth, {.samples = 16, .stream = run}).variance);
  const double second = std::pow(0.5 * (1.0 - std::exp(-2.0)), 2);
  EXPECT_GT(zTestPValue(variance.mean(), variance.standardError(), second - kSmooth * kSmooth, 1e-7), suiteLevel());
}

}  // namespace
}  // namespace steradian
