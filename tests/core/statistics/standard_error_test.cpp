#include "steradian/core/statistics/standard_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace steradian {
namespace {

TEST(StandardError, EightSubSequencesReachToTheLastSample) {
  for (std::uint32_t last = 0; last < 8; ++last) EXPECT_EQ(subSequenceShift(last), 0u);
  for (std::uint32_t last = 8; last < 5000; ++last) {
    const std::uint32_t run = last >> subSequenceShift(last);
    EXPECT_GE(run, 4u) << last;
    EXPECT_LE(run, 7u) << last;
  }
  EXPECT_EQ(subSequenceShift(63), 3u);
  EXPECT_EQ(subSequenceShift(64), 4u);
  EXPECT_EQ(subSequenceShift(0xffffffffu), 29u);
}

TEST(StandardError, IsThatOfTheGroupMeansWhenGroupsAreEqual) {
  // Means 1, 2, 3, 6: their mean is 3, their variance 14 / 3, that of the mean 14 / 12.
  const std::vector<double> sums{2.0, 4.0, 6.0, 12.0};
  const std::vector<std::uint32_t> counts{2, 2, 2, 2};
  const MeanEstimate e = meanFromGroups(sums, counts);
  EXPECT_DOUBLE_EQ(e.mean, 3.0);
  EXPECT_DOUBLE_EQ(e.standardError, std::sqrt(14.0 / 12.0));
  EXPECT_EQ(e.count, 8u);
  EXPECT_EQ(e.degreesOfFreedom, 3);
}

TEST(StandardError, WeighsUnequalGroupsAndSkipsEmptyOnes) {
  // Means 1 (three samples) and 5 (one): mean 2, spread 3 * 1 + 1 * 9 = 12, over one degree of freedom and 4 samples.
  const std::vector<double> sums{3.0, 0.0, 5.0};
  const std::vector<std::uint32_t> counts{3, 0, 1};
  const MeanEstimate e = meanFromGroups(sums, counts);
  EXPECT_DOUBLE_EQ(e.mean, 2.0);
  EXPECT_DOUBLE_EQ(e.standardError, std::sqrt(12.0 / 4.0));
  EXPECT_EQ(e.degreesOfFreedom, 1);
}

TEST(StandardError, IsUnknownWithFewerThanTwoGroups) {
  const MeanEstimate one = meanFromGroups(std::vector<double>{6.0, 0.0}, std::vector<std::uint32_t>{2, 0});
  EXPECT_DOUBLE_EQ(one.mean, 3.0);
  EXPECT_TRUE(std::isinf(one.standardError));
  EXPECT_EQ(one.degreesOfFreedom, 0);
  const MeanEstimate none = meanFromGroups(std::vector<double>{0.0, 0.0}, std::vector<std::uint32_t>{0, 0});
  EXPECT_EQ(none.mean, 0.0);
  EXPECT_TRUE(std::isinf(none.standardError));
  EXPECT_EQ(none.count, 0u);
}

}  // namespace
}  // namespace steradian
