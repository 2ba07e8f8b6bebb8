#include "steradian/tests/integrators/wide_rendering.h"

#include <gtest/gtest.h>

#include "steradian/integrators/make_integrator.h"
#include "steradian/tests/integrators/small_scenes.h"

namespace steradian::test {

SceneDescription everythingRoom() {
  SceneDescription s = room();
  const Id brown = s.addColour({0.5f, 0.3f, 0.1f});
  const Id checker = s.addTexture(CheckerTexture{brown, s.addColour({0.9f, 0.8f, 0.1f}), 0.1f});
  addSphere(s, {-0.5f, -0.7f, 0.3f}, 0.3f, s.addMaterial("glass", DielectricMaterial{1.5f, false}));
  addSphere(s, {0.5f, -0.7f, 0.5f}, 0.3f, s.addMaterial("book's glass", DielectricMaterial{1.5f, true}));
  addSphere(s, {0.0f, -0.8f, 0.6f}, 0.2f, s.addMaterial("metal", MetalMaterial{brown, 0.3f}));
  addSphere(s, {0.0f, -0.3f, -0.6f}, 0.3f, s.addMaterial("mirror", MetalMaterial{brown, 0.0f}));
  const Id coat = s.addMaterial("coat", CoatedMaterial{brown, 1.5f});
  addBox(s, {0.5f, -0.5f, -0.4f}, {0.2f, 0.5f, 0.2f}, 20.0f, coat);
  BoxSet turned;
  turned.centerX = {-0.5f}, turned.centerY = {-0.2f}, turned.centerZ = {-0.5f};
  turned.halfX = {0.2f}, turned.halfY = {0.1f}, turned.halfZ = {0.3f};
  turned.rotationW = {0.8f}, turned.rotationX = {0.36f}, turned.rotationY = {0.0f}, turned.rotationZ = {0.48f};
  s.addShape("turned", turned, s.addMaterial("checkered", LambertMaterial{checker}));
  DiskSet disk;
  disk.add({0.3f, 0.3f, -0.9f}, {0.0f, 0.0f, 1.0f}, 0.3f);
  s.setEmission(s.addShape("disk", disk, addAbsorber(s)), {{1.0f, 2.0f, 3.0f}, true});
  TriangleMesh mesh;
  mesh.positions = {{-0.9f, 0.5f, -0.5f}, {-0.4f, 0.5f, -0.5f}, {-0.6f, 0.9f, -0.3f}, {-0.2f, 0.9f, -0.7f}};
  mesh.indices = {0, 1, 2, 2, 1, 3};
  s.addShape("mesh", mesh, s.addMaterial("uniform", UniformDiffuseMaterial{brown}));
  s.addLight("bulb", PointLight{{0.0f, 0.2f, 0.8f}, grey(0.3f)});
  s.addLight("spot", SpotLight{{0.5f, 0.8f, 0.5f}, {-0.5f, -1.0f, -0.3f}, grey(0.5f), 20.0f, 35.0f});
  return s;
}

SceneDescription plainRoom() {
  SceneDescription s = everythingRoom();
  for (MaterialDescription& m : s.materials) {
    if (m.name == "checkered") m.model = LambertMaterial{s.addColour({0.2f, 0.4f, 0.6f})};
  }
  return s;
}

SceneDescription greyRoom() {
  SceneDescription s = room();
  const Id grey = addLambert(s, {0.4f, 0.4f, 0.4f});
  addBox(s, {0.4f, -0.6f, -0.2f}, {0.3f, 0.4f, 0.3f}, 20.0f, grey);
  addSphere(s, {-0.4f, -0.6f, 0.2f}, 0.4f, grey);
  return s;
}

SceneDescription colouredRoom() {
  SceneDescription s = greyRoom();
  s.shapes.front().material = addLambert(s, {0.8f, 0.1f, 0.3f});
  const Id brown = s.addColour({0.5f, 0.3f, 0.1f});
  addSphere(s, {0.0f, 0.2f, 0.3f}, 0.25f, s.addMaterial("metal", MetalMaterial{brown, 0.4f}));
  addSphere(s, {0.6f, 0.3f, 0.2f}, 0.25f, s.addMaterial("glass", DielectricMaterial{1.5f, false}));
  addBox(s, {-0.6f, 0.3f, -0.4f}, {0.2f, 0.2f, 0.2f}, 30.0f, s.addMaterial("coat", CoatedMaterial{brown, 1.5f}));
  return s;
}

SceneDescription openScene() {
  SceneDescription s = sphereInSky(CoatedMaterial{});
  std::get<CoatedMaterial>(s.materials[0].model).reflectance = s.addColour({0.6f, 0.2f, 0.3f});
  s.addLight("sun", DistantLight{{-1.0f, -2.0f, -0.5f}, grey(1.0f)});
  s.addLight("dusk", GradientSky{{0.1f, 0.1f, 0.1f}, {0.2f, 0.3f, 0.5f}});
  s.setEmission(addSphere(s, {1.2f, 0.5f, 0.8f}, 0.3f, addAbsorber(s)), {{1.0f, 2.0f, 3.0f}, true});
  return s;
}

namespace {
RenderResult resultOf(const Scene& scene, const std::string& spec, RenderSettings settings) {
  const auto [integrator, execution] = makeIntegrator(spec, settings.execution);
  settings.execution = execution;
  return render(scene, *integrator, settings);
}
}  // namespace

Rendered renderWith(const Scene& scene, const std::string& integrator, const RenderSettings& settings) {
  const RenderResult result = resultOf(scene, integrator, settings);
  const Image image = result.film.image();
  return {{image.values().begin(), image.values().end()}, result.statistics.paths};
}

Image pictureOf(const Scene& scene, const std::string& integrator, const RenderSettings& settings) {
  return resultOf(scene, integrator, settings).film.image({.features = false});
}

void expectEqual(const Rendered& a, const Rendered& b, const std::string& what) {
  ASSERT_EQ(a.values.size(), b.values.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i) different += bitsOf(a.values[i]) == bitsOf(b.values[i]) ? 0u : 1u;
  EXPECT_EQ(different, 0u) << what;
  EXPECT_EQ(a.counts.shadowRays, b.counts.shadowRays) << what;
  EXPECT_EQ(a.counts.pathLengths, b.counts.pathLengths) << what;
}

}  // namespace steradian::test
