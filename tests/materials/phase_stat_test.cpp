#include <gtest/gtest.h>

#include "steradian/materials/phase.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using namespace test;

testing::AssertionResult checkPhase(float g, float factor) {
  const Vec3f wo = normalize(Vec3f{0.3f, -0.5f, 0.2f});
  const Phase<float> phase{g};
  CheckOptions options;
  options.grid.axis = g < 0.0f ? wo : -wo;
  return checkDirectionSampler(
      [&](float choice, Vec2f u) {
        const auto s = phase.sample(wo, {choice, u}, Transport::Radiance);
        return DirectionSample<float>{s.wi, s.pdf * factor};
      },
      [&](Vec3f wi) { return phase.eval(wo, wi, Transport::Radiance).pdf * factor; }, options);
}

TEST(PhaseStatistics, SamplesHaveTheDensityOfEval) {
  for (const float g : {-0.6f, 0.0f, 0.3f, 0.9f}) EXPECT_TRUE(checkPhase(g, 1.0f)) << g;
}

TEST(PhaseStatistics, TwoPercentAreFound) { EXPECT_FALSE(checkPhase(0.3f, 1.02f)); }

}  // namespace
}  // namespace steradian
