#include "steradian/tests/integrators/strategies.h"

namespace steradian::test {

void expectStrategiesAgree(const SceneDescription& description, std::uint32_t samplesPerPixel, int size) {
  const Scene scene(description);
  const Estimate expected = meanOf(scene, PathIntegrator(with(Strategy::Mis)), size, samplesPerPixel, 100);
  std::uint32_t seed = 0;
  for (const Strategy strategy : kStrategies) {
    EXPECT_TRUE(agree(meanOf(scene, PathIntegrator(with(strategy)), size, samplesPerPixel, ++seed), expected)) << seed;
  }
}

void expectRadiance(const SceneDescription& description, double expected) {
  const Scene scene(description);
  for (const Strategy strategy : kStrategies) {
    EXPECT_TRUE(agree(meanOf(scene, PathIntegrator(with(strategy)), 16, 256), expected)) << static_cast<int>(strategy);
  }
}

}  // namespace steradian::test
