#include "steradian/integrators/render/rendered_image.h"

#include <gtest/gtest.h>

#include "steradian/integrators/path/path.h"
#include "steradian/integrators/scene/scene_hash.h"
#include "steradian/tests/integrators/small_scenes.h"

namespace steradian {
namespace {

TEST(RenderedImage, SaysWhereItComesFrom) {
  SceneDescription description = test::room();
  description.name = "room";
  const Scene scene(std::move(description));
  RenderSettings settings = test::settingsOf(12, 8, 2, 4000000000u);
  settings.crop = Crop{2, 7, 1, 8};
  const RenderResult result = render(scene, PathIntegrator({.reuse = 4}), settings);
  const Image image = renderedImage(result, scene);
  EXPECT_EQ(image.window(), (ImageWindow{2, 1, 12, 8}));
  const auto text = [&](const char* name) {
    const auto* value = findMetadata<std::string>(image.metadata(), name);
    return value == nullptr ? std::string("missing") : *value;
  };
  EXPECT_EQ(text("steradian.scene"), "room");
  EXPECT_EQ(text("steradian.sceneHash"), sceneHashText(scene.hash()));
  EXPECT_EQ(text("steradian.seed"), "4000000000");
  EXPECT_EQ(text("steradian.sampler"), "sobol");
  EXPECT_EQ(text("steradian.correlatedPixels"), "4");
  EXPECT_EQ(text("steradian.replicates"), "1");
  EXPECT_EQ(text("steradian.ledger"), "4000000000:0-1");
  const auto* seconds = findMetadata<double>(image.metadata(), "renderTime");
  ASSERT_NE(seconds, nullptr);
  EXPECT_GT(*seconds, 0.0);
  EXPECT_NE(findMetadata<std::vector<float>>(image.metadata(), "worldToCamera"), nullptr);
  EXPECT_NE(findMetadata<std::vector<float>>(image.metadata(), "worldToNDC"), nullptr);
}

TEST(RenderedImage, ASphericalCameraHasNoProjectionMatrix) {
  SceneDescription description = test::room();
  description.camera = SphericalCamera{};
  const Scene scene(std::move(description));
  const Image image = renderedImage(render(scene, PathIntegrator(), test::settingsOf(4, 2, 1)), scene);
  EXPECT_NE(findMetadata<std::vector<float>>(image.metadata(), "worldToCamera"), nullptr);
  EXPECT_EQ(findMetadata<std::vector<float>>(image.metadata(), "worldToNDC"), nullptr);
}

}  // namespace
}  // namespace steradian
