#include "steradian/integrators/path/wide_path.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <limits>
#include <string>

#include "steradian/apps/scenes/scenes.h"
#include "steradian/integrators/path/path.h"
#include "steradian/integrators/render/render.h"
#include "steradian/tests/integrators/moving_scenes.h"
#include "steradian/tests/integrators/small_scenes.h"
#include "steradian/tests/integrators/wide_rendering.h"

namespace steradian {
namespace {

using test::everythingRoom;
using test::expectEqual;
using test::kFlat;
using test::openScene;
using test::plainRoom;
using test::Rendered;
using test::renderWith;
using test::settingsOf;

/// Textures in space, for which all lanes are tested at once as well, and with `picture` one over (u, v).
SceneDescription texturedRoom(bool picture) {
  SceneDescription s = everythingRoom();
  Id texture = s.addTexture(NoiseTexture{.colour = {0.9f, 0.7f, 0.5f}, .scale = 5.0f});
  test::addBox(s, {0.0f, 0.5f, -0.4f}, {0.3f, 0.1f, 0.2f}, 10.0f, s.addMaterial("marble", LambertMaterial{texture}));
  if (!picture) return s;
  Image image(4, 3, {"R", "G", "B"});
  for (std::size_t i = 0; i < image.values().size(); ++i) image.values()[i] = 0.02f * static_cast<float>(i + 1);
  texture = s.addTexture(ImageTexture{.image = std::make_shared<const Image>(image), .repeatU = 2.5f});
  test::addSphere(s, {0.6f, 0.4f, -0.2f}, 0.25f, s.addMaterial("picture", LambertMaterial{texture}));
  return s;
}

/// Media of every kind, and bodies within one another.
SceneDescription smokyScene() {
  SceneDescription s = everythingRoom();
  const Id air = s.addMaterial("air", InterfaceMaterial{});
  s.shapes[test::addBox(s, {0.0f, 0.4f, 0.0f}, {0.6f, 0.3f, 0.6f}, 20.0f, air)].interior = Interior{s.addMedium(
      {.name = "smoke", .absorption = {0.5f, 1.0f, 0.2f}, .scattering = {2.0f, 1.0f, 4.0f}, .anisotropy = 0.4f})};
  s.shapes[test::addSphere(s, {0.1f, 0.3f, 0.0f}, 0.3f, air)].interior =
      Interior{s.addMedium({.name = "fire", .absorption = grey(1.0f), .emission = {2.0f, 1.0f, 0.3f}}), 1};
  const Id glass = s.addMaterial("nested", DielectricMaterial{1.4f, false});
  s.shapes[test::addSphere(s, {-0.3f, 0.0f, 0.5f}, 0.25f, glass)].interior = Interior{kNone, 2};
  const Id water = s.addMaterial("water", DielectricMaterial{1.3f, true});
  s.shapes[test::addSphere(s, {-0.1f, 0.0f, 0.5f}, 0.25f, water)].interior =
      Interior{s.addMedium({.name = "milk", .scattering = grey(3.0f), .anisotropy = -0.2f}), 1};
  return s;
}

/// Whether all widths give the picture and the counts of width 1.
void expectEqualWidths(const Scene& scene, const std::string& integrator, const RenderSettings& settings) {
  const Rendered one = renderWith(scene, integrator + ":width=1", settings);
  double sum = 0.0;
  for (const float v : one.values) sum += std::isfinite(v) ? static_cast<double>(v) : 0.0;
  EXPECT_GT(sum, 0.0) << integrator;
  for (const char* width : {"0", "4", "8", "16"}) {
    expectEqual(renderWith(scene, integrator + ":width=" + width, settings), one, integrator + ", width " + width);
  }
}

TEST(WidePath, EqualsWidthOneForEveryStrategy) {
  const Scene plain(plainRoom(), kFlat), textured(everythingRoom()), open(openScene()), smoky(smokyScene(), kFlat);
  const Scene inSpace(texturedRoom(false), kFlat), byUv(texturedRoom(true), kFlat);
  const Scene sky(test::underAnEnvironmentMap());
  ASSERT_NE(plain.geometry().flat(), nullptr);
  for (const char* strategy : {"bsdf", "light", "mis", "mixture"}) {
    const std::string integrator = std::string("path:strategy=") + strategy;
    for (const Scene* scene : {&plain, &textured, &open, &smoky, &inSpace, &byUv, &sky})
      expectEqualWidths(*scene, integrator, settingsOf(13, 11, 8));
  }
}

// Spheres, boxes, a mesh and the place where they stand; with lights among them, or sampled besides.
TEST(WidePath, EqualsWidthOneWithTargets) {
  SceneDescription room = everythingRoom(), smoke = smokyScene();
  for (const Id shape : {1u, 2u, 6u, 8u}) room.shapes[shape].target = smoke.shapes[shape].target = true;
  const Scene withTargets(room, kFlat), inSmoke(smoke, kFlat), moving(test::movingLights());
  for (const char* integrator :
       {"path", "path:target-weight=0.7:light-samples=2", "path:strategy=mixture", "path:targets=lights,turned",
        "path:strategy=mixture:targets=lights,turned,disk:target-weight=1"}) {
    for (const Scene* scene : {&withTargets, &inSmoke}) expectEqualWidths(*scene, integrator, settingsOf(11, 9, 4));
  }
  for (const char* integrator : {"path:targets=lights", "path:strategy=mixture"}) {
    expectEqualWidths(moving, integrator, settingsOf(11, 9, 4));
  }
}

TEST(WidePath, EqualsWidthOneForEverySetting) {
  const Scene scene(plainRoom(), kFlat);
  for (const char* integrator :
       {"path:max-depth=0", "path:max-depth=1", "path:light-samples=3", "path:roulette-start=0",
        "path:roulette-start=1:roulette-strength=0.5", "path:roulette-strength=0:max-depth=20",
        "path:scatter-pdf=cosine", "path:scatter-pdf=sphere:strategy=bsdf", "path:strategy=light:light-samples=2",
        "path:strategy=mixture:targets=lights:target-weight=0.3"}) {
    expectEqualWidths(scene, integrator, settingsOf(7, 9, 6));
  }
}

TEST(WidePath, EqualsWidthOneInMedia) {
  SceneDescription fog = openScene();
  fog.outside = fog.addMedium({.name = "fog", .scattering = {0.1f, 0.2f, 0.3f}});
  for (const SceneDescription& description : {smokyScene(), makeScene("nested-glass")}) {
    expectEqualWidths(Scene(description), "path:light-samples=2", settingsOf(9, 9, 4));
  }
  expectEqualWidths(Scene(fog), "path", settingsOf(9, 9, 4));
  SceneDescription empty;  // but for the fog
  empty.outside = empty.addMedium({.name = "fog", .scattering = grey(0.5f)});
  empty.addLight("bulb", PointLight{{0.0f, 0.0f, -2.0f}, grey(1.0f)});
  expectEqualWidths(Scene(empty), "path", settingsOf(9, 9, 4));
}

TEST(WidePath, EqualsWidthOneForEverySamplerFilterAndCrop) {
  const Scene scene(plainRoom(), kFlat);
  for (const SamplerType sampler : {SamplerType::Independent, SamplerType::Stratified, SamplerType::Sobol}) {
    RenderSettings settings = settingsOf(9, 7, 6, 3);
    settings.sampler = sampler;
    settings.replicates = 2;
    settings.filter = Filter(FilterType::Mitchell);
    settings.crop = Crop{2, 8, 1, 6};
    settings.tileSize = 4;
    expectEqualWidths(scene, "path", settings);
  }
}

TEST(WidePath, EqualsWidthOneWithAndWithoutAHierarchy) {
  for (const char* name : {"one-weekend", "cornell-city:200", "cornell-tower:3", "simple-light", "earth"}) {
    for (const std::uint32_t maxClustersWithoutTree : {64u, 0u}) {
      const Scene scene(makeScene(name),
                        {.geometry = {.accel = {.maxClustersWithoutTree = maxClustersWithoutTree}}, .lights = {}});
      expectEqualWidths(scene, "path", settingsOf(16, 9, 3));
    }
  }
}

/// Paths of one packet are at times of their own.
TEST(WidePath, EqualsWidthOneInMotion) {
  const Scene flat(test::flyingSphere(), kFlat), lights(test::movingLights()), all(test::everythingMoves());
  ASSERT_NE(flat.geometry().flat(), nullptr);
  const Scene deep(test::everythingMoves(), {.geometry = {.accel = {.maxClustersWithoutTree = 0}}, .lights = {}});
  for (const char* strategy : {"bsdf", "light", "mis", "mixture"}) {
    const std::string integrator = std::string("path:strategy=") + strategy;
    for (const Scene* scene : {&flat, &lights, &all, &deep}) {
      expectEqualWidths(*scene, integrator, settingsOf(13, 11, 8));
    }
  }
  for (const std::uint32_t maxClustersWithoutTree : {64u, 0u}) {
    const Scene spheres(makeScene("bouncing-spheres"),
                        {.geometry = {.accel = {.maxClustersWithoutTree = maxClustersWithoutTree}}, .lights = {}});
    expectEqualWidths(spheres, "path", settingsOf(16, 9, 3));
  }
  expectEqual(renderWith(deep, "path", settingsOf(13, 11, 8)), renderWith(all, "path", settingsOf(13, 11, 8)),
              "with and without a hierarchy of its own");
}

TEST(WidePath, MotionIsTheSameForAnyNumberOfThreads) {
  const tbb::global_control allowed(tbb::global_control::max_allowed_parallelism, 4);  // also on smaller machines
  const Scene scene(test::everythingMoves());
  RenderSettings settings = settingsOf(20, 15, 4);
  settings.tileSize = 4;
  const auto with = [&](int threads) {
    tbb::task_arena arena(threads);
    return arena.execute([&] { return renderWith(scene, "path", settings); });
  };
  expectEqual(with(4), with(1), "4 threads");
}

TEST(WidePath, IsTheSameForEveryInstructionSet) {
  const auto scene = [](int which) {
    if (which == 0) return plainRoom();
    if (which == 1) return everythingRoom();
    if (which == 2) return openScene();
    if (which == 5) return test::everythingMoves();
    if (which == 6) return smokyScene();
    return makeScene(which == 3 ? "one-weekend" : "cornell-tower:3");
  };
  for (const int which : {0, 1, 2, 3, 4, 5, 6}) {
    const auto rendered = [&](Isa isa, const char* width) {
      const SceneSettings settings{.geometry = {.accel = {.maxClustersWithoutTree = which == 0 ? 64u : 4u}, .isa = isa},
                                   .lights = {}};
      RenderSettings renderSettings = settingsOf(13, 11, 4);
      renderSettings.execution.isa = isa;
      return renderWith(Scene(scene(which), settings), std::string("path:width=") + width, renderSettings);
    };
    const Rendered baseline = rendered(Isa::Baseline, "1");
    for (const Isa isa : compiledIsas()) {
      if (!isUsable(isa)) continue;
      for (const char* width : {"0", "1", "4", "8", "16"}) {
        expectEqual(rendered(isa, width), baseline,
                    "scene " + std::to_string(which) + ", " + std::string(nameOf(isa)) + ", width " + width);
      }
    }
  }
}

TEST(WidePath, TheInstructionSetMustBeUsable) {
  const Scene empty{SceneDescription{}};
  for (const Isa isa : {Isa::Baseline, Isa::Avx2, Isa::Avx512}) {
    const SceneSettings settings{.geometry = {.isa = isa}, .lights = {}};
    if (isUsable(isa)) {
      EXPECT_NO_THROW(Scene({}, settings));
      EXPECT_NO_THROW(PathIntegrator().prepare(empty, {.isa = isa}));
    } else {
      EXPECT_THROW(Scene({}, settings), Error);
      EXPECT_THROW(PathIntegrator().prepare(empty, {.isa = isa}), Error);
    }
  }
}

TEST(WidePath, AnEmptySceneIsBlack) {
  const Scene scene{SceneDescription{}};
  const Rendered result = renderWith(scene, "path", settingsOf(3, 3, 2));
  EXPECT_EQ(result.counts.cameraRays, 18u);
  EXPECT_EQ(result.counts.bounceRays, 0u);
}

/// A lane without a path may hold anything.
TEST(WidePath, IdleLanesDoNotMatter) {
  const Scene scene(plainRoom(), kFlat);
  const WideScene wide(scene);
  using F = Lanes<8>;
  Mask<8> active(false);
  for (const int i : {1, 4, 6}) active.set(i, true);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Ray<F> ray{{F(nan), F(kInfinity), F(0.1f)}, {F(0.0f), F(nan), F(0.0f)}};
  for (const int i : {1, 4, 6}) {
    setLane(ray, i, {{0.1f * static_cast<float>(i), 0.0f, 0.9f}, normalize(Vec3f{0.1f, -0.2f, -1.0f})});
  }
  const SurfacePoint<F> points = wide.intersect(ray, active);
  EXPECT_EQ(laneBits(points.valid), laneBits(active));
  for (const int i : {1, 4, 6}) {
    const Ray<float> one = lane(ray, i);
    const SurfacePoint<float> expected = scene.geometry().surfacePoint(one, scene.geometry().intersect(one));
    EXPECT_EQ(lane(points, i).position.x, expected.position.x);
    EXPECT_EQ(lane(points, i).shape, expected.shape);
  }
  EXPECT_EQ(laneBits(wide.occluded(ray, active)), laneBits(active));
}

}  // namespace
}  // namespace steradian
