#include "steradian/integrators/auxiliary/aov.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/integrators/render/render.h"
#include "steradian/tests/integrators/small_scenes.h"

namespace steradian {
namespace {

/// A red unit sphere in a sky of radiance 1.
const Scene& redSphere() {
  static const Scene scene([] {
    SceneDescription s = test::sphereInSky(LambertMaterial{});
    std::get<LambertMaterial>(s.materials[0].model).reflectance = s.addColour({0.8f, 0.2f, 0.1f});
    return s;
  }());
  return scene;
}

/// The integrator's sample for the ray from z = 4 towards (x, y, 0).
PixelSample look(const RadianceIntegrator& integrator, float x, float y) {
  const Ray<float> ray{{0, 0, 4}, normalize(Vec3f{x, y, -4.0f})};
  const auto prepared = integrator.prepare(redSphere(), {});
  PathCounts counts;
  return dynamic_cast<const PreparedSampleIntegrator&>(*prepared).evaluate(ray, Sampler<float>({}, 0, 0), counts);
}

TEST(NormalIntegrator, ShowsTheNormalAndTheSky) {
  const PixelSample middle = look(NormalIntegrator(), 0, 0);
  EXPECT_NEAR(middle.radiance.r, 0.5f, 1e-6);
  EXPECT_NEAR(middle.radiance.g, 0.5f, 1e-6);
  EXPECT_NEAR(middle.radiance.b, 1.0f, 1e-6);
  const PixelSample sky = look(NormalIntegrator(), 3, 0);
  EXPECT_EQ(sky.radiance.r, 1.0f);
  EXPECT_EQ(sky.alpha, 0.0f);
}

TEST(AlbedoIntegrator, ShowsTheColour) {
  EXPECT_FLOAT_EQ(look(AlbedoIntegrator(), 0.2f, 0.1f).radiance.r, 0.8f);
  EXPECT_FLOAT_EQ(look(AlbedoIntegrator(), 0.2f, 0.1f).radiance.b, 0.1f);
  EXPECT_EQ(look(AlbedoIntegrator(), 3, 0).radiance.r, 0.0f);
}

TEST(DepthIntegrator, ShowsTheDistance) {
  EXPECT_NEAR(look(DepthIntegrator(), 0, 0).radiance.g, 3.0f, 1e-5);
  EXPECT_EQ(look(DepthIntegrator(), 3, 0).radiance.g, 0.0f);
  EXPECT_EQ(look(DepthIntegrator(), 3, 0).depth, kInfinity);
}

TEST(EveryRadianceIntegrator, TellsTheFirstHitUnasked) {
  const PixelSample sample = look(DepthIntegrator(), 0, 0);
  EXPECT_EQ(sample.alpha, 1.0f);
  EXPECT_NEAR(sample.depth, 3.0f, 1e-5);
  EXPECT_NEAR(sample.normal.z, 1.0f, 1e-6);
  EXPECT_FLOAT_EQ(sample.albedo.g, 0.2f);
}

TEST(AmbientOcclusion, OfAFloorBesideAWallIsHalf) {
  // The corner of a floor and an endless wall hides half of the hemisphere.
  SceneDescription description = test::floorPoint();
  test::addQuad(description, {-1e-3f, 0, -50}, {0, 0, 100}, {0, 100, 0}, test::addAbsorber(description));
  const Scene scene(std::move(description));
  const RenderSettings settings = test::settingsOf(1, 1, 4096);
  const auto openness = [&](float distance) {
    return render(scene, AmbientOcclusionIntegrator(distance), settings).film.luminanceEstimate(0, 0).mean;
  };
  EXPECT_NEAR(openness(kInfinity), 0.5, 0.01);
  EXPECT_NEAR(openness(5e-4f), 1.0, 1e-6);  // the wall is farther away than that
}

}  // namespace
}  // namespace steradian
