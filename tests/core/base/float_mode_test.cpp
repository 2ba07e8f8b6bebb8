#include "steradian/core/base/float_mode.h"

#include <gtest/gtest.h>

namespace steradian::test {
namespace {

/// A product below the smallest normal float, computed now and not by the compiler.
float denormalProduct() {
  volatile float small = 1e-30f, smaller = 1e-10f;
  return small * smaller;
}

TEST(FlushDenormals, RoundsDenormalsToZeroAndRestoresTheCallersMode) {
  ASSERT_GT(denormalProduct(), 0.0f);
  {
    const FlushDenormals outer;
    EXPECT_EQ(denormalProduct(), 0.0f);
    volatile float denormal = 1e-40f;
    EXPECT_EQ(denormal * 1e20f, 0.0f);
    {
      const FlushDenormals inner;
      EXPECT_EQ(denormalProduct(), 0.0f);
    }
    EXPECT_EQ(denormalProduct(), 0.0f);
  }
  EXPECT_GT(denormalProduct(), 0.0f);
}

}  // namespace
}  // namespace steradian::test
