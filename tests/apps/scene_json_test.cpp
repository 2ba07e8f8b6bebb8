#include "steradian/apps/steradian/scene_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "steradian/apps/scenes/scenes.h"

namespace steradian::app {
namespace {

using nlohmann::json;

TEST(SceneJson, TheCornellBoxCanBeBuiltFromIt) {
  const json scene = toJson(makeScene("cornell-box"));
  EXPECT_EQ(scene["name"], "cornell-box");
  EXPECT_EQ(scene["camera"]["type"], "perspective");
  EXPECT_EQ(scene["camera"]["lookFrom"], json({278, 278, -800}));
  EXPECT_EQ(scene["camera"]["verticalFov"], 40);
  EXPECT_EQ(scene["counts"], json({{"box", 2}, {"quad", 6}}));
  EXPECT_EQ(scene["defaults"]["maxDepth"], 49);
  const auto light = std::find_if(scene["shapes"].begin(), scene["shapes"].end(),
                                  [](const json& shape) { return shape["emission"].is_number(); });
  ASSERT_NE(light, scene["shapes"].end());
  EXPECT_EQ(scene["emissions"][(*light)["emission"].get<std::size_t>()]["radiance"], json({15, 15, 15}));
  EXPECT_EQ((*light)["type"], "quad");
  EXPECT_EQ((*light)["cornerY"], json::array({554}));
}

TEST(SceneJson, ReferencesResolve) {
  const json scene = toJson(makeScene("cornell-glass-sphere"));
  std::size_t targets = 0;
  for (const json& shape : scene["shapes"]) {
    EXPECT_LT(shape["material"].get<std::size_t>(), scene["materials"].size());
    targets += shape["target"].get<bool>() ? 1 : 0;
  }
  EXPECT_EQ(targets, 2u);
  for (const json& material : scene["materials"]) {
    const json reflectance = material.value("reflectance", json(0));
    EXPECT_LT(reflectance.get<std::size_t>(), scene["textures"].size());
  }
}

TEST(SceneJson, NumbersAreTheShortestThatReadBackAsTheSameFloat) {
  SceneDescription scene;
  scene.textures.emplace_back(ConstantTexture{{0.65f, 0.05f, 1.0f / 3.0f}});
  SphereSet spheres;
  spheres.add({0.1f, -0.7f, 1e-20f}, 16777216.0f);
  scene.addShape("ball", spheres, kNone);
  const std::string text = toJson(scene).dump();
  EXPECT_NE(text.find("[0.65,0.05,0.33333334]"), std::string::npos) << text;
  EXPECT_NE(text.find("\"centerY\":[-0.7]"), std::string::npos) << text;
  const json back = json::parse(text);
  EXPECT_EQ(back["textures"][0]["value"][2].get<float>(), 1.0f / 3.0f);
  EXPECT_EQ(back["shapes"][0]["centerZ"][0].get<float>(), 1e-20f);
  EXPECT_EQ(back["shapes"][0]["radius"][0].get<float>(), 16777216.0f);
}

TEST(SceneJson, CountsWhatInstancesMultiply) {
  const SceneDescription tower = makeScene("cornell-tower:9");
  EXPECT_EQ(countPrimitives(tower), (std::map<std::string, std::uint64_t>{{"box", 18}, {"quad", 54}}));
  const json scene = toJson(tower);
  EXPECT_EQ(scene["instances"][0]["transforms"].size(), 9u);
  EXPECT_EQ(scene["instances"][0]["transforms"][1][3], json({565, 0, 0, 1}))
      << "row vectors: translation in the last row";
}

TEST(SceneJson, EveryKindIsThere) {
  SceneDescription scene;
  scene.materials = {{"a", AbsorberMaterial{}, {}},
                     {"b", MetalMaterial{0, 0.3f}, {}},
                     {"c", DielectricMaterial{1.5f, true}, {}},
                     {"d", CoatedMaterial{0, 1.7f}, {}}};
  scene.lights = {{"p", PointLight{}, {}},
                  {"s", SpotLight{}, {}},
                  {"d", DistantLight{}, {}},
                  {"c", ConstantSky{}, {}},
                  {"g", GradientSky{}, {}}};
  scene.camera = SphericalCamera{};
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.indices = {0, 1, 2};
  scene.addShape("mesh", mesh, 0);
  const json out = toJson(scene);
  const auto typesOf = [](const json& list) {
    std::vector<std::string> types;
    for (const json& item : list) types.push_back(item["type"]);
    return types;
  };
  EXPECT_EQ(typesOf(out["materials"]), (std::vector<std::string>{"absorber", "metal", "dielectric", "coated"}));
  EXPECT_EQ(typesOf(out["lights"]),
            (std::vector<std::string>{"point", "spot", "distant", "constant sky", "gradient sky"}));
  EXPECT_EQ(out["materials"][1]["fuzz"].dump(), "0.3");
  EXPECT_EQ(out["camera"]["type"], "spherical");
  EXPECT_EQ(out["shapes"][0]["indices"], json({0, 1, 2}));
}

}  // namespace
}  // namespace steradian::app
