#include "steradian/integrators/path/shared_paths.h"

#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <cmath>
#include <string>

#include "steradian/integrators/make_integrator.h"
#include "steradian/tests/integrators/moving_scenes.h"
#include "steradian/tests/integrators/small_scenes.h"
#include "steradian/tests/integrators/wide_rendering.h"

namespace steradian {
namespace {

using test::colouredRoom;
using test::expectEqual;
using test::greyRoom;
using test::kFlat;
using test::pictureOf;
using test::Rendered;
using test::renderWith;
using test::settingsOf;

TEST(SharedPaths, AreTheSameAtEveryWidth) {
  const Scene plain(test::plainRoom(), kFlat), tree(test::everythingRoom()), open(test::openScene());
  SceneDescription aimed = test::everythingRoom();
  for (const Id shape : {1u, 2u, 6u}) aimed.shapes[shape].target = true;
  const Scene targets(aimed, kFlat);
  for (const char* integrator : {"path:reuse=8", "path:reuse=2:light-samples=2", "path:reuse=32:strategy=bsdf",
                                 "path:reuse=16:strategy=mixture", "path:reuse=4:strategy=light:max-depth=2"}) {
    for (const Scene* scene : {&plain, &tree, &open, &targets}) {
      const auto with = [&](const char* width) {
        return renderWith(*scene, std::string(integrator) + ":width=" + width, settingsOf(21, 18, 11));
      };
      const Rendered eight = with("8");
      for (const char* width : {"0", "4", "16"}) expectEqual(with(width), eight, std::string(integrator) + width);
    }
  }
}

TEST(SharedPaths, AreTheSameForEveryInstructionSetCropTileAndThread) {
  const Scene scene(colouredRoom());
  RenderSettings settings = settingsOf(40, 37, 5);
  const Image whole = pictureOf(scene, "path:reuse=16", settings);
  for (const Isa isa : compiledIsas()) {
    if (!isUsable(isa)) continue;
    const Scene other(colouredRoom(), {.geometry = {.isa = isa}, .lights = {}});
    tbb::task_arena one(1);
    settings.tileSize = 5;
    settings.execution.isa = isa;
    settings.crop = Crop{3, 35, 14, 33};
    const Image part = one.execute([&] { return pictureOf(other, "path:reuse=16", settings); });
    for (int y = 14; y < 33; ++y) {
      for (int x = 3; x < 35; ++x) {
        for (int c = 0; c < 3; ++c) ASSERT_EQ(part.at(x - 3, y - 14, c), whole.at(x, y, c)) << x << " " << y;
      }
    }
  }
}

/// Where all first surfaces have one colour, the weights give the pixels of a group together what the pixel of x2 alone
/// would have: sums over groups equal those without sharing.
TEST(SharedPaths, KeepTheSumsOfGroupsOfOneColour) {
  const Scene scene(greyRoom());
  const RenderSettings settings = settingsOf(32, 32, 16);
  const Image alone = pictureOf(scene, "path:roulette-strength=0:max-depth=6", settings);
  for (const auto& [reuse, columns, rows] : {std::array{2, 2, 1}, {4, 2, 2}, {8, 4, 2}, {16, 4, 4}, {32, 8, 4}}) {
    const Image shared =
        pictureOf(scene, "path:roulette-strength=0:max-depth=6:reuse=" + std::to_string(reuse), settings);
    double change = 0.0;
    for (int y = 0; y < 32; y += rows) {
      for (int x = 0; x < 32; x += columns) {
        double before = 0.0, after = 0.0;
        for (int i = 0; i < reuse; ++i) {
          const int px = x + i % columns, py = y + i / columns;
          before += static_cast<double>(alone.at(px, py, 0));
          after += static_cast<double>(shared.at(px, py, 0));
          change += std::abs(static_cast<double>(alone.at(px, py, 0) - shared.at(px, py, 0)));
        }
        ASSERT_NEAR(after, before, 1e-4 * before) << reuse << ": " << x << " " << y;
      }
    }
    EXPECT_GT(change, 1.0) << reuse;
  }
}

TEST(SharedPaths, AreRefusedWhereTheyCannotBe) {
  for (const char* wrong :
       {"path:reuse=3", "path:reuse=0", "path:reuse=64", "path:reuse=2:width=1", "path:reuse=2:scatter-pdf=cosine"}) {
    EXPECT_THROW(makeIntegrator(wrong), Error) << wrong;
  }
  SceneDescription fog = greyRoom();
  fog.outside = fog.addMedium({.name = "fog", .scattering = grey(0.1f)});
  for (const SceneDescription& description : {fog, test::everythingMoves()}) {
    const Scene scene(description);
    EXPECT_THROW(renderWith(scene, "path:reuse=4", settingsOf(8, 8, 1)), Error);
    EXPECT_NO_THROW(renderWith(scene, "path:reuse=1", settingsOf(8, 8, 1)));
  }
}

TEST(SharedPaths, WeightsOfTheFilterCount) {
  SceneDescription s = test::room();
  s.shapes.clear();
  s.addLight("sky", GradientSky{grey(1.0f), grey(2.0f)});
  RenderSettings settings = settingsOf(16, 16, 4);
  settings.filter = Filter(FilterType::Mitchell);
  const Scene scene(s);
  expectEqual(renderWith(scene, "path:reuse=8", settings), renderWith(scene, "path", settings), "sky");
}

TEST(SharedPaths, EmptyScenesAreBlack) {
  const Rendered result = renderWith(Scene{SceneDescription{}}, "path:reuse=8", settingsOf(16, 16, 2));
  EXPECT_EQ(result.counts.cameraRays, 512u);
  EXPECT_EQ(result.counts.bounceRays + result.counts.shadowRays, 0u);
}

}  // namespace
}  // namespace steradian
