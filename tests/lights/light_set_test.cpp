#include "steradian/lights/light_set.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "steradian/tests/lights/environment_maps.h"
#include "steradian/tests/lights/light_scenes.h"

namespace steradian {
namespace {

using namespace steradian::test;

const Rgb kRadiance{3.0f, 2.0f, 1.0f};

/// The hit at the end of a sample towards primitive `primitive` of a shape.
SurfacePoint<float> hitAlong(const LightSet& lights, const ScatterPoint<float>& from, const LightSample<float>& s,
                             SurfacePoint<float> ids) {
  ids.valid = true;
  const std::size_t light = *lights.areas().find(ids);
  ids.position = from.position + s.wi * s.distance;
  ids.geometricNormal = lights.areas()[light].shape().normalAt(ids.position, from.time);
  return ids;
}

void expectSampleIsEmission(const ShapeGeometry& geometry, const ScatterPoint<float>& from, bool twoSided,
                            const std::optional<Motion>& motion = std::nullopt) {
  SceneDescription scene;
  const Id shape = addEmitter(scene, geometry, kRadiance, twoSided);
  scene.shapes[shape].motion = motion;
  const LightSet lights(scene, kBounds);
  ASSERT_EQ(lights.size(), 1u);
  int samples = 0;
  for (std::uint32_t i = 0; i < 300; ++i) {
    const LightSample<float> s = lights.sample(from, lightRandom(i));
    if (s.pdf == 0.0f) continue;
    ++samples;
    SurfacePoint<float> ids;
    ids.shape = shape, ids.primitive = 0;
    const Ray<float> ray = spawnRay(from, s.wi, kInfinity);
    const SurfacePoint<float> hit = hitAlong(lights, from, s, ids);
    const Emission<float> e = lights.emission(from, ray, hit);
    ASSERT_NEAR(e.pdf, s.pdf, 2e-3f * s.pdf) << i;
    ASSERT_NEAR(e.radiance.r / s.pdf, s.weight.r, 1e-5f * s.weight.r);
    ASSERT_NEAR(e.radiance.b / s.pdf, s.weight.b, 1e-5f * s.weight.b);
    ASSERT_EQ(lights.radiance(ray, hit).g, kRadiance.g);
    ASSERT_NEAR(length(s.wi), 1.0f, 1e-6f);
  }
  EXPECT_GT(samples, 100);
}

TEST(LightSet, SampleIsWhatEmissionSays) {
  const ScatterPoint<float> from = pointAt({0.1f, 0.0f, 0.2f});
  expectSampleIsEmission(sphere({0, 2, 0}, 0.5f), from, false);
  expectSampleIsEmission(sphere({0, 0, 0}, 2.0f), from, true);  // from inside
  expectSampleIsEmission(ceilingSquare(1.0f, 1.0f), from, false);
  expectSampleIsEmission(disk({0, 1, 0}, {0, -1, 0}, 0.5f), from, false);
  expectSampleIsEmission(box({0.5f, 2, 0.5f}, {0.5f, 0.4f, 0.3f}, 30.0f), from, false);
  TriangleMesh one = mesh();
  one.indices.resize(3);
  expectSampleIsEmission(one, from, false);
}

TEST(LightSet, SampleIsWhatEmissionSaysOfLightsInMotion) {
  ScatterPoint<float> from = pointAt({0.1f, 0.0f, 0.2f});
  Motion motion;
  motion.close.setEulerAngles(Imath::V3f(0.0f, 0.8f, 0.3f));
  Matrix stretch;
  stretch.setScale(Imath::V3f(1.5f, 1.0f, 1.2f));
  motion.close = motion.close * stretch;
  motion.close[3][0] = 0.3f;
  motion.close[3][1] = 0.5f;
  TriangleMesh one = mesh();
  one.indices.resize(3);
  for (const float time : {0.0f, 0.3f, 0.9f}) {
    from.time = time;
    for (const ShapeGeometry& geometry :
         {ShapeGeometry(sphere({0, 2, 0}, 0.5f)), ShapeGeometry(one), ShapeGeometry(ceilingSquare(1.0f, 1.0f)),
          ShapeGeometry(disk({0, 1, 0}, {0, -1, 0}, 0.5f)),
          ShapeGeometry(box({0.5f, 2, 0.5f}, {0.5f, 0.4f, 0.3f}, 30.0f))}) {
      expectSampleIsEmission(geometry, from, false, motion);
    }
  }
}

TEST(LightSet, BackFacesOfOneSidedLightsAreBlack) {
  for (const bool twoSided : {false, true}) {
    SceneDescription scene;
    const Id shape = addEmitter(scene, ceilingSquare(1.0f, 1.0f), kRadiance, twoSided);
    const LightSet lights(scene, kBounds);
    const ScatterPoint<float> above = pointAt({0, 2, 0});
    const LightSample<float> s = lights.sample(above, lightRandom(1));
    EXPECT_EQ(s.pdf > 0.0f, twoSided);
    EXPECT_EQ(s.weight.r > 0.0f, twoSided);
    SurfacePoint<float> hit;
    hit.valid = true;
    hit.position = {0, 1, 0};
    hit.geometricNormal = {0, -1, 0};
    hit.shape = shape, hit.primitive = 0;
    const Emission<float> e = lights.emission(above, {above.position, {0, -1, 0}}, hit);
    EXPECT_EQ(e.radiance.r, twoSided ? 3.0f : 0.0f);
    EXPECT_EQ(e.pdf > 0.0f, twoSided);
    EXPECT_EQ(lights.radiance({above.position, {0, -1, 0}}, hit).r, twoSided ? 3.0f : 0.0f);
    // The inside of a sphere is its back.
    SceneDescription ball;
    addEmitter(ball, sphere({0, 0, 0}, 2.0f), kRadiance, twoSided);
    EXPECT_EQ(LightSet(ball, kBounds).sample(pointAt({0, 0, 0}), lightRandom(2)).pdf > 0.0f, twoSided);
  }
}

// A shadow ray must end before the emitter, but only by the rounding error.
TEST(LightSet, DistanceStopsShortOfTheEmitter) {
  for (const float scale : {1e-3f, 1.0f, 555.0f, 1e6f}) {
    SceneDescription scene;
    addEmitter(scene, quad({-scale, scale, -scale}, {2.0f * scale, 0, 0}, {0, 0, 2.0f * scale}), kRadiance);
    const LightSet lights(scene, kBounds);
    const ScatterPoint<float> from = pointAt({0.3f * scale, 0.1f * scale, -0.2f * scale});
    for (std::uint32_t i = 0; i < 200; ++i) {
      const LightSample<float> s = lights.sample(from, lightRandom(i));
      const float exact = 0.9f * scale / s.wi.y;
      ASSERT_LT(s.distance, exact * (1.0f - 1e-7f));
      ASSERT_GT(s.distance, exact * (1.0f - 1e-4f));
      const Ray<float> shadow = spawnRay(from, s.wi, s.distance);
      const Quad<float> emitter{{-scale, scale, -scale}, {2.0f * scale, 0, 0}, {0, 0, 2.0f * scale}};
      ASSERT_FALSE(intersect(emitter, shadow).valid);
    }
  }
}

TEST(LightSet, FindsLightsOfInstancesAndPrimitives) {
  SceneDescription scene;
  const Id lamp = addEmitter(scene, mesh(), kRadiance, false, "lamp");
  const Id wall = scene.addShape("wall", ceilingSquare(1.0f, 3.0f), kNone);
  scene.groups.push_back({"room", {wall, lamp}});
  const Id direct = addEmitter(scene, sphere({0, 5, 0}, 1.0f), kRadiance, false, "ball");
  Matrix moved, scaled;
  moved.translate(toImath({10.0f, 0.0f, 0.0f}));
  scaled.scale(toImath({2.0f, 2.0f, 2.0f}));
  scene.instances.push_back({0, {Matrix(), moved}, {}});
  scene.instances.push_back({0, {scaled}, {}});
  const LightSet lights(scene, kBounds);
  ASSERT_EQ(lights.size(), 7u);  // 2 triangles in 3 instances, and the ball

  const auto find = [&](Id shape, Id primitive, Id instance) {
    SurfacePoint<float> hit;
    hit.valid = true;
    hit.shape = shape, hit.primitive = primitive, hit.instance = instance;
    return lights.areas().find(hit);
  };
  EXPECT_FALSE(find(wall, 0, 0).has_value());
  EXPECT_FALSE(find(wall, 0, kNone).has_value());
  EXPECT_EQ(*find(direct, 0, kNone), 0u);
  EXPECT_EQ(*find(lamp, 1, 0), 2u);
  EXPECT_EQ(*find(lamp, 0, 1), 3u);
  EXPECT_EQ(*find(lamp, 1, 2), 6u);
  EXPECT_EQ(lights.areas().shapeOf(6), lamp);
  const auto area = [&](Id instance) { return lights.areas()[*find(lamp, 0, instance)].shape().area(); };
  EXPECT_NEAR(area(1), area(0), 1e-5f);
  EXPECT_NEAR(area(2), 4.0f * area(0), 1e-4f);
  const Vec3f there = lights.areas()[*find(lamp, 0, 1)].shape().samplePosition({0.3f, 0.3f}).position;
  EXPECT_GT(there.x, 8.9f);
}

TEST(LightSet, FindsEveryPrimitiveOfAShape) {
  SceneDescription scene;
  addEmitter(scene, sphere({0, 5, 0}, 1.0f), kRadiance);
  QuadSet squares = ceilingSquare(1.0f, 1.0f);
  squares.add({4, 1, 0}, {2, 0, 0}, {0, 0, 2});
  squares.add({8, 1, 0}, {3, 0, 0}, {0, 0, 3});
  const Id shape = addEmitter(scene, squares, kRadiance);
  const LightSet lights(scene, kBounds);
  for (Id primitive = 0; primitive < 3; ++primitive) {
    SurfacePoint<float> hit;
    hit.valid = true;
    hit.shape = shape, hit.primitive = primitive;
    const float edge = static_cast<float>(primitive) + 1.0f;
    EXPECT_FLOAT_EQ(lights.areas()[*lights.areas().find(hit)].shape().area(), edge * edge);
  }
}

TEST(LightSet, SelectsByPower) {
  SceneDescription scene;
  addEmitter(scene, ceilingSquare(1.0f, 1.0f), grey(1.0f), false, "square");     // pi
  addEmitter(scene, ceilingSquare(1.0f, 2.0f), grey(1.0f), true, "both sides");  // 2 pi
  addEmitter(scene, ceilingSquare(1.0f, 3.0f), grey(0.0f), false, "off");        // 0
  scene.lights.push_back({"bulb", PointLight{{0, 3, 0}, grey(1.0f)}, {}});       // 4 pi
  scene.lights.push_back({"dark", PointLight{{0, 3, 0}, grey(0.0f)}, {}});       // 0
  scene.lights.push_back({"sun", DistantLight{{0, -2, 0}, grey(1.0f)}, {}});     // pi r^2 = 3 pi
  scene.lights.push_back({"", ConstantSky{grey(1.0f)}, {}});                     // 4 pi^2 r^2
  const LightSet lights(scene, kBounds, {.sampleSkies = true});
  EXPECT_EQ(lights.size(), 7u);
  ASSERT_EQ(lights.info().size(), 7u);
  const float total = (1.0f + 2.0f + 4.0f + 3.0f + 4.0f * kPi * 3.0f) * kPi;
  const auto share = [&](std::size_t i) { return lights.info()[i].probability; };
  EXPECT_NEAR(share(0), kPi / total, 1e-6f);
  EXPECT_NEAR(share(1), 2.0f * kPi / total, 1e-6f);
  EXPECT_EQ(share(2), 0.0f);
  EXPECT_NEAR(share(3), 4.0f * kPi / total, 1e-6f);
  EXPECT_EQ(share(4), 0.0f);
  EXPECT_NEAR(share(5), 3.0f * kPi / total, 1e-6f);
  EXPECT_NEAR(share(6), 12.0f * kPi * kPi / total, 1e-5f);
  EXPECT_EQ(lights.info()[0].kind, "quad");
  EXPECT_EQ(lights.info()[1].name, "both sides");
  EXPECT_EQ(lights.info()[6].kind, "sky");
}

TEST(LightSet, SettingsSayWhatIsSampled) {
  SceneDescription scene;
  const Id shape = addEmitter(scene, ceilingSquare(1.0f, 1.0f), kRadiance);
  scene.lights.push_back({"", ConstantSky{grey(2.0f)}, {}});
  const ScatterPoint<float> from = pointAt({0, 0, 0});
  const Ray<float> up{{0, 0, 0}, {0, 1, 0}};
  SurfacePoint<float> onLight, sky;
  onLight.valid = true;
  onLight.geometricNormal = {0, -1, 0};
  onLight.shape = shape, onLight.primitive = 0;

  const LightSet usual(scene, kBounds);
  EXPECT_EQ(usual.emission(from, up, sky).radiance.r, 2.0f);
  EXPECT_EQ(usual.emission(from, up, sky).pdf, 0.0f);
  EXPECT_GT(usual.emission(from, up, onLight).pdf, 0.0f);

  const LightSet none(scene, kBounds, {.sampleAreas = false});
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.sample(from, lightRandom(0)).pdf, 0.0f);
  EXPECT_EQ(none.emission(from, up, onLight).radiance.r, 3.0f);
  EXPECT_EQ(none.emission(from, up, onLight).pdf, 0.0f);

  const LightSet both(scene, kBounds, {.sampleSkies = true});
  EXPECT_NEAR(both.emission(from, up, sky).pdf, both.info()[1].probability * kInvTwoPi, 1e-7f);
  ScatterPoint<float> free = from;
  free.geometricNormal = {};
  EXPECT_NEAR(both.emission(free, up, sky).pdf, both.info()[1].probability * kInvFourPi, 1e-7f);
}

TEST(LightSet, SharesItsLightsWithSetsOfOtherSettings) {
  SceneDescription scene;
  const Id shape = addEmitter(scene, ceilingSquare(1.0f, 1.0f), kRadiance);
  scene.lights.push_back({"", PointLight{{0.5f, 0.5f, 0}, {8.0f, 4.0f, 2.0f}}, {}});
  scene.lights.push_back({"", ConstantSky{grey(2.0f)}, {}});
  scene.lights.push_back({"", ImageSky{.image = sunAt(8, 4, 3, 1, 100.0f)}, {}});
  SurfacePoint<float> onLight, sky;
  onLight.valid = true;
  onLight.geometricNormal = {0, -1, 0};
  onLight.shape = shape, onLight.primitive = 0;
  const ScatterPoint<float> from = pointAt({0, 0, 0});
  const Ray<float> up{{0, 0, 0}, {0, 1, 0}};
  for (const bool areas : {false, true}) {
    for (const bool skies : {false, true}) {
      for (const bool pictures : {false, true}) {
        const LightSetSettings settings{areas, skies, pictures};
        const auto other = std::make_unique<LightSet>(scene, kBounds, LightSetSettings{!areas, !skies, !pictures});
        const LightSet shared(*other, settings), alone(scene, kBounds, settings);
        EXPECT_EQ(&shared.areas(), &other->areas());
        EXPECT_EQ(shared.size(), 3u);
        EXPECT_EQ(shared.emission(from, up, onLight).pdf, alone.emission(from, up, onLight).pdf);
        EXPECT_EQ(shared.emission(from, up, sky).pdf, alone.emission(from, up, sky).pdf);
        EXPECT_EQ(shared.emission(from, up, sky).radiance.r, alone.emission(from, up, sky).radiance.r);
        for (std::uint32_t i = 0; i < 64; ++i) {
          EXPECT_EQ(shared.sample(from, lightRandom(i)).pdf, alone.sample(from, lightRandom(i)).pdf);
        }
        ASSERT_EQ(shared.info().size(), alone.info().size());
        for (std::size_t i = 0; i < alone.info().size(); ++i) {
          EXPECT_EQ(shared.info()[i].count, alone.info()[i].count);
          EXPECT_EQ(shared.info()[i].power.r, alone.info()[i].power.r);
          EXPECT_EQ(shared.info()[i].probability, alone.info()[i].probability);
        }
      }
    }
  }
}

TEST(LightSet, AnEmptySceneIsDark) {
  const LightSet lights(SceneDescription{}, Bounds3{});
  EXPECT_TRUE(lights.empty());
  EXPECT_EQ(lights.size(), 0u);
  EXPECT_EQ(lights.sample(pointAt({}), lightRandom(0)).pdf, 0.0f);
  EXPECT_EQ(lights.emission(pointAt({}), {{}, {0, 1, 0}}, {}).radiance.g, 0.0f);
  SurfacePoint<float> hit;
  hit.valid = true;
  hit.shape = 0;
  EXPECT_EQ(lights.radiance({{}, {0, 1, 0}}, hit).g, 0.0f);
}

TEST(LightSet, SkiesAddUp) {
  SceneDescription scene;
  scene.lights.push_back({"", GradientSky{{1.0f, 1.0f, 1.0f}, {0.5f, 0.7f, 1.0f}}, {}});
  scene.lights.push_back({"", ConstantSky{grey(0.25f)}, {}});
  const LightSet lights(scene, kBounds);
  EXPECT_EQ(lights.size(), 1u);
  EXPECT_TRUE(lights.empty());
  const auto radiance = [&](Vec3f direction) { return lights.radiance({{}, direction}, {}).r; };
  EXPECT_FLOAT_EQ(radiance({0, 1, 0}), 0.75f);
  EXPECT_FLOAT_EQ(radiance({1, 0, 0}), 1.0f);
  EXPECT_FLOAT_EQ(radiance({0, -1, 0}), 1.25f);
}

TEST(LightSet, DiracLightsAreInTheSelection) {
  SceneDescription scene;
  scene.lights.push_back({"", PointLight{{0, 2, 0}, {8.0f, 4.0f, 2.0f}}, {}});
  const LightSet lights(scene, kBounds, {.sampleAreas = false});
  EXPECT_FALSE(lights.empty());
  const LightSample<float> s = lights.sample(pointAt({0, 0, 0}), lightRandom(0));
  EXPECT_EQ(s.pdf, kDirac);
  EXPECT_FLOAT_EQ(s.weight.r, 2.0f);
  EXPECT_FLOAT_EQ(s.distance, 2.0f);
}

/// Lights of every kind, a squashed ball among them; with many balls, more than are selected by a table of cumulative
/// sums.
SceneDescription manyLights(int balls) {
  SceneDescription scene;
  addEmitter(scene, ceilingSquare(1.0f, 1.0f), kRadiance);
  addEmitter(scene, disk({1, 2, 0}, {0, -1, 0}, 0.5f), kRadiance, true);
  addEmitter(scene, box({-2, 2, 0}, {0.3f, 0.5f, 0.2f}, 20.0f), kRadiance);
  addEmitter(scene, mesh(), kRadiance);
  for (int i = 0; i < balls; ++i) addEmitter(scene, sphere({0.1f * static_cast<float>(i), 3, 2}, 0.04f), kRadiance);
  const Id squashed = addEmitter(scene, sphere({0, 0, 0}, 1.0f), kRadiance);
  scene.groups.push_back({"group", {squashed}});
  Matrix matrix;
  matrix.makeIdentity();
  matrix[1][1] = 0.3f;
  matrix[3][1] = 2.0f;
  scene.instances.push_back({0, {matrix}, {}});
  scene.addLight("point", PointLight{{0, 1, 0}, grey(2.0f)});
  scene.addLight("spot", SpotLight{{0, 3, 0}, {0, -1, 0}, grey(2.0f)});
  scene.addLight("distant", DistantLight{{0, -1, 0.5f}, grey(1.0f)});
  scene.addLight("sky", ConstantSky{grey(0.5f)});
  return scene;
}

/// The same lights, of which some move.
SceneDescription manyMovingLights() {
  SceneDescription scene = manyLights(20);
  for (Id id = 0; id < scene.shapes.size(); id += 2) {
    Matrix close;
    close.setEulerAngles(Imath::V3f(0.0f, 0.3f, 0.2f * static_cast<float>(id)));
    close[3][0] = 0.3f;
    scene.shapes[id].motion = Motion{Matrix(), close};
  }
  scene.instances[0].closing = scene.instances[0].transforms;
  scene.instances[0].closing[0][3][2] = 1.0f;
  return scene;
}

TEST(LightSet, LanesAgreeWithScalars) {
  using F = Lanes<8>;
  for (const SceneDescription& scene : {manyLights(1), manyLights(300), manyMovingLights()}) {
    const LightSet lights(scene, kBounds, {.sampleAreas = true, .sampleSkies = true});
    int valid = 0;
    for (std::uint32_t round = 0; round < 400; ++round) {
      ScatterPoint<F> from;
      LightRandom<F> random;
      for (int i = 0; i < 8; ++i) {
        const LightRandom<float> r = lightRandom(8 * round + static_cast<std::uint32_t>(i));
        setLane(random.select, i, r.select);
        setLane(random.position, i, r.position);
        setLane(from.position, i, Vec3f{r.position.y - 0.5f, 0.0f, r.select - 0.5f});
        setLane(from.time, i, r.select);
        // Free points among those of surfaces.
        setLane(from.geometricNormal, i, i == 5 ? Vec3f{} : Vec3f{0.0f, 1.0f, 0.0f});
      }
      Mask<8> active(true);
      active.set(2, false);
      const LightSample<F> wide = lights.sample(from, random, active);
      EXPECT_EQ(wide.pdf[2], 0.0f);
      for (const int i : {0, 1, 3, 4, 5, 6, 7}) {
        const LightSample<float> one =
            lights.sample(lane(from, i), LightRandom<float>{lane(random.select, i), lane(random.position, i)});
        ASSERT_EQ(wide.pdf[i], one.pdf);
        if (one.pdf == 0.0f) continue;
        ++valid;
        ASSERT_EQ(wide.weight.g[i], one.weight.g);
        ASSERT_EQ(wide.wi.x[i], one.wi.x);
        ASSERT_EQ(wide.distance[i], one.distance);
      }
    }
    EXPECT_GT(valid, 1000);
  }
}

}  // namespace
}  // namespace steradian
