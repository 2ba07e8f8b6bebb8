/// Every programme of `steradian-montecarlo` estimates what it says, with every kind of points, and its errors fall as
/// theory predicts.
#include <cmath>

#include "steradian/apps/montecarlo/error_study.h"
#include "steradian/apps/montecarlo/jittered_circle.h"
#include "steradian/apps/montecarlo/programme.h"
#include "steradian/core/statistics/student_t.h"
#include "steradian/tests/support/statistics.h"

namespace steradian::montecarlo {
namespace {

using namespace test;

/// Medians are biased by 1/N, and directions are floats.
constexpr double kRoundoff = 3e-7;

double pValue(const Result& result) {
  const double difference = std::abs(result.estimate.mean - result.exact);
  if (difference <= kRoundoff) return 1.0;
  if (!(result.estimate.standardError > 0.0)) return 0.0;
  return studentTwoSidedP((difference - kRoundoff) / result.estimate.standardError, result.estimate.degreesOfFreedom);
}

class ProgrammeEstimates : public testing::TestWithParam<SamplerType> {};

TEST_P(ProgrammeEstimates, AreWithinTheirErrorsOfTheExactValues) {
  for (const Programme& programme : programmes()) {
    for (const Result& result : programme.run({.samples = 1u << 16, .seed = 5, .sampler = GetParam()})) {
      if (result.estimate.count < 1024) continue;  // the beginning of a running estimate
      EXPECT_GT(pValue(result), suiteLevel())
          << programme.name << " " << result.label << ": " << result.estimate.mean << " for " << result.exact;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Points, ProgrammeEstimates,
                         testing::Values(SamplerType::Independent, SamplerType::Stratified, SamplerType::Sobol),
                         [](const auto& type) { return std::string(nameOf(type.param)); });

TEST(ProgrammeEstimates, VariancesAreTheExactOnes) {
  for (const Programme& programme : programmes()) {
    if (programme.name == "halfway") continue;  // its variance has 31 degrees of freedom
    for (const Result& result : programme.run({.samples = 1u << 17})) {
      if (!result.exactVariance || !std::isfinite(result.estimate.standardError)) continue;
      // The relative error is sqrt((kurtosis - 1) / N); the kurtosis of ln(sin x) is about 9.
      EXPECT_NEAR(result.estimate.variance, *result.exactVariance, 0.05 * *result.exactVariance + 1e-20)
          << programme.name << " " << result.label;
    }
  }
}

TEST(Metropolis, ManyStopsFollowTheCurve) {
  // Successive stops are correlated, so the usual number of samples of this file would be too small.
  for (const Result& result : findProgramme("metropolis")->run({.samples = 1u << 21, .seed = 6}))
    EXPECT_GT(pValue(result), suiteLevel()) << result.label << ": " << result.estimate.mean;
}

double slopeOf(std::string_view programme, std::size_t series) {
  return errorCurve(findProgramme(programme)->series(3)[series]).slope;
}

TEST(ErrorSlopes, AreThoseOfTheory) {
  // Each slope is fitted to 64 runs of 6 sizes: a standard error of about 0.016.
  EXPECT_NEAR(slopeOf("pi", 0), -0.5, 0.07);
  EXPECT_NEAR(slopeOf("pi", 1), -0.75, 0.07);
  EXPECT_NEAR(slopeOf("x-squared", 0), -0.5, 0.07);
  EXPECT_NEAR(slopeOf("x-squared", 1), -1.5, 0.07);
  EXPECT_NEAR(slopeOf("x-squared", 2), -1.5, 0.07);
}

TEST(ErrorSlopes, OfStratificationShrinkWithTheDimension) {
  for (std::size_t d = 2; d <= 5; ++d)
    EXPECT_NEAR(slopeOf("balls", d - 2), -0.5 - 0.5 / static_cast<double>(d), 0.08) << d;
}

TEST(JitteredCircle, IsTheErrorOfJitteredPoints) {
  const Series series = findProgramme("balls")->series(8).front();  // the share of the square: pi / 4
  RunningMean mean;
  for (std::uint32_t run = 0; run < 2000; ++run) mean.add(4.0 * series.estimate(16 * 16, run));
  const double expected = jitteredCircleError(16);
  // The relative error of a standard deviation of nearly normal values is 1 / sqrt(2 runs).
  EXPECT_GT(zTestPValue(std::sqrt(mean.variance()) / expected, 1.0 / std::sqrt(4000.0), 1.0, 0.0), suiteLevel());
}

TEST(BookFigures, ErrorOfTheHalfwayPointIsThatOfManyRuns) {
  const Result result = findProgramme("halfway")->run({.samples = 2048}).back();
  const Series series = findProgramme("halfway")->series(4).front();
  RunningMean mean;
  for (std::uint32_t run = 0; run < 400; ++run) mean.add(series.estimate(10000, run));
  const double ratio = std::sqrt(mean.variance()) / result.book.front().standardError;
  EXPECT_GT(zTestPValue(ratio, 1.0 / std::sqrt(800.0), 1.0, 0.0), suiteLevel());
}

}  // namespace
}  // namespace steradian::montecarlo
