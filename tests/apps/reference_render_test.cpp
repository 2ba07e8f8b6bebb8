/// Our pictures against those of an independent renderer (tests/data/reference).
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "steradian/apps/scenes/scenes.h"
#include "steradian/core/image/image_io.h"
#include "steradian/core/image/image_metrics.h"
#include "steradian/integrators/make_integrator.h"
#include "steradian/integrators/render/render.h"
#include "steradian/integrators/scene/scene.h"

namespace steradian {
namespace {

Image readReference(const std::string& name) {
  return readImage(std::filesystem::path(STERADIAN_TEST_DATA) / "reference" / name);
}

/// 128x128 with eight independent replicates, as the references were made.
Image renderScene(SceneDescription description, const char* integrator, std::uint32_t samplesPerPixel) {
  const Scene scene(std::move(description));
  RenderSettings settings;
  settings.width = settings.height = 128;
  settings.samplesPerPixel = samplesPerPixel;
  settings.replicates = 8;
  settings.seed = 20240607;
  return render(scene, *makeIntegrator(integrator).integrator, settings).film.image();
}

void setReflectance(SceneDescription& scene, const std::string& material, float reflectance) {
  for (const MaterialDescription& m : scene.materials) {
    if (m.name != material) continue;
    scene.textures[std::get<LambertMaterial>(m.model).reflectance] =
        ConstantTexture{{reflectance, reflectance, reflectance}};
    return;
  }
  FAIL() << "no material " << material;
}

/// The walls of the grey references.
SceneDescription greyed(const char* name) {
  SceneDescription scene = makeScene(name);
  setReflectance(scene, "green", 0.45f);
  setReflectance(scene, "red", 0.2f);
  return scene;
}

double luminanceMean(const Image& image) {
  const auto mean = channelMeans(image);
  return 0.2126 * mean[0] + 0.7152 * mean[1] + 0.0722 * mean[2];
}

void expectAgreement(const Image& ours, const std::string& reference, const ZTestSettings& settings = {}) {
  const Image theirs = readReference(reference + ".exr"), error = readReference(reference + ".stderr.exr");
  const ZTestResult z = zTest(ours, &ours, theirs, &error, settings);
  EXPECT_TRUE(z.passed) << "block " << z.worstBlock << " of " << z.blockCount() << ": z " << z.worstZ << ", limit "
                        << z.threshold << "; picture z " << z.imageZ << "; p " << z.pValue;
  EXPECT_NEAR(luminanceMean(ours) / luminanceMean(theirs), 1.0, 0.005);
}

SceneDescription greyCornellBox() {
  SceneDescription scene = greyed("cornell-box");
  const Id darker = scene.addMaterial("short box", LambertMaterial{scene.addColour({0.6f, 0.6f, 0.6f})});
  for (ShapeDescription& shape : scene.shapes)
    if (shape.name == "short box") shape.material = darker;
  return scene;
}

/// The grey room with a light of radiance 18, and nothing else in it.
SceneDescription emptyRoom() {
  SceneDescription scene = greyed("cornell-box");
  scene.emissions.at(0).radiance = grey(18.0f);
  std::erase_if(scene.shapes, [](const ShapeDescription& s) { return s.name == "tall box" || s.name == "short box"; });
  return scene;
}

Id addGrey(SceneDescription& scene, float reflectance) {
  return scene.addMaterial("grey", LambertMaterial{scene.addColour(grey(reflectance))});
}

SceneDescription motionRoom() {
  SceneDescription scene = emptyRoom();
  SphereSet ball;
  ball.addMoving({150.0f, 120.0f, 250.0f}, {260.0f, 160.0f, 250.0f}, 60.0f);
  scene.addShape("ball", ball, addGrey(scene, 0.7f));
  BoxSet block;
  block.add({45.0f, 100.0f, 45.0f}, {45.0f, 100.0f, 45.0f});
  Motion motion;
  motion.open.setTranslation(Imath::V3f(340.0f, 0.0f, 300.0f));
  motion.close.setTranslation(Imath::V3f(340.0f, 60.0f, 300.0f));
  scene.shapes[scene.addShape("block", block, addGrey(scene, 0.6f))].motion = motion;
  return scene;
}

/// The instances are read from the text: Translate, Rotate, Scale, ObjectInstance for each.
SceneDescription instancesRoom() {
  SceneDescription scene = emptyRoom();
  BoxSet cube;
  cube.add({20.0f, 20.0f, 20.0f}, {20.0f, 20.0f, 20.0f});
  SphereSet ball;
  ball.add({0.0f, 0.0f, 0.0f}, 22.0f);
  scene.groups = {{"cube", {scene.addShape("cube", cube, addGrey(scene, 0.7f))}},
                  {"ball", {scene.addShape("ball", ball, addGrey(scene, 0.5f))}}};
  scene.instances = {{0, {}}, {1, {}}};
  std::ifstream file(std::filesystem::path(STERADIAN_TEST_DATA) / "reference" / "instances.pbrt");
  Matrix place;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    Imath::V3f v;
    float degrees = 0.0f;
    if (word == "Rotate") words >> degrees;
    words >> v.x >> v.y >> v.z;
    // The directive before acts after this one.
    if (word == "AttributeBegin") place.makeIdentity();
    if (word == "Translate") place = Matrix().setTranslation(v) * place;
    if (word == "Rotate") place = Matrix().setAxisAngle(v, degrees * kPi / 180.0f) * place;
    if (word == "Scale") place = Matrix().setScale(v) * place;
    if (word == "ObjectInstance") scene.instances[line.find("cube") == std::string::npos].transforms.push_back(place);
  }
  return scene;
}

TEST(Reference, Motion) { expectAgreement(renderScene(motionRoom(), "path:max-depth=8", 512), "motion"); }

TEST(Reference, Instances) {
  SceneDescription scene = instancesRoom();
  ASSERT_EQ(scene.instances[0].transforms.size() + scene.instances[1].transforms.size(), 60u);
  expectAgreement(renderScene(std::move(scene), "path:max-depth=8", 384), "instances");
}

// The shutter that closes a twentieth of the time too soon.
TEST(Reference, AMotionThatEndsTooSoonIsFound) {
  SceneDescription scene = motionRoom();
  auto& ball = std::get<SphereSet>(scene.shapes[scene.shapes.size() - 2].geometry);
  ball.moveX[0] *= 0.95f;
  ball.moveY[0] *= 0.95f;
  scene.shapes.back().motion->close[3][1] *= 0.95f;
  const Image ours = renderScene(std::move(scene), "path:max-depth=8", 256);
  const Image theirs = readReference("motion.exr"), error = readReference("motion.stderr.exr");
  EXPECT_FALSE(zTest(ours, &ours, theirs, &error).passed);
}

TEST(Reference, CornellGray) { expectAgreement(renderScene(greyCornellBox(), "path", 512), "cornell_gray"); }

TEST(Reference, CornellGlassGray) {
  expectAgreement(renderScene(greyed("cornell-glass-sphere"), "path", 1024), "cornell_glass_gray");
}

TEST(Reference, CornellGlassGrayByTheBooksMixture) {
  expectAgreement(renderScene(greyed("cornell-glass-sphere"), "path:strategy=mixture", 1024), "cornell_glass_gray");
}

/// Blocks of 4 x 4 correlated pixels.
const ZTestSettings kShared{.correlatedPixelsA = 16.0};

TEST(Reference, SharedPaths) {
  expectAgreement(renderScene(greyCornellBox(), "path:reuse=16", 128), "cornell_gray", kShared);
  expectAgreement(renderScene(greyed("cornell-glass-sphere"), "path:reuse=16", 256), "cornell_glass_gray", kShared);
  expectAgreement(renderScene(instancesRoom(), "path:max-depth=8:reuse=16", 128), "instances", kShared);
}

TEST(Reference, SharedPathsTwoPercentTooBrightAreFound) {
  SceneDescription scene = greyCornellBox();
  scene.emissions.at(0).radiance *= 1.02f;
  const Image ours = renderScene(std::move(scene), "path:reuse=16", 512);
  const Image theirs = readReference("cornell_gray.exr"), error = readReference("cornell_gray.stderr.exr");
  EXPECT_FALSE(zTest(ours, &ours, theirs, &error, kShared).passed);
}

TEST(Reference, OnePercentTooBrightIsFound) {
  SceneDescription scene = greyCornellBox();
  scene.emissions.at(0).radiance *= 1.01f;
  const Image ours = renderScene(std::move(scene), "path", 512);
  const Image theirs = readReference("cornell_gray.exr"), error = readReference("cornell_gray.stderr.exr");
  EXPECT_FALSE(zTest(ours, &ours, theirs, &error).passed);
}

/// The tall box is fog, and fog fills a ball of water; `anisotropy`: of the fog.
///
/// The box stands on the floor. A ray of pbrt's that goes down inside of it hits box or floor first, depending on
/// rounding, and after the box it continues from below the floor: half of these rays are lost. Here half of the light
/// is lost, by the floor under the box.
SceneDescription foggyRoom(float anisotropy, float floorUnderBox = 0.5f * 0.73f) {
  SceneDescription scene = greyed("cornell-box");
  scene.defaults.maxDepth = 100;
  std::erase_if(scene.shapes, [](const ShapeDescription& s) { return s.name == "short box"; });
  const Id fog =
      scene.addMedium({.name = "fog", .absorption = grey(0.002f), .scattering = grey(0.02f), .anisotropy = anisotropy});
  ShapeDescription& box = scene.shapes.back();
  EXPECT_EQ(box.name, "tall box");
  box.material = scene.addMaterial("interface", InterfaceMaterial{});
  box.interior = Interior{fog};
  SphereSet ball;
  ball.add({190.0f, 90.1f, 190.0f}, 90.0f);
  const Id water = scene.addMaterial("water", DielectricMaterial{.eta = 1.33f});
  scene.shapes[scene.addShape("ball", std::move(ball), water)].interior = Interior{fog};
  QuadSet under;  // turned by 15 degrees
  under.add({265.0f, 0.01f, 295.0f}, {42.705144f, 0.0f, 159.37776f}, {159.37776f, 0.0f, -42.705144f});
  scene.addShape("under the box", std::move(under),
                 scene.addMaterial("half", LambertMaterial{scene.addColour(grey(floorUnderBox))}));
  return scene;
}

TEST(Reference, Fog) { expectAgreement(renderScene(foggyRoom(0.4f), "path", 1024), "fog"); }

TEST(Reference, OtherFogIsFound) {
  const Image theirs = readReference("fog.exr"), error = readReference("fog.stderr.exr");
  for (const SceneDescription& scene : {foggyRoom(0.35f), foggyRoom(0.4f, 0.73f)}) {
    const Image ours = renderScene(scene, "path", 256);
    EXPECT_FALSE(zTest(ours, &ours, theirs, &error).passed);
  }
}

/// The checkerboard of 8 x 4 cells: a picture of as many pixels, bright in the lower left corner.
Id addCheckerboard(SceneDescription& scene) {
  Image cells(8, 4, {"Y"});
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 8; ++x) cells.at(x, 3 - y, 0) = (x + y) % 2 == 0 ? 0.8f : 0.1f;
  }
  const Id texture = scene.addTexture(
      ImageTexture{.image = std::make_shared<const Image>(std::move(cells)), .filter = ImageTexture::Filter::Nearest});
  return scene.addMaterial("checkerboard", LambertMaterial{texture});
}

/// A floor with uv of its own, and a sphere whose pole is turned; `mirrored`: u runs the wrong way.
SceneDescription texturedRoom(bool mirrored = false) {
  SceneDescription scene = greyed("cornell-box");
  scene.defaults.maxDepth = 8;
  std::erase_if(scene.shapes, [](const ShapeDescription& s) { return s.name.ends_with("box") || s.name == "floor"; });
  const Id checkerboard = addCheckerboard(scene);
  TriangleMesh floor;
  floor.positions = {{0, 0, 0}, {555, 0, 0}, {555, 0, 555}, {0, 0, 555}};
  floor.indices = {0, 1, 2, 0, 2, 3};
  floor.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  if (mirrored) floor.uvs = {{1, 0}, {0, 0}, {0, 1}, {1, 1}};
  scene.addShape("floor", std::move(floor), checkerboard);
  SphereSet ball;
  ball.add({0, 0, 0}, 120.0f);
  scene.groups.push_back({"ball", {scene.addShape("ball", std::move(ball), checkerboard)}});
  // pbrt's sphere has its pole along z and u from x towards y: its (x, y, z) is (-x, z, y) of the books' sphere. Turned
  // by -90 degrees about x, then by 30 about z. Rows are the images of our axes.
  const float c = 0.866025404f, s = 0.5f;
  InstanceSet balls;
  balls.group = 0;
  balls.transforms = {Matrix(-c, -s, 0, 0, -s, c, 0, 0, 0, 0, -1, 0, 190, 190, 300, 1)};
  scene.instances.push_back(std::move(balls));
  return scene;
}

// pbrt filters its checkerboard over about a fifth of a pixel, also at the border of the floor, beyond which its cells
// continue: this changes a block by up to 3 %.
const ZTestSettings kBlurred{.roundOffFloor = 0.01};

TEST(Reference, Textures) { expectAgreement(renderScene(texturedRoom(), "path", 128), "textures", kBlurred); }

TEST(Reference, AMirroredTextureIsFound) {
  const Image ours = renderScene(texturedRoom(true), "path", 32);
  const Image theirs = readReference("textures.exr"), error = readReference("textures.stderr.exr");
  EXPECT_FALSE(zTest(ours, &ours, theirs, &error, kBlurred).passed);
}

// The reference is spectral, so colours can be compared in the mean only.
TEST(Reference, CornellInColour) {
  const Image ours = renderScene(makeScene("cornell-box"), "path", 256);
  const auto mean = channelMeans(ours), theirs = channelMeans(readReference("cornell.exr"));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / theirs[c], 1.0, 0.01) << "channel " << c;
}

}  // namespace
}  // namespace steradian
