#include "steradian/core/scene/description.h"

#include <gtest/gtest.h>

#include <cmath>

namespace steradian {
namespace {

SceneDescription sphereScene() {
  SceneDescription scene;
  const Id white = scene.addMaterial("white", LambertMaterial{scene.addColour({0.5f, 0.5f, 0.5f})});
  SphereSet set;
  set.add({0.0f, 0.0f, 0.0f}, 1.0f);
  scene.addShape("ball", std::move(set), white);
  return scene;
}

/// Number of complaints after `spoil` has changed a valid scene.
template <class Spoil>
std::size_t complaints(Spoil spoil) {
  SceneDescription scene = sphereScene();
  spoil(scene);
  return validate(scene).errorCount();
}

TEST(Description, ValidSceneHasNoComplaints) {
  EXPECT_EQ(complaints([](SceneDescription&) {}), 0u);
}

TEST(Description, EachFaultIsFound) {
  EXPECT_EQ(complaints([](auto& s) { s.shapes[0].material = 7; }), 1u);
  EXPECT_EQ(complaints([](auto& s) { s.shapes[0].emission = 0; }), 1u);
  EXPECT_EQ(complaints([](auto& s) { s.shapes[0].primitiveMaterials = {0, 0}; }), 1u);
  EXPECT_EQ(complaints([](auto& s) { std::get<SphereSet>(s.shapes[0].geometry).radius[0] = -1.0f; }), 1u);
  EXPECT_EQ(complaints([](auto& s) { std::get<SphereSet>(s.shapes[0].geometry).centerX[0] = NAN; }), 1u);
  EXPECT_EQ(complaints([](auto& s) { std::get<SphereSet>(s.shapes[0].geometry).centerX.clear(); }), 1u);
  EXPECT_EQ(complaints([](auto& s) { s.addColour({1.5f, 0.0f, 0.0f}); }), 0u) << "an unused texture may be any";
  EXPECT_EQ(complaints([](auto& s) { s.addMaterial("hot", LambertMaterial{s.addColour({1.5f, 0.0f, 0.0f})}); }), 1u);
  EXPECT_EQ(complaints([](auto& s) {
              const Id hot = s.addTexture(NoiseTexture{.colour = {1.5f, 0.0f, 0.0f}});
              s.addMaterial("nested", LambertMaterial{s.addTexture(CheckerTexture{0, hot, 1.0f})});
            }),
            1u);
  EXPECT_EQ(complaints([](auto& s) { s.addTexture(ImageTexture{}); }), 1u);
  EXPECT_EQ(complaints([](auto& s) {
              Image image(2, 2, {"Y"});
              image.at(1, 1, 0) = NAN;
              s.addTexture(ImageTexture{.image = std::make_shared<const Image>(image)});
            }),
            1u);
  EXPECT_EQ(complaints([](auto& s) { s.addMaterial("fuzzy", MetalMaterial{0, 2.0f}); }), 1u);
  EXPECT_EQ(complaints([](auto& s) { s.addMaterial("glass", DielectricMaterial{.eta = 0.0f}); }), 1u);
  EXPECT_EQ(complaints([](auto& s) { s.addTexture(CheckerTexture{.even = 0, .odd = 1}); }), 1u) << "refers to itself";
  EXPECT_EQ(complaints([](auto& s) { s.addLight("spot", SpotLight{.innerAngle = 40.0f, .outerAngle = 30.0f}); }), 2u);
  EXPECT_EQ(complaints([](auto& s) { s.addLight("sky", ConstantSky{{-1.0f, 0.0f, 0.0f}}); }), 1u);
  EXPECT_EQ(complaints([](auto& s) { s.groups.push_back({"g", {9}}); }), 1u);
  EXPECT_EQ(complaints([](auto& s) { s.instances.push_back({3, {}, {}}); }), 1u);
  EXPECT_EQ(complaints([](auto& s) { s.defaults.width = 0; }), 1u);
  EXPECT_EQ(complaints([](auto& s) { s.camera = PerspectiveCamera{.verticalFov = 180.0f}; }), 1u);
}

TEST(Description, FaultsOfMediaAreFound) {
  const auto filled = [](MediumDescription medium, Interior interior = {0, 0}) {
    return complaints([&](auto& s) {
      s.addMedium(medium);
      s.shapes[0].interior = interior;
    });
  };
  EXPECT_EQ(filled({.scattering = grey(1.0f), .anisotropy = -0.9f}), 0u);
  EXPECT_EQ(filled({.scattering = grey(-1.0f)}), 1u);
  EXPECT_EQ(filled({.absorption = grey(NAN)}), 1u);
  EXPECT_EQ(filled({.anisotropy = 1.0f}), 1u);
  EXPECT_EQ(filled({}, {1, 0}), 1u) << "no such medium";
  EXPECT_EQ(filled({}, {0, -1}), 1u) << "a priority below 0";
  EXPECT_EQ(complaints([](auto& s) {
              QuadSet quad;
              quad.add({}, {1, 0, 0}, {0, 1, 0});
              s.shapes[s.addShape("open", quad, 0)].interior = Interior{};
            }),
            1u);
  EXPECT_EQ(complaints([](auto& s) { s.outside = 0; }), 1u);
  EXPECT_EQ(complaints([](auto& s) { s.outside = s.addMedium({.absorption = grey(1.0f), .emission = grey(1.0f)}); }),
            0u);
  EXPECT_EQ(complaints([](auto& s) { s.outside = s.addMedium({.emission = {0.0f, 1.0f, 0.0f}}); }), 1u) << "infinite";
  EXPECT_EQ(complaints([](auto& s) {
              s.shapes[0].material = s.addMaterial("air", InterfaceMaterial{});
              s.setEmission(0, {grey(1.0f), false});
            }),
            1u);
}

TEST(Description, AllFaultsAtOnce) {
  EXPECT_EQ(complaints([](auto& s) {
              s.shapes[0].material = 7;
              s.defaults.width = 0;
              s.instances.push_back({3, {}, {}});
            }),
            3u);
}

TEST(Description, DegenerateQuadsBoxesDisksAndMeshesAreRefused) {
  const auto with = [](ShapeGeometry geometry) {
    return complaints([&](SceneDescription& s) { s.addShape("bad", std::move(geometry), 0); });
  };
  QuadSet flat;
  flat.add({0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {2.0f, 0.0f, 0.0f});
  EXPECT_EQ(with(flat), 1u);
  BoxSet thin;
  thin.add({0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 1.0f});
  EXPECT_EQ(with(thin), 1u);
  BoxSet mixed;
  mixed.add({0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f});
  mixed.addRotatedY({0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}, 30.0f);
  EXPECT_EQ(with(mixed), 1u);
  DiskSet skewed;
  skewed.add({0.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}, 1.0f);
  EXPECT_EQ(with(skewed), 1u);
  EXPECT_EQ(with(TriangleMesh{.positions = {{}, {}, {}}, .indices = {0, 1, 3}, .normals = {}, .uvs = {}}), 1u);
  EXPECT_EQ(with(TriangleMesh{.positions = {{}, {}, {}}, .indices = {0, 1}, .normals = {}, .uvs = {}}), 1u);
  EXPECT_EQ(with(CustomShapeSet{{nullptr}}), 1u);
}

TEST(Description, MotionsThatCannotBeAreRefused) {
  Matrix mirror, flat;
  mirror.setScale(Imath::V3f(-1.0f, 1.0f, 1.0f));
  flat.setScale(Imath::V3f(1.0f, 0.0f, 1.0f));
  const auto shape = [](const Matrix& open, const Matrix& close) {
    return complaints([&](SceneDescription& s) { s.shapes[0].motion = Motion{open, close}; });
  };
  EXPECT_EQ(shape(Matrix(), Matrix()), 0u);
  EXPECT_EQ(shape(mirror, mirror), 0u);
  EXPECT_EQ(shape(mirror, Matrix()), 1u);
  EXPECT_EQ(shape(Matrix(), flat), 1u);
  const auto instance = [](std::vector<Matrix> open, std::vector<Matrix> close) {
    return complaints([&](SceneDescription& s) {
      s.groups.push_back({"g", {0}});
      s.instances.push_back({0, std::move(open), std::move(close), {}});
    });
  };
  EXPECT_EQ(instance({Matrix(), mirror}, {Matrix(), mirror}), 0u);
  EXPECT_EQ(instance({Matrix(), mirror}, {}), 0u);
  EXPECT_EQ(instance({Matrix(), mirror}, {Matrix()}), 1u);
  EXPECT_EQ(instance({Matrix(), mirror}, {Matrix(), Matrix()}), 1u);
  EXPECT_EQ(instance({Matrix()}, {flat}), 1u);
}

TEST(Description, SingularTransformsAreRefused) {
  EXPECT_EQ(complaints([](SceneDescription& s) {
              s.groups.push_back({"g", {0}});
              Matrix flat;
              flat.setScale(Imath::V3f(1.0f, 0.0f, 1.0f));
              s.instances.push_back({0, {flat}, {}});
            }),
            1u);
}

}  // namespace
}  // namespace steradian
