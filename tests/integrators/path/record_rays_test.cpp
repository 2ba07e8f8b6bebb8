#include "steradian/integrators/path/record_rays.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "steradian/integrators/path/path.h"
#include "steradian/integrators/render/render.h"
#include "steradian/tests/integrators/small_scenes.h"

namespace steradian {
namespace {

TEST(RecordRays, AreThoseThatARenderCounts) {
  const Scene scene(test::room());
  const RenderSettings settings = test::settingsOf(9, 7, 3);
  const std::vector<RecordedRay> rays = recordRays(scene, {}, settings);
  const PathCounts expected = render(scene, PathIntegrator(), settings).statistics.paths;
  const auto count = [&](RayKind kind) {
    return static_cast<std::uint64_t>(
        std::count_if(rays.begin(), rays.end(), [&](const RecordedRay& r) { return r.kind == kind; }));
  };
  EXPECT_EQ(count(RayKind::Camera), expected.cameraRays);
  EXPECT_EQ(count(RayKind::Bounce), expected.bounceRays);
  EXPECT_EQ(count(RayKind::Shadow), expected.shadowRays);
  EXPECT_EQ(rays.front().kind, RayKind::Camera);
}

TEST(RecordRays, TheReplayMeetsWhatTheRenderMet) {
  const Scene scene(test::furnace(0.5f, 1.0f));
  PathSettings path;
  path.strategy = Strategy::Bsdf;
  for (const RecordedRay& recorded : recordRays(scene, path, test::settingsOf(4, 4, 2))) {
    EXPECT_TRUE(scene.geometry().intersect(recorded.ray).valid);  // in a closed room every ray hits
  }
}

}  // namespace
}  // namespace steradian
