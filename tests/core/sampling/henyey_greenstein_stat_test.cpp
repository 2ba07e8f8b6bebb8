#include "steradian/core/sampling/henyey_greenstein.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "steradian/tests/support/proof.h"

namespace steradian {
namespace {

using namespace test;

TEST(HenyeyGreensteinStatistics, AllAsymmetries) {
  for (const float g : {0.0f, 1e-6f, -1e-3f, 0.3f, -0.7f, 0.9f, -0.99f, 0.999f, -0.9999f, 0.999999f}) {
    CheckOptions options;
    options.grid.axis.z = g < 0.0f ? -1.0f : 1.0f;
    const double narrow = 3.0 * (1.0 - std::abs(static_cast<double>(g)));
    if (narrow < 1.0) options.grid.focus = narrow;
    EXPECT_TRUE(prove([g](auto f) { return HenyeyGreenstein<decltype(f)>{decltype(f)(g)}; }, options)) << g;
  }
}

TEST(HenyeyGreensteinStatistics, MeanCosineIsG) {
  for (const float g : {-0.8f, 0.0f, 0.35f, 0.95f}) {
    RunningMean mean;
    for (std::uint32_t i = 0; i < 100000; ++i) {
      const auto words = randomWords(i, 3u, 5u, 7u);
      const Vec2f u{toUnitFloat<float>(words[0]), toUnitFloat<float>(words[1])};
      mean.add(static_cast<double>(HenyeyGreenstein<float>{g}.sample(u).z));
    }
    EXPECT_GT(zTestPValue(mean.mean(), mean.standardError(), static_cast<double>(g), 1e-6), suiteLevel()) << g;
  }
}

}  // namespace
}  // namespace steradian
