#include "steradian/integrators/render/integrator.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

#include "steradian/integrators/make_integrator.h"
#include "steradian/integrators/render/render.h"
#include "steradian/tests/integrators/small_scenes.h"

namespace steradian {
namespace {

TEST(Integrator, WhatIsPreparedIsNeverNull) {
  const Scene scene(test::room());
  for (const IntegratorInfo& info : integratorRegistry()) {
    const IntegratorChoice choice = makeIntegrator(info.name);
    for (const std::uint32_t width : {0u, 1u, 4u, 8u, 16u}) {
      const auto prepared = choice.integrator->prepare(scene, {.width = width});
      ASSERT_NE(prepared, nullptr) << info.name;
      EXPECT_EQ(prepared->correlatedPixels(), 1u);
    }
  }
  EXPECT_EQ(makeIntegrator("path:reuse=8").integrator->prepare(scene, {})->correlatedPixels(), 8u);
}

/// The example of integrator.h, counting what it prepares.
class FadeIntegrator final : public RadianceIntegratorWith<Bounds3> {
 public:
  mutable std::atomic<int> timesPrepared = 0;

  Bounds3 prepareRadiance(const Scene& scene) const override {
    ++timesPrepared;
    return scene.geometry().bounds();
  }
  Rgb radiance(const Scene& scene, const Bounds3& bounds, const Ray<float>& ray, const Sampler<float>&) const override {
    const PixelSample hit = traceFirstHit(scene, ray);
    return grey(hit.alpha > 0.0f ? 1.0f - minimum(hit.depth / length(bounds.extent()), 1.0f) : 0.0f);
  }
};

TEST(RadianceIntegratorWith, PreparesOncePerRender) {
  // A unit sphere, which is seen over the whole picture.
  const Scene scene(test::sphereInSky(DielectricMaterial{1.5f, false}));
  const FadeIntegrator integrator;
  RenderSettings settings = test::settingsOf(6, 6, 7);
  const RenderResult result = render(scene, integrator, settings);
  EXPECT_GT(result.statistics.passes, 1u);
  EXPECT_EQ(integrator.timesPrepared, 1);
  const auto& description = std::get<PerspectiveCamera>(scene.description().camera);
  const double distance = static_cast<double>(length(description.lookFrom - description.lookAt)) - 1.0;
  EXPECT_NEAR(result.film.luminanceEstimate(3, 3).mean, 1.0 - distance / std::sqrt(12.0), 0.05);
  EXPECT_EQ(result.film.radiance(3, 3).r, render(scene, integrator, settings).film.radiance(3, 3).r);
  EXPECT_EQ(integrator.timesPrepared, 2);
}

/// Prepared data that can be neither copied nor moved, and is destroyed when the render ends.
struct Guard {
  explicit Guard(int& alive) : alive_(alive) { ++alive_; }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
  ~Guard() { --alive_; }

 private:
  int& alive_;
};

class Guarded final : public RadianceIntegratorWith<Guard> {
 public:
  mutable int alive = 0;

  Guard prepareRadiance(const Scene&) const override { return Guard(alive); }
  Rgb radiance(const Scene&, const Guard&, const Ray<float>&, const Sampler<float>&) const override {
    return grey(static_cast<float>(alive));
  }
};

TEST(RadianceIntegratorWith, KeepsWhatItPreparedAsLongAsTheRender) {
  const Scene scene{SceneDescription{}};
  const Guarded integrator;
  EXPECT_EQ(render(scene, integrator, test::settingsOf(2, 2, 1)).film.radiance(0, 0).r, 1.0f);
  EXPECT_EQ(integrator.alive, 0);
}

class Refusing final : public RadianceIntegratorWith<int> {
 public:
  int prepareRadiance(const Scene&) const override { throw Error(ErrorKind::Usage, "not this scene"); }
  Rgb radiance(const Scene&, const int&, const Ray<float>&, const Sampler<float>&) const override { return {}; }
};

TEST(RadianceIntegratorWith, MayRefuseAScene) {
  EXPECT_THROW(render(Scene{SceneDescription{}}, Refusing(), test::settingsOf(2, 2, 1)), Error);
}

}  // namespace
}  // namespace steradian
