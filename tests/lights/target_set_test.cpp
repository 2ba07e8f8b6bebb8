#include "steradian/lights/target_set.h"

#include <gtest/gtest.h>

#include "steradian/tests/lights/light_scenes.h"

namespace steradian {
namespace {

using namespace steradian::test;

/// A light of two primitives, a glass sphere, and boxes in a group of two instances.
SceneDescription sampleScene() {
  SceneDescription scene;
  QuadSet squares = ceilingSquare(1.0f, 3.0f);
  squares.add({5, 3, 5}, {3, 0, 0}, {0, 0, 1});
  addEmitter(scene, squares, grey(1.0f), false, "lamp");
  scene.addShape("glass", sphere({0, 1.5f, 0}, 0.5f), kNone);
  scene.addShape("boxes", box({0, 0, 0}, {0.5f, 0.5f, 0.5f}, 0.0f), kNone);
  scene.groups.push_back({"town", {2}});
  Matrix left, right;
  left.translate(toImath({-4.0f, 0.0f, 0.0f}));
  right.translate(toImath({4.0f, 0.0f, 0.0f}));
  scene.instances.push_back({0, {left, right}, {}});
  return scene;
}

const ScatterPoint<float> kFrom = pointAt({0.1f, 0.0f, 0.1f});
/// The density of one shape alone.
template <class Shape>
float alone(const Shape& shape, Vec3f wi) {
  return SampledShape(shape).pdfDirection(kFrom.position, wi);
}

TEST(TargetSet, DefaultsToTheLightsByPower) {
  const SceneDescription scene = sampleScene();
  const TargetSet targets(scene);
  EXPECT_EQ(targets.size(), 2u);
  const Vec3f up{0, 1, 0};
  EXPECT_FLOAT_EQ(targets.pdfDirection(kFrom, up),
                  0.25f * alone(Quad<float>{{-0.5f, 3, -0.5f}, {1, 0, 0}, {0, 0, 1}}, up));
  EXPECT_EQ(targets.pdfDirection(kFrom, normalize(Vec3f{1, 0.1f, 0})), 0.0f);
}

TEST(TargetSet, FlaggedShapesReplaceTheLights) {
  SceneDescription scene = sampleScene();
  scene.shapes[1].target = true;
  const TargetSet targets(scene);
  EXPECT_EQ(targets.size(), 1u);
  const Vec3f up{0, 1, 0};
  EXPECT_FLOAT_EQ(targets.pdfDirection(kFrom, up), alone(Sphere<float>{{0, 1.5f, 0}, 0.5f}, up));
}

TEST(TargetSet, LightsAreLeftOutIfTheyAreSampledOtherwise) {
  SceneDescription scene = sampleScene();
  constexpr auto nonEmitters = TargetSet::Unnamed::FlaggedNonEmitters;
  EXPECT_TRUE(TargetSet(scene, {}, nonEmitters).empty());
  for (ShapeDescription& shape : scene.shapes) shape.target = shape.emission != kNone;
  EXPECT_TRUE(TargetSet(scene, {}, nonEmitters).empty());
  scene.shapes[1].target = true;
  EXPECT_EQ(TargetSet(scene, {}, nonEmitters).size(), 1u);
  EXPECT_GT(TargetSet(scene).size(), 1u);
  const std::vector<std::string> names{"lights"};
  EXPECT_EQ(TargetSet(scene, names, nonEmitters).size(), 2u) << "who names them has them";
}

TEST(TargetSet, EveryLaneIsThatOfWidthOne) {
  using F = Lanes<8>;
  const SceneDescription scene = sampleScene();
  const std::vector<std::string> one{"glass"}, several{"lights", "glass", "boxes"};
  for (const auto& names : {one, several}) {
    const TargetSet targets(scene, names);
    ScatterPoint<F> from;
    LightRandom<F> random;
    Mask<8> active(true);
    active.set(5, false);
    for (int i = 0; i < 8; ++i) {
      const auto x = 0.11f * static_cast<float>(i);
      setLane(from.position, i, Vec3f{x, 0.3f * x, 0.2f - x});
      setLane(random.select, i, 0.124f * static_cast<float>(i));
      setLane(random.position, i, Vec2f{0.9f - 0.1f * x, x});
    }
    const DirectionSample<F> samples = targets.sampleDirection(from, random, active);
    const F densities = targets.pdfDirection(from, samples.wi);
    EXPECT_EQ(samples.pdf[5], 0.0f);
    for (const int i : {0, 1, 2, 3, 4, 6, 7}) {
      ScatterPoint<float> alone;
      alone.position = lane(from.position, i);
      const LightRandom<float> numbers{lane(random.select, i), lane(random.position, i)};
      const DirectionSample<float> expected = targets.sampleDirection(alone, numbers);
      EXPECT_GT(expected.pdf, 0.0f);
      EXPECT_EQ(samples.pdf[i], expected.pdf);
      EXPECT_EQ(samples.wi.x[i], expected.wi.x);
      EXPECT_EQ(samples.wi.z[i], expected.wi.z);
      EXPECT_EQ(densities[i], targets.pdfDirection(alone, expected.wi));
    }
  }
}

TEST(TargetSet, NamedObjectsShareEqually) {
  const SceneDescription scene = sampleScene();
  const std::vector<std::string> names{"lights", "glass", "boxes"};
  const TargetSet targets(scene, names);
  EXPECT_EQ(targets.size(), 5u);
  const Vec3f up{0, 1, 0};
  // The light hides behind the glass: both count.
  EXPECT_FLOAT_EQ(targets.pdfDirection(kFrom, up),
                  (0.25f * alone(Quad<float>{{-0.5f, 3, -0.5f}, {1, 0, 0}, {0, 0, 1}}, up) +
                   alone(Sphere<float>{{0, 1.5f, 0}, 0.5f}, up)) /
                      3.0f);
  const Vec3f right{1, 0, 0};
  const Box<float> boxThere{{4, 0, 0}, {0.5f, 0.5f, 0.5f}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  EXPECT_NEAR(targets.pdfDirection(kFrom, right), 0.5f / 3.0f * alone(boxThere, right), 1e-5f);
}

TEST(TargetSet, UnknownNamesAreErrors) {
  const SceneDescription scene = sampleScene();
  const std::vector<std::string> names{"lights", "glas"};
  try {
    const TargetSet targets(scene, names);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    EXPECT_NE(std::string(error.what()).find("\"glas\""), std::string::npos) << error.what();
    EXPECT_EQ(error.diagnostics()[0].suggestion, "glass");
  }
}

TEST(TargetSet, MayBeEmpty) {
  EXPECT_TRUE(TargetSet(SceneDescription{}).empty());
  SceneDescription dark;
  addEmitter(dark, ceilingSquare(1.0f, 1.0f), grey(0.0f));
  const TargetSet targets(dark);
  EXPECT_TRUE(targets.empty());
  EXPECT_EQ(targets.sampleDirection(kFrom, lightRandom(0)).pdf, 0.0f);
  EXPECT_EQ(targets.pdfDirection(kFrom, {0, 1, 0}), 0.0f);
}

}  // namespace
}  // namespace steradian
