#include "steradian/core/sampling/line_density.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

TEST(LineDensity, TheBooksLinearDensity) {
  // x / 2 on [0, 2]: a quarter of it lies below 1, half below sqrt 2.
  const LinearDensity<float> d{0.0f, 2.0f, 0.0f, 1.0f};
  EXPECT_FLOAT_EQ(d.pdf(0.5f), 0.25f);
  EXPECT_FLOAT_EQ(d.sample(0.25f), 1.0f);
  EXPECT_FLOAT_EQ(d.sample(0.5f), std::sqrt(2.0f));
  EXPECT_FLOAT_EQ(d.invert(1.5f), 0.5625f);
  EXPECT_GT(d.pdf(d.sample(0.0f)), 0.0f);
  EXPECT_EQ(d.pdf(-0.1f), 0.0f);
  EXPECT_EQ(d.pdf(2.1f), 0.0f);
}

TEST(LineDensity, ExtremesOfTheEnds) {
  for (const float scale : {1e-18f, 1.0f, 1e18f}) {
    const LinearDensity<float> d{0.0f, 1.0f, scale, 3.0f * scale};
    EXPECT_FLOAT_EQ(d.pdf(0.5f), 1.0f);
    EXPECT_NEAR(d.invert(d.sample(0.3f)), 0.3f, 1e-6f);
  }
  const LinearDensity<float> falling{0.0f, 1.0f, 1.0f, 0.0f};
  EXPECT_EQ(falling.sample(0.0f) < 1e-6f, true);
  EXPECT_GT(falling.pdf(falling.sample(kOneMinusEpsilon)), 0.0f);
}

TEST(LineDensity, TheBooksQuadraticDensity) {
  // 3/8 x^2 on [0, 2]: every sample gives x^2 / p = 8/3.
  const PowerDensity<float> d{2.0f, 2.0f};
  for (const float u : test::unitNumbers(200)) {
    const float x = d.sample(u);
    EXPECT_TRUE(x > 0.0f && x <= 2.0f);
    EXPECT_NEAR(x * x / d.pdf(x), 8.0f / 3.0f, 3e-5f) << u;
  }
  EXPECT_NEAR(d.sample(0.125f), 1.0f, 1e-5f);
  EXPECT_NEAR(d.invert(1.0f), 0.125f, 1e-6f);
  EXPECT_EQ(d.pdf(0.0f), 0.0f);
  EXPECT_EQ(d.pdf(2.1f), 0.0f);
}

}  // namespace
}  // namespace steradian
