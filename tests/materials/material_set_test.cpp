#include "steradian/materials/material_set.h"

#include <gtest/gtest.h>

namespace steradian {
namespace {

SurfacePoint<float> pointOf(Id material) {
  SurfacePoint<float> point;
  point.valid = true;
  point.position = {0.25f, 0.25f, 0.25f};
  point.geometricNormal = point.shadingNormal = {0, 0, 1};
  point.material = material;
  return point;
}

const Vec3f kWo = normalize(Vec3f{0.3f, 0.2f, 0.9f});

TEST(MaterialSet, MakesTheModelsOfTheDescription) {
  SceneDescription scene;
  const Id red = scene.addColour({0.6f, 0.1f, 0.1f});
  const Id absorber = scene.addMaterial("light", AbsorberMaterial{});
  const Id lambert = scene.addMaterial("wall", LambertMaterial{red});
  const Id mirror = scene.addMaterial("mirror", MetalMaterial{red, 0.0f});
  const Id metal = scene.addMaterial("metal", MetalMaterial{red, 0.4f});
  const Id glass = scene.addMaterial("glass", DielectricMaterial{});
  const Id wood = scene.addMaterial("wood", CoatedMaterial{red, 1.5f});
  const Id uniform = scene.addMaterial("uniform", UniformDiffuseMaterial{red});
  const MaterialSet materials(scene);
  EXPECT_EQ(materials.size(), 7u);

  const auto bsdf = [&](Id id) { return materials.bsdf(pointOf(id), kWo); };
  EXPECT_EQ(bsdf(absorber).albedo(kWo).r, 0.0f);
  EXPECT_EQ(bsdf(lambert).albedo(kWo).r, 0.6f);
  EXPECT_FLOAT_EQ(bsdf(lambert).eval(kWo, {0, 0, 1}, Transport::Radiance).value.r, 0.6f * kInvPi);
  EXPECT_FLOAT_EQ(bsdf(uniform).eval(kWo, {0, 0, 1}, Transport::Radiance).value.r, 0.6f * kInvTwoPi);
  EXPECT_EQ(bsdf(mirror).diracProbability(kWo), 1.0f);
  EXPECT_EQ(bsdf(mirror).albedo(kWo).r, 0.6f);
  EXPECT_EQ(bsdf(metal).diracProbability(kWo), 0.0f);
  EXPECT_FALSE(bsdf(metal).suitsLightSampling(kWo));
  EXPECT_EQ(bsdf(glass).albedo(kWo).g, 1.0f);
  const float coat = bsdf(wood).diracProbability(kWo);
  EXPECT_GT(coat, 0.0f);
  EXPECT_LT(coat, 1.0f);
  EXPECT_EQ(bsdf(kNone).albedo(kWo).r, 0.0f);  // no material
}

// In the middle of the spectrum of fuzz, and beyond both of its ends as the books clamp it.
TEST(MaterialSet, FuzzIsClampedToOne) {
  SceneDescription scene;
  const Id white = scene.addColour(grey(1.0f));
  const Id one = scene.addMaterial("one", MetalMaterial{white, 1.0f});
  const Id three = scene.addMaterial("three", MetalMaterial{white, 3.0f});
  const MaterialSet materials(scene);
  const Vec3f wi = normalize(Vec3f{0.1f, -0.4f, 0.8f});
  EXPECT_EQ(materials.bsdf(pointOf(one), kWo).eval(kWo, wi, Transport::Radiance).pdf,
            materials.bsdf(pointOf(three), kWo).eval(kWo, wi, Transport::Radiance).pdf);
}

TEST(MaterialSet, ReadsTextures) {
  SceneDescription scene;
  const Id checker = scene.addTexture(CheckerTexture{scene.addColour(grey(0.2f)), scene.addColour(grey(0.9f)), 0.5f});
  const Id floor = scene.addMaterial("floor", LambertMaterial{checker});
  const MaterialSet materials(scene);
  SurfacePoint<float> point = pointOf(floor);
  EXPECT_EQ(materials.bsdf(point, kWo).albedo(kWo).g, 0.2f);
  point.position.x = 0.75f;
  EXPECT_EQ(materials.bsdf(point, kWo).albedo(kWo).g, 0.9f);
}

// A shading normal that turns away from the viewer, while the surface faces it, would make black pixels.
TEST(MaterialSet, UsesTheGeometricNormalWhereTheShadingNormalTurnsAway) {
  SceneDescription scene;
  const Id white = scene.addMaterial("white", LambertMaterial{scene.addColour(grey(1.0f))});
  const MaterialSet materials(scene);
  SurfacePoint<float> point = pointOf(white);
  point.shadingNormal = normalize(Vec3f{-0.9f, 0.0f, 0.4f});
  const Vec3f grazing = normalize(Vec3f{0.95f, 0.0f, 0.1f});
  EXPECT_EQ(materials.bsdf(point, grazing).shadingNormal().x, 0.0f);
  EXPECT_EQ(materials.bsdf(point, kWo).shadingNormal().x, point.shadingNormal.x);
}

}  // namespace
}  // namespace steradian
