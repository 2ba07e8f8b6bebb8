#include "steradian/core/statistics/quadrature.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace steradian {
namespace {

using std::numbers::pi;

TEST(Quadrature, IsExactForThePolynomialsThatItsNodesAreMadeFor) {
  for (int degree = 0; degree <= 22; ++degree) {
    const auto rule = detail::gaussKronrod([&](double x) { return (degree + 1) * std::pow(x, degree); }, 0.0, 1.0);
    EXPECT_NEAR(rule.integral, 1.0, 1e-14) << degree;
    if (degree <= 13) {
      EXPECT_NEAR(rule.difference, 0.0, 1e-14) << degree;
    }
  }
  EXPECT_GT(detail::gaussKronrod([](double x) { return std::pow(x, 14); }, -1.0, 1.0).difference, 1e-5);
}

TEST(Quadrature, IntegratesSmoothFunctions) {
  EXPECT_NEAR(integrate([](double x) { return std::exp(-x * x); }, -8.0, 8.0), std::sqrt(pi), 1e-13);
  EXPECT_NEAR(integrate([](double x) { return std::cos(50.0 * x); }, 0.0, 1.0), std::sin(50.0) / 50.0, 1e-13);
  EXPECT_EQ(integrate([](double) { return 3.0; }, 2.0, 2.0), 0.0);
  EXPECT_NEAR(integrate([](double x) { return x; }, 1.0, 0.0), -0.5, 1e-15) << "backwards";
}

TEST(Quadrature, IntegratesJumpsAndWhatIsInfiniteAtTheEnds) {
  EXPECT_NEAR(integrate([](double x) { return x < 1.0 / 3.0 ? 1.0 : 0.0; }, 0.0, 1.0), 1.0 / 3.0, 1e-10);
  EXPECT_NEAR(integrate([](double x) { return std::log(x); }, 0.0, 1.0), -1.0, 1e-11);
  EXPECT_NEAR(integrate([](double x) { return 1.0 / std::sqrt(x); }, 0.0, 1.0), 2.0, 1e-7);
  EXPECT_NEAR(integrate([](double x) { return std::sqrt(1.0 - x * x); }, -1.0, 1.0), 0.5 * pi, 1e-11);
}

TEST(Quadrature, ReturnsWhatIsNoNumber) {
  EXPECT_TRUE(std::isnan(integrate([](double) { return std::numeric_limits<double>::quiet_NaN(); }, 0.0, 1.0)));
}

TEST(Quadrature, IntegratesOverRectangles) {
  EXPECT_NEAR(integrate2D([](double x, double y) { return x * x * y; }, 0.0, 3.0, 1.0, 2.0), 13.5, 1e-12);
  const auto bell = [](double x, double y) { return std::exp(-x * x - y * y); };
  EXPECT_NEAR(integrate2D(bell, -6.0, 6.0, -6.0, 6.0), pi, 1e-10);
  const auto disk = [](double x, double y) { return x * x + y * y < 1.0 ? 1.0 : 0.0; };
  EXPECT_NEAR(integrate2D(disk, -1.0, 1.0, -1.0, 1.0, 1e-7), pi, 1e-3) << "its slivers are missed";
}

}  // namespace
}  // namespace steradian
