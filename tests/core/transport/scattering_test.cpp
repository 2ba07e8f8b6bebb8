#include "steradian/core/transport/scattering.h"

#include <gtest/gtest.h>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

TEST(MisWeight, SumsToOneOverTheStrategies) {
  for (const float a : {1e-18f, 0.3f, 1.0f, 50.0f, 1e18f}) {
    for (const float b : {1e-18f, 0.3f, 1.0f, 50.0f, 1e18f})
      EXPECT_NEAR(misWeight(a, b) + misWeight(b, a), 1.0f, 1e-6f);
  }
  EXPECT_EQ(misWeight(2.0f, 2.0f), 0.5f);
  EXPECT_NEAR(misWeight(3.0f, 1.0f), 0.9f, 1e-6f);
}

TEST(MisWeight, NeedsNoSpecularFlag) {
  EXPECT_EQ(misWeight(kDirac, 3.0f), 1.0f);
  EXPECT_EQ(misWeight(3.0f, kDirac), 0.0f);
  EXPECT_EQ(misWeight(kDirac, 0.0f), 1.0f);
  EXPECT_EQ(misWeight(3.0f, 0.0f), 1.0f);
  // Neither the square of a large density overflows nor that of a small one underflows.
  EXPECT_EQ(misWeight(1e-30f, 1e30f), 0.0f);
  EXPECT_EQ(misWeight(1e30f, 1e-30f), 1.0f);
}

TEST(MisWeight, LanesAgreeWithScalars) {
  auto a = test::numbers(128, 1e-3f, 9.0f), b = test::numbers(128, 0.0f, 9.0f, 1);
  a[5] = kDirac;
  b[7] = kDirac;
  EXPECT_TRUE(test::sameInLanes<8>([](auto x, auto y) { return misWeight(x, y); }, a, b));
}

}  // namespace
}  // namespace steradian
