#include "steradian/materials/texture.h"

#include <gtest/gtest.h>

namespace steradian {
namespace {

SurfacePoint<float> at(Vec3f position, Vec2f uv = {}) {
  SurfacePoint<float> point;
  point.position = position;
  point.geometricNormal = {0, 1, 0};
  point.uv = uv;
  return point;
}

TEST(TextureSet, Constants) {
  SceneDescription scene;
  const Id red = scene.addColour({0.7f, 0.1f, 0.1f});
  const TextureSet textures(scene.textures);
  EXPECT_EQ(textures.value(red, at({1, 2, 3})).r, 0.7f);
  EXPECT_EQ(textures.constant(red)->g, 0.1f);
  EXPECT_EQ(textures.value(kNone, at({})).r, 0.0f);
  EXPECT_EQ(textures.constant(kNone)->r, 0.0f);
}

TEST(TextureSet, WorldCheckerAlternatesAlongEachAxis) {
  SceneDescription scene;
  const Id white = scene.addColour(grey(1.0f)), black = scene.addColour(grey(0.0f));
  const Id checker = scene.addTexture(CheckerTexture{white, black, 0.5f});
  const TextureSet textures(scene.textures);
  const auto value = [&](Vec3f p) { return textures.value(checker, at(p)).r; };
  EXPECT_EQ(value({0.1f, 0.1f, 0.1f}), 1.0f);
  EXPECT_EQ(value({0.6f, 0.1f, 0.1f}), 0.0f);
  EXPECT_EQ(value({0.1f, 0.6f, 0.1f}), 0.0f);
  EXPECT_EQ(value({0.1f, 0.1f, 0.6f}), 0.0f);
  EXPECT_EQ(value({0.6f, 0.6f, 0.1f}), 1.0f);
  EXPECT_EQ(value({-0.1f, 0.1f, 0.1f}), 0.0f);
  EXPECT_EQ(value({-0.1f, -0.1f, -0.1f}), 0.0f);
  EXPECT_EQ(value({-0.6f, 0.1f, 0.1f}), 1.0f);
  EXPECT_EQ(value({1e20f, 0.1f, 0.1f}), 1.0f);  // beyond every integer: floats there are even
  EXPECT_FALSE(textures.constant(checker).has_value());
}

// A floor at y = 0 lies in the boundary of two cells: rounding must not decide.
TEST(TextureSet, WorldCheckerTakesTheMatterBelowTheSurface) {
  SceneDescription scene;
  const Id white = scene.addColour(grey(1.0f)), black = scene.addColour(grey(0.0f));
  const Id checker = scene.addTexture(CheckerTexture{white, black, 1.0f});
  const TextureSet textures(scene.textures);
  for (const float y : {-1e-5f, -1e-9f, 0.0f, 1e-9f, 1e-5f}) {
    SurfacePoint<float> point = at({0.5f, y, 0.5f});
    point.positionError = {1e-5f, 1e-5f, 1e-5f};
    EXPECT_EQ(textures.value(checker, point).r, 0.0f) << y;
    point.geometricNormal = {0, -1, 0};
    EXPECT_EQ(textures.value(checker, point).r, 1.0f) << y;
  }
}

TEST(TextureSet, UvCheckerAndNesting) {
  SceneDescription scene;
  const Id white = scene.addColour(grey(1.0f)), black = scene.addColour(grey(0.0f)), mid = scene.addColour(grey(0.5f));
  const Id inner = scene.addTexture(CheckerTexture{white, black, 8.0f, CheckerTexture::Space::Uv});
  const Id outer = scene.addTexture(CheckerTexture{inner, mid, 2.0f, CheckerTexture::Space::Uv});
  const TextureSet textures(scene.textures);
  const auto value = [&](float u, float v) { return textures.value(outer, at({}, {u, v})).r; };
  EXPECT_EQ(value(0.01f, 0.01f), 1.0f);
  EXPECT_EQ(value(0.15f, 0.01f), 0.0f);
  EXPECT_EQ(value(0.15f, 0.15f), 1.0f);
  EXPECT_EQ(value(0.6f, 0.1f), 0.5f);
  EXPECT_EQ(value(0.99f, 0.99f), 1.0f);
}

TEST(TextureSet, ImagesReadUvAndNoiseThePosition) {
  SceneDescription scene;
  auto image = std::make_shared<Image>(2, 1, std::vector<std::string>{"R", "G", "B"});
  image->at(1, 0, 1) = 0.5f;
  const Id picture = scene.addTexture(ImageTexture{.image = image, .filter = ImageTexture::Filter::Nearest});
  const NoiseTexture marble{.colour = {1.0f, 0.5f, 0.25f}, .scale = 2.0f};
  const Id noise = scene.addTexture(marble);
  const Id chosen = scene.addTexture(CheckerTexture{picture, noise, 1.0f});
  const TextureSet textures(scene.textures);
  EXPECT_EQ(textures.value(picture, at({}, {0.75f, 0.5f})).g, 0.5f);
  EXPECT_EQ(textures.value(picture, at({}, {0.25f, 0.5f})).g, 0.0f);
  const Vec3f p{1.3f, 0.2f, 0.7f};
  EXPECT_EQ(textures.value(noise, at(p)).g, NoisePattern(marble).value(p).g);
  EXPECT_EQ(textures.value(chosen, at(p)).g, NoisePattern(marble).value(p).g);
  EXPECT_EQ(textures.value(chosen, at({0.3f, 0.2f, 0.7f}, {0.75f, 0.5f})).g, 0.5f);
  EXPECT_FALSE(textures.constant(picture).has_value());
  EXPECT_FALSE(textures.constant(noise).has_value());
  EXPECT_EQ(textures.noise(picture), nullptr);
  EXPECT_NE(textures.noise(noise), nullptr);
  EXPECT_EQ(textures.noise(kNone), nullptr);
}

TEST(TextureSet, KnowsWhichTexturesReadUv) {
  SceneDescription scene;
  const Id white = scene.addColour(grey(1.0f));
  const Id noise = scene.addTexture(NoiseTexture{});
  const Id picture =
      scene.addTexture(ImageTexture{.image = std::make_shared<const Image>(1, 1, std::vector<std::string>{"Y"})});
  const Id solid = scene.addTexture(CheckerTexture{white, noise, 1.0f});
  const Id uv = scene.addTexture(CheckerTexture{white, noise, 1.0f, CheckerTexture::Space::Uv});
  const Id nested = scene.addTexture(CheckerTexture{solid, picture, 1.0f});
  const TextureSet textures(scene.textures);
  for (const Id id : {white, noise, solid, kNone}) EXPECT_FALSE(textures.readsUv(id)) << id;
  for (const Id id : {picture, uv, nested}) EXPECT_TRUE(textures.readsUv(id)) << id;
}

}  // namespace
}  // namespace steradian
