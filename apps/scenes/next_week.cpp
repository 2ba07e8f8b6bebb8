/// "Ray Tracing: The Next Week" v4.
#include "steradian/apps/scenes/builders.h"
#include "steradian/apps/scenes/earth_picture.h"

namespace steradian::scenes {
namespace {

/// The background of all scenes of the book whose light is not in them.
void addSky(SceneDescription& scene) { scene.addLight("sky", ConstantSky{{0.7f, 0.8f, 1.0f}}); }

/// 16:9, without defocus.
void setView(SceneDescription& scene, Vec3f lookFrom, Vec3f lookAt) {
  scene.camera = PerspectiveCamera{.lookFrom = lookFrom, .lookAt = lookAt, .verticalFov = 20.0f};
  scene.defaults = {.width = 400, .height = 225, .samplesPerPixel = 100, .maxDepth = 49};
}

/// The ground and the ball on it, of the book's marble.
void addMarbleSpheres(SceneDescription& scene) {
  const Id marble = scene.addTexture(NoiseTexture{.scale = 4.0f});
  SphereSet spheres;
  spheres.add({0.0f, -1000.0f, 0.0f}, 1000.0f);
  spheres.add({0.0f, 2.0f, 0.0f}, 2.0f);
  scene.addShape("spheres", std::move(spheres), scene.addMaterial("marble", LambertMaterial{marble}));
}

}  // namespace

SceneDescription checkeredSpheres() {
  SceneDescription scene;
  const Id even = scene.addColour({0.2f, 0.3f, 0.1f}), odd = scene.addColour({0.9f, 0.9f, 0.9f});
  const Id checker = scene.addTexture(CheckerTexture{.even = even, .odd = odd, .scale = 0.32f});
  SphereSet spheres;
  spheres.add({0.0f, -10.0f, 0.0f}, 10.0f);
  spheres.add({0.0f, 10.0f, 0.0f}, 10.0f);
  scene.addShape("spheres", std::move(spheres), scene.addMaterial("checkered", LambertMaterial{checker}));
  addSky(scene);
  setView(scene, {13.0f, 2.0f, 3.0f}, {0.0f, 0.0f, 0.0f});
  return scene;
}

ImageTexture earthTexture() {
  return {.name = "a map made of noise", .image = std::make_shared<const Image>(earthPicture())};
}

SceneDescription earth() {
  SceneDescription scene;
  const Id map = scene.addTexture(earthTexture());
  SphereSet globe;
  globe.add({0.0f, 0.0f, 0.0f}, 2.0f);
  scene.addShape("globe", std::move(globe), scene.addMaterial("earth", LambertMaterial{map}));
  addSky(scene);
  setView(scene, {0.0f, 0.0f, 12.0f}, {0.0f, 0.0f, 0.0f});
  return scene;
}

SceneDescription perlinSpheres() {
  SceneDescription scene;
  addMarbleSpheres(scene);
  addSky(scene);
  setView(scene, {13.0f, 2.0f, 3.0f}, {0.0f, 0.0f, 0.0f});
  return scene;
}

SceneDescription quads() {
  SceneDescription scene;
  const auto add = [&](const char* name, Vec3f corner, Vec3f u, Vec3f v, Rgb reflectance) {
    QuadSet set;
    set.add(corner, u, v);
    scene.addShape(name, std::move(set), scene.addMaterial(name, LambertMaterial{scene.addColour(reflectance)}));
  };
  add("left red", {-3.0f, -2.0f, 5.0f}, {0.0f, 0.0f, -4.0f}, {0.0f, 4.0f, 0.0f}, {1.0f, 0.2f, 0.2f});
  add("back green", {-2.0f, -2.0f, 0.0f}, {4.0f, 0.0f, 0.0f}, {0.0f, 4.0f, 0.0f}, {0.2f, 1.0f, 0.2f});
  add("right blue", {3.0f, -2.0f, 1.0f}, {0.0f, 0.0f, 4.0f}, {0.0f, 4.0f, 0.0f}, {0.2f, 0.2f, 1.0f});
  add("upper orange", {-2.0f, 3.0f, 1.0f}, {4.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 4.0f}, {1.0f, 0.5f, 0.0f});
  add("lower teal", {-2.0f, -3.0f, 5.0f}, {4.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -4.0f}, {0.2f, 0.8f, 0.8f});
  addSky(scene);
  scene.camera = PerspectiveCamera{.lookFrom = {0.0f, 0.0f, 9.0f}, .lookAt = {0.0f, 0.0f, 0.0f}, .verticalFov = 80.0f};
  scene.defaults = {.width = 400, .height = 400, .samplesPerPixel = 100, .maxDepth = 49};
  return scene;
}

SceneDescription simpleLight() {
  SceneDescription scene;
  addMarbleSpheres(scene);

  const Id black = scene.addMaterial("light", AbsorberMaterial{});
  const SurfaceEmission emission{{4.0f, 4.0f, 4.0f}, true};
  SphereSet sphereLight;
  sphereLight.add({0.0f, 7.0f, 0.0f}, 2.0f);
  scene.setEmission(scene.addShape("sphere light", std::move(sphereLight), black), emission);
  QuadSet quadLight;
  quadLight.add({3.0f, 1.0f, -2.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f});
  scene.setEmission(scene.addShape("quad light", std::move(quadLight), black), emission);

  setView(scene, {26.0f, 3.0f, 6.0f}, {0.0f, 2.0f, 0.0f});
  return scene;
}

}  // namespace steradian::scenes
