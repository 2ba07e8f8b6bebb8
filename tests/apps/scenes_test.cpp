#include "steradian/apps/scenes/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "steradian/core/samplers/rng.h"

namespace steradian {
namespace {

TEST(Scenes, AllAreValid) {
  for (const SceneInfo& info : builtInScenes()) {
    std::string spec(info.name);
    if (spec.ends_with(":N")) spec.replace(spec.size() - 1, 1, "10");
    SCOPED_TRACE(spec);
    const SceneDescription scene = makeScene(spec);
    EXPECT_EQ(scene.name, spec);
    EXPECT_TRUE(validate(scene).empty()) << validate(scene).format();
    EXPECT_FALSE(info.summary.empty());
  }
}

TEST(Scenes, UnknownNamesAreRefusedWithTheNearestOne) {
  try {
    makeScene("cornel-box");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Usage);
    EXPECT_EQ(error.diagnostics()[0].suggestion, "cornell-box");
  }
}

TEST(Scenes, CountsAreChecked) {
  for (const char* bad : {"cornell-city", "cornell-city:", "cornell-city:0", "cornell-city:-1", "cornell-city:1e6",
                          "cornell-city:99999999999", "cornell-city:3x", "cornell-box:2", "one-weekend-picture:3",
                          "one-weekend-picture:24"}) {
    SCOPED_TRACE(bad);
    EXPECT_THROW(makeScene(bad), Error);
  }
}

TEST(Scenes, EveryPictureOfOneWeekendIsValid) {
  for (int picture = 4; picture <= 23; ++picture) {
    SCOPED_TRACE(picture);
    const SceneDescription scene = makeScene("one-weekend-picture:" + std::to_string(picture));
    EXPECT_TRUE(validate(scene).empty()) << validate(scene).format();
  }
}

TEST(Scenes, TheUniformBoxDiffersFromTheOriginalInItsSurfacesAlone) {
  const SceneDescription uniform = makeScene("cornell-uniform-diffuse"), original = makeScene("cornell-original");
  ASSERT_EQ(uniform.materials.size(), original.materials.size());
  for (std::size_t i = 0; i < original.materials.size(); ++i) {
    const auto* lambert = std::get_if<LambertMaterial>(&original.materials[i].model);
    const auto* hemisphere = std::get_if<UniformDiffuseMaterial>(&uniform.materials[i].model);
    ASSERT_EQ(hemisphere != nullptr, lambert != nullptr);
    EXPECT_TRUE(lambert == nullptr || hemisphere->reflectance == lambert->reflectance);
  }
}

TEST(Scenes, OneWeekendHasTheBooksPopulation) {
  const SceneDescription scene = makeScene("one-weekend");
  const auto& spheres = std::get<SphereSet>(scene.shapes.at(0).geometry);
  // 22 x 22 cells less those near the bronze sphere, the ground and three large ones.
  EXPECT_EQ(spheres.radius.size(), 484u);
  for (std::size_t i = 1; i + 3 < spheres.radius.size(); ++i) {
    EXPECT_EQ(spheres.radius[i], 0.2f);
    EXPECT_GT(length(Vec3f{spheres.centerX[i], 0.2f, spheres.centerZ[i]} - Vec3f{4.0f, 0.2f, 0.0f}), 0.9f);
  }
}

TEST(Scenes, TheNextWeekHasItsTextures) {
  const auto texture = [](const char* name, std::size_t i) { return makeScene(name).textures.at(i); };
  EXPECT_EQ(std::get<CheckerTexture>(texture("checkered-spheres", 2)).scale, 0.32f);
  for (const char* name : {"perlin-spheres", "simple-light"}) {
    const auto noise = std::get<NoiseTexture>(texture(name, 0));
    EXPECT_EQ(noise.scale, 4.0f);
    EXPECT_EQ(noise.octaves, 7);
    EXPECT_EQ(noise.pattern, NoiseTexture::Pattern::Marble);
  }
  EXPECT_EQ(std::get<ImageTexture>(texture("earth", 0)).image->width(), 1024);
}

TEST(Scenes, BouncingSpheresAreTheCoverWithMatteSpheresRising) {
  const SceneDescription cover = makeScene("one-weekend"), scene = makeScene("bouncing-spheres");
  const auto& still = std::get<SphereSet>(cover.shapes.at(0).geometry);
  const auto& spheres = std::get<SphereSet>(scene.shapes.at(0).geometry);
  ASSERT_EQ(spheres.radius, still.radius);
  ASSERT_EQ(spheres.moveY.size(), 484u);
  int rising = 0;
  for (std::size_t i = 0; i < spheres.radius.size(); ++i) {
    const std::string& material = scene.materials[scene.shapes[0].primitiveMaterials[i]].name;
    const float move = spheres.moveY[i];
    EXPECT_EQ(spheres.moveX[i] + spheres.moveZ[i], 0.0f);
    EXPECT_GE(move, 0.0f);
    EXPECT_LT(move, 0.5f);
    if (material != "matte") {
      EXPECT_EQ(move, 0.0f);
    }
    rising += move > 0.0f ? 1 : 0;
  }
  EXPECT_GT(rising, 350);
}

TEST(Scenes, CityBoxesDoNotOverlapAndStandOnTheFloor) {
  const SceneDescription scene = makeScene("cornell-city:1000");
  const auto& city = std::get<BoxSet>(scene.shapes.back().geometry);
  ASSERT_EQ(city.centerX.size(), 1000u);
  const float cell = 555.0f / 32.0f;
  for (std::size_t i = 0; i < 1000; ++i) {
    EXPECT_LT(std::hypot(city.halfX[i], city.halfZ[i]), 0.46f * cell);
    EXPECT_EQ(city.centerY[i], city.halfY[i]);
    EXPECT_GT(city.centerX[i], 0.0f);
    EXPECT_LT(city.centerX[i], 555.0f);
    EXPECT_LT(city.centerZ[i], 555.0f);
  }
}

TEST(Scenes, CityIsTheFormulaOfItsHeader) {
  const SceneDescription scene = makeScene("cornell-city:7");
  const auto& city = std::get<BoxSet>(scene.shapes.back().geometry);
  const auto words = randomWords<std::uint32_t>(5, 0, 0, 0x63697479u);
  EXPECT_FLOAT_EQ(city.halfX[5], 0.5f * 185.0f * (0.3f + 0.35f * toUnitFloat<float>(words[0])));
  EXPECT_FLOAT_EQ(city.centerX[5], 185.0f * 2.5f);
  EXPECT_FLOAT_EQ(city.centerZ[5], 185.0f * 1.5f);
}

TEST(Scenes, TowerOfOneIsTheCornellBox) {
  const SceneDescription tower = makeScene("cornell-tower:1"), box = makeScene("cornell-box");
  const auto& a = std::get<PerspectiveCamera>(tower.camera);
  const auto& b = std::get<PerspectiveCamera>(box.camera);
  EXPECT_EQ(length(a.lookFrom - b.lookFrom), 0.0f);
  EXPECT_EQ(tower.groups.at(0).shapes.size(), box.shapes.size());
}

TEST(Scenes, TowerRoomsAreApart) {
  const SceneDescription tower = makeScene("cornell-tower:5");
  const auto& rooms = tower.instances.at(0).transforms;
  ASSERT_EQ(rooms.size(), 5u);
  for (std::size_t i = 0; i < rooms.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(std::max(std::abs(rooms[i][3][0] - rooms[j][3][0]), std::abs(rooms[i][3][1] - rooms[j][3][1])), 565.0f);
}

TEST(Scenes, BooksTurnBoxesAsRotateYDoes) {
  // rotate_y: x' = cos x + sin z, z' = -sin x + cos z; the tall box's corner (165, 0, 0) goes to (265 + 165 cos 15,
  // 0, 295 - 165 sin 15).
  const SceneDescription scene = makeScene("cornell-box");
  for (const ShapeDescription& shape : scene.shapes) {
    if (shape.name != "tall box") continue;
    const auto& box = std::get<BoxSet>(shape.geometry);
    const float w = box.rotationW[0], y = box.rotationY[0];
    const float cosine = w * w - y * y, sine = 2.0f * w * y;
    const Vec3f corner{box.centerX[0] + cosine * 82.5f - sine * 82.5f, 0.0f,
                       box.centerZ[0] - sine * 82.5f - cosine * 82.5f};
    EXPECT_NEAR(corner.x, 265.0 + 165.0 * std::cos(15.0 * 3.14159265358979 / 180.0), 1e-3);
    EXPECT_NEAR(corner.z, 295.0 - 165.0 * std::sin(15.0 * 3.14159265358979 / 180.0), 1e-3);
    return;
  }
  FAIL() << "no tall box";
}

}  // namespace
}  // namespace steradian
