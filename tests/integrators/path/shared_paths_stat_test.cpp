#include <gtest/gtest.h>

#include <string>

#include "steradian/apps/scenes/scenes.h"
#include "steradian/core/image/image_metrics.h"
#include "steradian/core/statistics/running_mean.h"
#include "steradian/integrators/scene/scene.h"
#include "steradian/tests/integrators/small_scenes.h"
#include "steradian/tests/integrators/wide_rendering.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using test::pictureOf;
using test::settingsOf;

/// With other materials, by means: both take the same random numbers, so that their difference has little noise.
void expectSameMeans(const Scene& scene, const std::string& plain, const std::string& reuse, double precision) {
  constexpr std::size_t kComparisons = 10;
  RunningMean difference, brightness;
  for (std::uint32_t seed = 0; seed < 24; ++seed) {
    const RenderSettings settings = settingsOf(32, 32, 16, seed);
    const auto a = channelMeans(pictureOf(scene, plain + reuse, settings));
    const auto b = channelMeans(pictureOf(scene, plain, settings));
    difference.add(a[0] - b[0]);
    brightness.add(b[0]);
  }
  EXPECT_LT(difference.standardError(), precision * brightness.mean()) << plain;  // or the test has no power
  EXPECT_GT(test::zTestPValue(difference.mean(), difference.standardError(), 0.0, 1e-5 * brightness.mean()),
            test::sidakLevel(test::suiteLevel(), kComparisons))
      << plain << reuse << ": " << difference.mean() / brightness.mean();
}

TEST(SharedPaths, AreUnbiased) {
  const Scene coloured(test::colouredRoom()), open(test::openScene()), everything(test::everythingRoom());
  for (const auto& [keys, reuse] :
       {std::pair{"", ":reuse=8"}, {":strategy=mixture", ":reuse=16"}, {":targets=lights", ":reuse=4"}}) {
    for (const Scene* scene : {&coloured, &open, &everything}) {
      expectSameMeans(*scene, std::string("path:max-depth=8:roulette-strength=0") + keys, reuse, 0.002);
    }
  }
  // Roulette after the first vertex would change the densities of the second ones.
  expectSameMeans(coloured, "path:roulette-start=0:roulette-strength=0.6", ":reuse=8", 0.01);
}

/// Sixteen times as many paths for a pixel, where its neighbours see the same.
TEST(SharedPaths, HaveLessNoise) {
  const Scene scene(makeScene("cornell-box"));
  RenderSettings settings = settingsOf(300, 300, 512, 1);
  settings.crop = Crop{100, 164, 100, 164};
  const Image reference = pictureOf(scene, "path:reuse=16", settings);
  settings.seed = 0;
  settings.samplesPerPixel = 16;
  const double alone = relMSE(pictureOf(scene, "path", settings), reference);
  EXPECT_LT(relMSE(pictureOf(scene, "path:reuse=8", settings), reference), 0.25 * alone);
  EXPECT_LT(relMSE(pictureOf(scene, "path:reuse=16", settings), reference), 0.15 * alone);
}

}  // namespace
}  // namespace steradian
