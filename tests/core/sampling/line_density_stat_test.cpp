#include "steradian/core/sampling/line_density.h"

#include <gtest/gtest.h>

#include <utility>

#include "steradian/tests/support/proof.h"

namespace steradian {
namespace {

using namespace test;

TEST(LineDensityStatistics, Linear) {
  for (const auto& [a, b] : {std::pair{0.0f, 1.0f}, std::pair{1.0f, 0.0f}, std::pair{2.0f, 2.0f},
                             std::pair{1.0f, 1.0001f}, std::pair{3.0f, 1.0f}, std::pair{1e18f, 1.0f}}) {
    const auto make = [a = a, b = b](auto f) {
      using F = decltype(f);
      return LinearDensity<F>{F(-1.0f), F(2.0f), F(a), F(b)};
    };
    EXPECT_TRUE(prove(make, {.domain = {-1.0, 2.0, 0.0, 1.0}})) << a << ' ' << b;
  }
}

TEST(LineDensityStatistics, Powers) {
  for (const float n : {0.0f, 1.0f, 2.0f, 7.5f, -0.5f}) {
    const auto make = [n](auto f) { return PowerDensity<decltype(f)>{decltype(f)(2.0f), decltype(f)(n)}; };
    EXPECT_TRUE(prove(make, {.domain = {0.0, 2.0, 0.0, 1.0}, .inverseTolerance = 1e-5})) << n;
  }
}

}  // namespace
}  // namespace steradian
