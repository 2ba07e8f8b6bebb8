/// "Ray Tracing: The Next Week" v4, section 10: everything in one picture.
#include "steradian/apps/scenes/builders.h"
#include "steradian/core/samplers/rng.h"

namespace steradian::scenes {

namespace {

float randomNumber(std::uint32_t index, std::uint32_t what) {
  return toUnitFloat<float>(randomWords<std::uint32_t>(index, what, 0u, 0x66696e61u)[0]);
}

Id addLambert(SceneDescription& scene, const char* name, Rgb reflectance) {
  return scene.addMaterial(name, LambertMaterial{scene.addColour(reflectance)});
}

Id addSphere(SceneDescription& scene, const char* name, Vec3f center, float radius, Id material) {
  SphereSet set;
  set.add(center, radius);
  return scene.addShape(name, std::move(set), material);
}

/// Steps of all heights, 20 x 20.
void addGround(SceneDescription& scene) {
  constexpr std::uint32_t perSide = 20;
  constexpr float edge = 100.0f;
  BoxSet steps;
  for (std::uint32_t i = 0; i < perSide * perSide; ++i) {
    const std::uint32_t row = i / perSide, column = i % perSide;
    const float x = -1000.0f + edge * static_cast<float>(row);
    const float z = -1000.0f + edge * static_cast<float>(column);
    const float height = 1.0f + 100.0f * randomNumber(i, 0);
    steps.add({x + 0.5f * edge, 0.5f * height, z + 0.5f * edge}, {0.5f * edge, 0.5f * height, 0.5f * edge});
  }
  scene.addShape("ground", std::move(steps), addLambert(scene, "ground", {0.48f, 0.83f, 0.53f}));
}

/// A cube of a thousand spheres, turned by 15 degrees.
void addCube(SceneDescription& scene, bool instanced) {
  Matrix place;
  place.rotate(Imath::V3f(0.0f, 15.0f * kPi / 180.0f, 0.0f));
  place = place * Matrix().setTranslation(Imath::V3f(-100.0f, 270.0f, 395.0f));
  SphereSet spheres;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Vec3f center = Vec3f{randomNumber(i, 1), randomNumber(i, 2), randomNumber(i, 3)} * 165.0f;
    spheres.add(instanced ? center : transformPoint(place, center), 10.0f);
  }
  const Id cube = scene.addShape("cube of spheres", std::move(spheres), addLambert(scene, "white", grey(0.73f)));
  if (!instanced) return;
  scene.groups.push_back({"cube", {cube}});
  InstanceSet instances;
  instances.group = 0;
  instances.transforms = {place};
  scene.instances.push_back(std::move(instances));
}

}  // namespace

SceneDescription nextWeekFinal(bool instanced) {
  SceneDescription scene;
  addGround(scene);
  QuadSet lamp;
  lamp.add({123.0f, 554.0f, 147.0f}, {300.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 265.0f});
  scene.setEmission(scene.addShape("light", std::move(lamp), scene.addMaterial("light", AbsorberMaterial{})),
                    {grey(7.0f), true});

  SphereSet moving;
  moving.addMoving({400.0f, 400.0f, 200.0f}, {430.0f, 400.0f, 200.0f}, 50.0f);
  scene.addShape("moving", std::move(moving), addLambert(scene, "orange", {0.7f, 0.3f, 0.1f}));
  const Id glass = scene.addMaterial("glass", DielectricMaterial{.eta = 1.5f});
  addSphere(scene, "glass", {260.0f, 150.0f, 45.0f}, 50.0f, glass);
  addSphere(scene, "metal", {0.0f, 150.0f, 145.0f}, 50.0f,
            scene.addMaterial("metal", MetalMaterial{scene.addColour({0.8f, 0.8f, 0.9f}), 1.0f}));

  // Under a clear coat a dense blue medium; and a thin mist over everything.
  const Rgb blue{0.2f, 0.4f, 0.9f};
  const Id ball = addSphere(scene, "blue", {360.0f, 150.0f, 145.0f}, 70.0f, glass);
  scene.shapes[ball].interior =
      Interior{scene.addMedium({.name = "blue", .absorption = (grey(1.0f) - blue) * 0.2f, .scattering = blue * 0.2f})};
  const Id mist = addSphere(scene, "mist", {0.0f, 0.0f, 0.0f}, 5000.0f, scene.addMaterial("air", InterfaceMaterial{}));
  scene.shapes[mist].interior = Interior{scene.addMedium({.name = "mist", .scattering = grey(0.0001f)})};

  addSphere(scene, "earth", {400.0f, 200.0f, 400.0f}, 100.0f,
            scene.addMaterial("earth", LambertMaterial{scene.addTexture(earthTexture())}));
  addSphere(scene, "marble", {220.0f, 280.0f, 300.0f}, 80.0f,
            scene.addMaterial("marble", LambertMaterial{scene.addTexture(NoiseTexture{.scale = 0.2f})}));
  addCube(scene, instanced);
  scene.camera =
      PerspectiveCamera{.lookFrom = {478.0f, 278.0f, -600.0f}, .lookAt = {278.0f, 278.0f, 0.0f}, .verticalFov = 40.0f};
  scene.defaults = {.width = 800, .height = 800, .samplesPerPixel = 1000, .maxDepth = 39};
  return scene;
}

}  // namespace steradian::scenes
