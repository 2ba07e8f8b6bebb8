/// Our pictures against those of an independent renderer (tests/data/reference).
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "steradian/apps/scenes/scenes.h"
#include "steradian/core/image_io.h"
#include "steradian/core/image_metrics.h"
#include "steradian/integrators/make_integrator.h"
#include "steradian/integrators/render.h"
#include "steradian/integrators/scene.h"

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
  return render(scene, *makeIntegrator(integrator), settings).film.image();
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

void expectAgreement(const Image& ours, const std::string& reference) {
  const Image theirs = readReference(reference + ".exr"), error = readReference(reference + ".stderr.exr");
  const ZTestResult z = zTest(ours, &ours, theirs, &error);
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

TEST(Reference, CornellGray) { expectAgreement(renderScene(greyCornellBox(), "path", 512), "cornell_gray"); }

TEST(Reference, CornellGlassGray) {
  expectAgreement(renderScene(greyed("cornell-glass-sphere"), "path", 1024), "cornell_glass_gray");
}

TEST(Reference, CornellGlassGrayByTheBooksMixture) {
  expectAgreement(renderScene(greyed("cornell-glass-sphere"), "path:strategy=mixture", 1024), "cornell_glass_gray");
}

TEST(Reference, OnePercentTooBrightIsFound) {
  SceneDescription scene = greyCornellBox();
  scene.emissions.at(0).radiance *= 1.01f;
  const Image ours = renderScene(std::move(scene), "path", 512);
  const Image theirs = readReference("cornell_gray.exr"), error = readReference("cornell_gray.stderr.exr");
  EXPECT_FALSE(zTest(ours, &ours, theirs, &error).passed);
}

// The reference is spectral, so colours can be compared in the mean only.
TEST(Reference, CornellInColour) {
  const Image ours = renderScene(makeScene("cornell-box"), "path", 256);
  const auto mean = channelMeans(ours), theirs = channelMeans(readReference("cornell.exr"));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / theirs[c], 1.0, 0.01) << "channel " << c;
}

}  // namespace
}  // namespace steradian
