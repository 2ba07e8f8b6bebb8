#include "steradian/core/statistics/student_t.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace steradian {
namespace {

TEST(StudentT, IncompleteBetaAgreesWithClosedForms) {
  for (const double x : {0.0, 1e-6, 0.1, 0.5, 0.9, 0.999999, 1.0}) {
    EXPECT_NEAR(incompleteBeta(1.0, 1.0, x), x, 1e-14) << x;
    EXPECT_NEAR(incompleteBeta(3.0, 1.0, x), x * x * x, 1e-14) << x;
    EXPECT_NEAR(incompleteBeta(2.0, 2.0, x), x * x * (3.0 - 2.0 * x), 1e-14) << x;
    EXPECT_NEAR(incompleteBeta(0.5, 0.5, x), 2.0 / std::numbers::pi * std::asin(std::sqrt(x)), 1e-13) << x;
  }
}

TEST(StudentT, OneAndTwoDegreesAgreeWithClosedForms) {
  for (const double t : {0.0, 0.01, 0.5, 1.0, 3.0, 50.0, 1e5}) {
    const double one = 2.0 / std::numbers::pi * std::atan2(1.0, t);
    EXPECT_NEAR(studentTwoSidedP(t, 1.0) / one, 1.0, 1e-12) << t;
    const double s = std::sqrt(2.0 + t * t), two = 2.0 / (s * (s + t));
    EXPECT_NEAR(studentTwoSidedP(-t, 2.0) / two, 1.0, 1e-12) << t;
  }
}

TEST(StudentT, BecomesTheNormalDistribution) {
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_NEAR(studentTwoSidedP(1.959963984540054, infinity), 0.05, 1e-12);
  // The first correction of the normal tail is of relative order t^4 / (4 nu).
  for (const double t : {0.5, 2.0, 5.0}) {
    EXPECT_NEAR(studentTwoSidedP(t, 9e6) / studentTwoSidedP(t, infinity), 1.0, 3e-5) << t;
  }
  EXPECT_EQ(studentTwoSidedP(infinity, 7.0), 0.0);
}

TEST(StudentT, QuantileInvertsP) {
  EXPECT_NEAR(studentTwoSidedQuantile(0.05, 7.0), 2.364624252, 1e-8);
  for (const double nu : {1.0, 2.5, 7.0, 300.0, 1e9}) {
    for (const double p : {0.9, 0.05, 1e-6, 1e-12}) {
      EXPECT_NEAR(studentTwoSidedP(studentTwoSidedQuantile(p, nu), nu) / p, 1.0, 1e-9) << nu << " " << p;
    }
  }
  EXPECT_NEAR(studentTwoSidedQuantile(1.0, 7.0), 0.0, 1e-12);
}

}  // namespace
}  // namespace steradian
