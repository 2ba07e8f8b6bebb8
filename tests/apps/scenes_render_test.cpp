/// The built-in scenes, rendered: each shows something, in the same bits for any number of threads; the strategies
/// agree on the Cornell boxes of book 3.
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <string>

#include "steradian/apps/scenes/builders.h"
#include "steradian/apps/scenes/scenes.h"
#include "steradian/core/image/image_metrics.h"
#include "steradian/integrators/make_integrator.h"
#include "steradian/integrators/render/render.h"
#include "steradian/integrators/scene/scene.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

Image renderScene(const char* name, const std::string& integrator, const RenderSettings& settings) {
  const Scene scene(makeScene(name));
  return render(scene, *makeIntegrator(integrator).integrator, settings).film.image();
}

class EveryScene : public testing::TestWithParam<const char*> {};

TEST_P(EveryScene, ShowsSomethingInTheSameBitsForAnyNumberOfThreads) {
  const RenderSettings settings{.width = 64, .height = 48, .samplesPerPixel = 4};
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 3);
  const auto renderWith = [&](int threads) {
    tbb::task_arena arena(threads);
    return arena.execute([&] { return renderScene(GetParam(), "path", settings); });
  };
  const Image one = renderWith(1), three = renderWith(3);
  EXPECT_TRUE(std::equal(one.values().begin(), one.values().end(), three.values().begin()));
  EXPECT_EQ(countNonFinite(one), 0u);
  for (const double mean : channelMeans(one)) {
    EXPECT_GT(mean, 0.02);
    EXPECT_LT(mean, 2.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, EveryScene,
                         testing::Values("one-weekend", "one-weekend-materials", "one-weekend-picture:18",
                                         "checkered-spheres", "earth", "perlin-spheres", "quads", "simple-light",
                                         "cornell-original", "cornell-smoke", "cornell-uniform-diffuse", "cornell-box",
                                         "next-week-final", "nested-glass", "door-crack", "cornell-aluminium",
                                         "cornell-glass-sphere", "cornell-city:3000", "cornell-tower:9"));

// Embree's instance of the cube, and its spheres one by one.
TEST(NextWeekFinal, IsTheSameWithAndWithoutInstances) {
  const RenderSettings settings{.width = 96, .height = 96, .samplesPerPixel = 16};
  const auto picture = [&](bool instanced) {
    const Scene scene(scenes::nextWeekFinal(instanced));
    return render(scene, *makeIntegrator("path").integrator, settings).film.image();
  };
  // Rounding changes a few paths.
  EXPECT_LT(relMSE(picture(false), picture(true)), 1e-3);
}

class CornellTrio : public testing::TestWithParam<const char*> {};

TEST_P(CornellTrio, StrategiesAgree) {
  RenderSettings settings{.width = 48, .height = 48, .samplesPerPixel = 256, .replicates = 8};
  // One error rate for the nine comparisons of the three scenes together.
  const ZTestSettings together{.alpha = test::sidakLevel(test::kSuiteLevel, 9)};
  settings.seed = 1;
  const Image mis = renderScene(GetParam(), "path:strategy=mis", settings);
  for (const char* strategy : {"bsdf", "light", "mixture"}) {
    ++settings.seed;  // independent noise
    const Image other = renderScene(GetParam(), std::string("path:strategy=") + strategy, settings);
    const ZTestResult z = zTest(other, &other, mis, &mis, together);
    EXPECT_EQ(z.knownBlocks, z.blockCount());
    EXPECT_TRUE(z.passed) << strategy << ": block " << z.worstBlock << ", z " << z.worstZ << ", limit " << z.threshold
                          << "; picture z " << z.imageZ << "; p " << z.pValue;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, CornellTrio,
                         testing::Values("cornell-box", "cornell-aluminium", "cornell-glass-sphere"));

}  // namespace
}  // namespace steradian
