#include "steradian/tests/integrators/small_scenes.h"

#include <cmath>

namespace steradian::test {

Id addQuad(SceneDescription& scene, Vec3f corner, Vec3f u, Vec3f v, Id material) {
  QuadSet quad{{corner.x}, {corner.y}, {corner.z}, {u.x}, {u.y}, {u.z}, {v.x}, {v.y}, {v.z}};
  return scene.addShape("quad", std::move(quad), material);
}

Id addSphere(SceneDescription& scene, Vec3f center, float radius, Id material) {
  return scene.addShape("sphere", SphereSet{{center.x}, {center.y}, {center.z}, {radius}}, material);
}

Id addBox(SceneDescription& scene, Vec3f center, Vec3f half, float degrees, Id material) {
  const float halfAngle = 0.5f * degrees * kPi / 180.0f;
  BoxSet box{{center.x}, {center.y}, {center.z}, {half.x}, {half.y}, {half.z}, {}, {}, {}, {}};
  box.rotationW = {std::cos(halfAngle)};
  box.rotationX = {0.0f};
  box.rotationY = {std::sin(halfAngle)};
  box.rotationZ = {0.0f};
  return scene.addShape("box", std::move(box), material);
}

Id addLambert(SceneDescription& scene, Rgb reflectance) {
  return scene.addMaterial("lambert", LambertMaterial{scene.addColour(reflectance)});
}

Id addAbsorber(SceneDescription& scene) { return scene.addMaterial("absorber", AbsorberMaterial{}); }

SceneDescription furnace(float reflectance, float radiance) {
  SceneDescription scene;
  const Id wall = addLambert(scene, grey(reflectance));
  QuadSet walls;
  const auto add = [&](Vec3f corner, Vec3f u, Vec3f v) {
    walls.cornerX.push_back(corner.x), walls.cornerY.push_back(corner.y), walls.cornerZ.push_back(corner.z);
    walls.uX.push_back(u.x), walls.uY.push_back(u.y), walls.uZ.push_back(u.z);
    walls.vX.push_back(v.x), walls.vY.push_back(v.y), walls.vZ.push_back(v.z);
  };
  // u x v points inwards.
  add({-1, -1, -1}, {0, 0, 2}, {2, 0, 0});
  add({-1, 1, -1}, {2, 0, 0}, {0, 0, 2});
  add({-1, -1, -1}, {0, 2, 0}, {0, 0, 2});
  add({1, -1, -1}, {0, 0, 2}, {0, 2, 0});
  add({-1, -1, -1}, {2, 0, 0}, {0, 2, 0});
  add({-1, -1, 1}, {0, 2, 0}, {2, 0, 0});
  const Id shape = scene.addShape("walls", std::move(walls), wall);
  scene.setEmission(shape, {grey(radiance), false});
  scene.camera =
      PerspectiveCamera{.lookFrom = {0.1f, 0.05f, 0.0f}, .lookAt = {0.3f, 0.2f, -1.0f}, .verticalFov = 90.0f};
  return scene;
}

SceneDescription sphereInSky(MaterialModel material) {
  SceneDescription scene;
  addSphere(scene, {0, 0, 0}, 1.0f, scene.addMaterial("tested", material));
  scene.addLight("sky", ConstantSky{grey(1.0f)});
  scene.camera = PerspectiveCamera{.lookFrom = {0, 0, 4}, .lookAt = {0, 0, 0}, .verticalFov = 18.0f};
  return scene;
}

SceneDescription floorPoint() {
  SceneDescription scene;
  addQuad(scene, {-50, 0, -50}, {0, 0, 100}, {100, 0, 0}, addLambert(scene, grey(1.0f)));
  scene.camera = OrthographicCamera{.lookFrom = {3, 1, 2}, .lookAt = {0, 0, 0}, .height = 1e-4f};
  scene.defaults.maxDepth = 1;
  return scene;
}

SceneDescription room() {
  SceneDescription scene;
  const Id wall = addLambert(scene, grey(0.4f));
  addQuad(scene, {-1, -1, -1}, {0, 0, 2}, {2, 0, 0}, wall);
  addQuad(scene, {-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, wall);
  addQuad(scene, {-1, -1, -1}, {0, 2, 0}, {0, 0, 2}, wall);
  addQuad(scene, {1, -1, -1}, {0, 0, 2}, {0, 2, 0}, wall);
  addQuad(scene, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, wall);
  const Id light = addQuad(scene, {-0.4f, 0.98f, -0.4f}, {0.8f, 0, 0}, {0, 0, 0.8f}, addAbsorber(scene));
  scene.setEmission(light, {grey(5.0f), false});
  scene.camera = PerspectiveCamera{.lookFrom = {0, 0, 4.4f}, .lookAt = {0, 0, 0}, .verticalFov = 32.0f};
  scene.defaults.maxDepth = 6;
  return scene;
}

SceneDescription underAnEnvironmentMap() {
  SceneDescription scene;
  addQuad(scene, {-50, 0, -50}, {0, 0, 100}, {100, 0, 0}, addLambert(scene, grey(0.8f)));
  addBox(scene, {-0.8f, 0.5f, 0.0f}, {0.4f, 0.5f, 0.4f}, 25.0f, addLambert(scene, {0.7f, 0.4f, 0.1f}));
  const Id colour = scene.addColour({0.8f, 0.8f, 0.6f});
  addSphere(scene, {0.3f, 0.5f, 0.6f}, 0.5f, scene.addMaterial("coat", CoatedMaterial{colour, 1.5f}));
  addSphere(scene, {1.3f, 0.5f, -0.4f}, 0.5f, scene.addMaterial("satin", MetalMaterial{colour, 0.3f}));
  Image sky(16, 8, {"R", "G", "B"});
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 16; ++x) {
      for (int c = 0; c < 3; ++c) sky.at(x, y, c) = y < 4 ? 0.1f + 0.05f * static_cast<float>((x + 3 * c) % 5) : 0.0f;
    }
  }
  for (int c = 0; c < 3; ++c) sky.at(10, 2, c) = 12.0f - 2.0f * static_cast<float>(c);
  scene.addLight("sky", ImageSky{.image = std::make_shared<const Image>(sky), .rotation = 70.0f});
  scene.camera = PerspectiveCamera{.lookFrom = {0, 1.5f, 5}, .lookAt = {0.2f, 0.4f, 0}, .verticalFov = 32.0f};
  scene.defaults.maxDepth = 5;
  return scene;
}

RenderSettings settingsOf(int width, int height, std::uint32_t samplesPerPixel, std::uint32_t seed) {
  RenderSettings settings;
  settings.width = width;
  settings.height = height;
  settings.samplesPerPixel = samplesPerPixel;
  settings.seed = seed;
  return settings;
}

}  // namespace steradian::test
