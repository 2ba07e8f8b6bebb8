#include "steradian/core/sampling/estimate.h"

#include <gtest/gtest.h>

#include <array>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

constexpr std::array kTypes{SamplerType::Independent, SamplerType::Stratified, SamplerType::Sobol};

/// x^2 for x uniform in [0, 2], over its density: mean 8/3, variance 64/5 - 64/9.
double square(const Sampler<float>& point) {
  const double x = 2.0 * centred(point.get1D(4u));
  return x * x / 0.5;
}

TEST(Estimate, IsTheMeanOverThePointsOfTheSampler) {
  for (const SamplerType type : kTypes) {
    const EstimateSettings settings{.sampler = type, .samples = 100, .replicates = 4, .seed = 7, .stream = 3};
    RunningMean expected;
    for (std::uint32_t i = 0; i < 100; ++i) expected.add(square(Sampler<float>({type, 7u, 100u, 4u}, 3u, i)));
    const Estimate e = estimate(square, settings);
    EXPECT_NEAR(e.mean, expected.mean(), 1e-14);
    EXPECT_NEAR(e.variance, expected.variance(), 1e-13);
    EXPECT_EQ(e.count, 100u);
    EXPECT_EQ(e.degreesOfFreedom, type == SamplerType::Independent ? 99 : 3);
  }
}

TEST(Estimate, TheErrorIsThatOfTheSamplesOrOfTheReplicates) {
  double value = 0.0;
  const auto count = [&](const Sampler<float>&) { return value++; };  // 0 1 2 3 4 5 6 7
  const Estimate independent = estimate(count, {.samples = 8, .replicates = 2});
  EXPECT_DOUBLE_EQ(independent.mean, 3.5);
  EXPECT_DOUBLE_EQ(independent.variance, 6.0);
  EXPECT_DOUBLE_EQ(independent.standardError, std::sqrt(6.0 / 8.0));
  value = 0.0;
  // Samples go to the replicates in turn: means 3 and 4.
  const Estimate sobol = estimate(count, {.sampler = SamplerType::Sobol, .samples = 8, .replicates = 2});
  EXPECT_DOUBLE_EQ(sobol.mean, 3.5);
  EXPECT_DOUBLE_EQ(sobol.standardError, 0.5);
  EXPECT_EQ(sobol.degreesOfFreedom, 1);
}

TEST(Estimate, OneSampleOrOneReplicateHasNoKnownError) {
  for (const EstimateSettings& settings :
       {EstimateSettings{.samples = 1},
        EstimateSettings{.sampler = SamplerType::Sobol, .samples = 64, .replicates = 1}}) {
    const Estimate e = estimate(square, settings);
    EXPECT_TRUE(std::isinf(e.standardError));
    EXPECT_EQ(e.degreesOfFreedom, 0);
    EXPECT_TRUE(confidenceInterval(e).contains(1e300));
  }
}

TEST(Estimate, RefusesNoSamplesAndNoReplicates) {
  EXPECT_THROW(estimate(square, {.samples = 0}), Error);
  EXPECT_THROW(estimate(square, {.replicates = 0}), Error);
}

TEST(Estimate, SeedsAndStreamsAreOtherPoints) {
  const double first = estimate(square, {.samples = 50}).mean;
  EXPECT_EQ(estimate(square, {.samples = 50}).mean, first);
  EXPECT_NE(estimate(square, {.samples = 50, .seed = 1}).mean, first);
  EXPECT_NE(estimate(square, {.samples = 50, .stream = 1}).mean, first);
}

TEST(Estimate, AFunctionThatIsNoNumberSomewhereHasNoMean) {
  const Estimate e = estimate([](const Sampler<float>&) { return std::numeric_limits<double>::quiet_NaN(); });
  EXPECT_TRUE(std::isnan(e.mean));
  EXPECT_FALSE(std::isfinite(confidenceInterval(e).low));
}

TEST(Centred, IsTheMiddleOfAStep) {
  EXPECT_EQ(centred(0.0f), 0x1p-25);
  EXPECT_EQ(centred(0.5f), 0.5 + 0x1p-25);
  EXPECT_LT(centred(kOneMinusEpsilon), 1.0);
  // The mean over all numbers of a coarse grid, shifted by half of its step, is that of the interval.
  const Estimate e = estimate([](const Sampler<float>& point) { return centred(point.get1D(0u)); },
                              {.sampler = SamplerType::Sobol, .samples = 1u << 20, .replicates = 1});
  EXPECT_NEAR(e.mean, 0.5, 4e-9);
}

TEST(ConfidenceInterval, ReachesStudentsQuantileToBothSides) {
  // Tabulated: t(0.975; 7) = 2.364624, z(0.995) = 2.575829.
  const Interval student = confidenceInterval({10.0, 2.0, 8, 7});
  EXPECT_NEAR(student.low, 10.0 - 2.0 * 2.364624, 1e-5);
  EXPECT_NEAR(student.high, 10.0 + 2.0 * 2.364624, 1e-5);
  EXPECT_NEAR(confidenceInterval({0.0, 1.0, 1u << 30, 1 << 30}, 0.99).high, 2.575829, 1e-5);
  EXPECT_TRUE(student.contains(student.low));
  EXPECT_FALSE(student.contains(14.8));
  const Interval exact = confidenceInterval({1.0, 0.0, 8, 7});
  EXPECT_TRUE(exact.contains(1.0));
  EXPECT_FALSE(exact.contains(1.0 + 1e-15));
}

TEST(RunningEstimates, AreThoseOfShorterRuns) {
  for (const SamplerType type : {SamplerType::Independent, SamplerType::Sobol}) {
    EstimateSettings settings{.sampler = type, .samples = 300, .replicates = 3};
    const auto schedule = doublingSchedule(300);
    const auto running = runningEstimates(square, settings, schedule);
    ASSERT_EQ(running.size(), schedule.size());
    for (std::size_t i = 0; i < schedule.size(); ++i) {
      settings.samples = schedule[i];
      const Estimate alone = estimate(square, settings);
      EXPECT_EQ(running[i].mean, alone.mean);
      EXPECT_EQ(running[i].standardError, alone.standardError);
      EXPECT_EQ(running[i].count, schedule[i]);
    }
  }
}

TEST(RunningEstimates, DrawNoMoreThanTheSettingsAllow) {
  const std::vector<std::uint32_t> schedule{0, 5, 50};
  const auto running = runningEstimates(square, {.samples = 20}, schedule);
  ASSERT_EQ(running.size(), 2u);
  EXPECT_EQ(running[0].count, 5u);
  EXPECT_EQ(running[1].count, 20u);
}

TEST(DoublingSchedule, EndsWithTheWhole) {
  EXPECT_EQ(doublingSchedule(1), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(doublingSchedule(8), (std::vector<std::uint32_t>{1, 2, 4, 8}));
  EXPECT_EQ(doublingSchedule(9), (std::vector<std::uint32_t>{1, 2, 4, 8, 9}));
  EXPECT_EQ(doublingSchedule(0xffffffffu).size(), 33u);
}

}  // namespace
}  // namespace steradian
