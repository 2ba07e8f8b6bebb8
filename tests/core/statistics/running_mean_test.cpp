#include "steradian/core/statistics/running_mean.h"

#include <gtest/gtest.h>

namespace steradian {
namespace {

TEST(RunningMean, IsMeanVarianceAndStandardError) {
  RunningMean mean;
  for (const double x : {1.0, 2.0, 3.0, 6.0}) mean.add(x);
  EXPECT_EQ(mean.count(), 4);
  EXPECT_DOUBLE_EQ(mean.mean(), 3.0);
  EXPECT_DOUBLE_EQ(mean.variance(), 14.0 / 3.0);
  EXPECT_DOUBLE_EQ(mean.standardError(), std::sqrt(14.0 / 12.0));
}

TEST(RunningMean, KeepsTheDigitsOfASmallSpreadAroundALargeMean) {
  RunningMean mean;
  for (int i = 0; i < 1000; ++i) mean.add(1e9 + i % 2);
  EXPECT_NEAR(mean.variance(), 0.25 * 1000.0 / 999.0, 1e-6);
}

TEST(RunningMean, HasNoVarianceBeforeTheSecondValue) {
  RunningMean mean;
  EXPECT_EQ(mean.standardError(), 0.0);
  mean.add(5.0);
  EXPECT_EQ(mean.mean(), 5.0);
  EXPECT_EQ(mean.variance(), 0.0);
  EXPECT_EQ(mean.standardError(), 0.0);
}

}  // namespace
}  // namespace steradian
