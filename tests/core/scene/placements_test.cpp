#include "steradian/core/scene/placements.h"

#include <gtest/gtest.h>

#include <tuple>

namespace steradian {
namespace {

Matrix shiftedTo(float x) {
  Matrix m;
  m.translate(Imath::V3f(x, 0.0f, 0.0f));
  return m;
}

/// Shapes 0 and 3 are placed directly; 1 and 2 make group 0, 2 and 4 group 1, and nothing places group 2 with shape 5.
SceneDescription grouped() {
  SceneDescription scene;
  for (const char* name : {"floor", "trunk", "leaf", "lamp", "stone", "unused"}) {
    SphereSet sphere;
    sphere.add({0, 0, 0}, 1.0f);
    scene.addShape(name, sphere, kNone);
  }
  scene.groups = {{"tree", {1, 2}}, {"heap", {4, 2}}, {"spare", {5}}};
  scene.instances.push_back({1, {shiftedTo(1.0f)}, {}});
  scene.instances.push_back({0, {}, {}});
  scene.instances.push_back({0, {shiftedTo(2.0f), shiftedTo(3.0f)}, {shiftedTo(2.0f), shiftedTo(3.5f)}});
  scene.instances.push_back({1, {shiftedTo(4.0f), shiftedTo(5.0f)}, {}});
  return scene;
}

using Place = std::tuple<Id, std::uint32_t, float>;  ///< shape, instance, x of its origin
Place placeOf(const ShapePlacement& p) {
  return {p.shape, p.instanceIndex(), p.instance ? p.instance->localToWorld()[3][0] : 0.0f};
}

TEST(Placements, AreInTheFlattenedOrder) {
  const SceneDescription scene = grouped();
  const Placements placements(scene);
  std::vector<Place> places;
  placements.forEachShape([&](const ShapePlacement& p) { places.push_back(placeOf(p)); });
  EXPECT_EQ(places, (std::vector<Place>{{0, kNone, 0.0f},
                                        {3, kNone, 0.0f},
                                        {4, 0, 1.0f},
                                        {2, 0, 1.0f},
                                        {1, 1, 2.0f},
                                        {2, 1, 2.0f},
                                        {1, 2, 3.0f},
                                        {2, 2, 3.0f},
                                        {4, 3, 4.0f},
                                        {2, 3, 4.0f},
                                        {4, 4, 5.0f},
                                        {2, 4, 5.0f}}));
}

TEST(Placements, OfOneShapeAreThoseOfAllThatAreIts) {
  const SceneDescription scene = grouped();
  const Placements placements(scene);
  for (Id shape = 0; shape < scene.shapes.size(); ++shape) {
    std::vector<Place> all, own;
    placements.forEachShape([&](const ShapePlacement& p) {
      if (p.shape == shape) all.push_back(placeOf(p));
    });
    placements.forEachPlaceOf(shape, [&](const ShapePlacement& p) { own.push_back(placeOf(p)); });
    EXPECT_EQ(own, all) << scene.shapes[shape].name;
    EXPECT_EQ(placements.countOf(shape), all.size()) << scene.shapes[shape].name;
  }
}

TEST(Placements, KnowWhatIsPlacedDirectly) {
  const SceneDescription scene = grouped();
  const Placements placements(scene);
  EXPECT_EQ(placements.directShapes(), (std::vector<Id>{0, 3}));
  for (Id shape = 0; shape < scene.shapes.size(); ++shape) {
    EXPECT_EQ(placements.isDirect(shape), shape == 0 || shape == 3);
  }
}

TEST(Placements, NumberInstancesThroughAllSets) {
  const SceneDescription scene = grouped();
  const Placements placements(scene);
  EXPECT_EQ(placements.instanceCount(), 5u);
  std::uint32_t expected = 0;
  placements.forEachInstance([&](const InstancePlacement& instance) {
    EXPECT_EQ(instance.index, expected);
    const InstancePlacement found = placements.instance(expected);
    EXPECT_EQ(found.set, instance.set);
    EXPECT_EQ(found.copy, instance.copy);
    EXPECT_EQ(found.index, instance.index);
    EXPECT_EQ(&found.where(), &instance.set->where);
    ++expected;
  });
  EXPECT_EQ(expected, 5u);
}

TEST(Placements, MoveIfTheTransformsAtBothTimesDiffer) {
  SceneDescription scene = grouped();
  const Placements placements(scene);
  std::vector<bool> moves;
  placements.forEachInstance([&](const InstancePlacement& i) { moves.push_back(i.motion().has_value()); });
  EXPECT_EQ(moves, (std::vector<bool>{false, false, true, false, false}));
  EXPECT_EQ(placements.instance(2).motion()->open, shiftedTo(3.0f));
  EXPECT_EQ(placements.instance(2).motion()->close, shiftedTo(3.5f));
  EXPECT_TRUE(placements.anyInstanceMoves());
  scene.instances[2].closing = scene.instances[2].transforms;
  EXPECT_FALSE(placements.anyInstanceMoves());
  scene.instances[2].closing.clear();
  EXPECT_FALSE(placements.anyInstanceMoves());
}

TEST(Placements, CountAShapeAsOftenAsItsGroupNamesIt) {
  SceneDescription scene = grouped();
  scene.groups[1].shapes = {4, 4};
  const Placements placements(scene);
  EXPECT_EQ(placements.countOf(4), 6u);
  std::size_t visits = 0;
  placements.forEachPlaceOf(4, [&](const ShapePlacement&) { ++visits; });
  EXPECT_EQ(visits, 6u);
}

TEST(Placements, OfNothingAreNone) {
  const SceneDescription scene;
  const Placements placements(scene);
  EXPECT_EQ(placements.instanceCount(), 0u);
  EXPECT_TRUE(placements.directShapes().empty());
  EXPECT_FALSE(placements.anyInstanceMoves());
  placements.forEachShape([](const ShapePlacement&) { FAIL(); });
}

}  // namespace
}  // namespace steradian
