/// "Ray Tracing: The Next Week" v4, section 7.3 and 8; "Ray Tracing: The Rest of Your Life" v4, sections 4 and 12.
#include <cmath>

#include "steradian/apps/scenes/builders.h"

namespace steradian::scenes {

namespace {

constexpr float kSide = 555.0f;

Id addQuad(SceneDescription& scene, const char* name, Vec3f corner, Vec3f u, Vec3f v, Id material) {
  QuadSet set;
  set.add(corner, u, v);
  return scene.addShape(name, std::move(set), material);
}

Id addLambert(SceneDescription& scene, const char* name, Rgb reflectance) {
  return scene.addMaterial(name, LambertMaterial{scene.addColour(reflectance)});
}

/// A book's box: corner at the origin, turned about y there, then moved.
Id addTurnedBox(SceneDescription& scene, const char* name, Vec3f size, float degrees, Vec3f move, Id material) {
  const double angle = static_cast<double>(degrees) * 3.14159265358979323846 / 180.0;
  const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  const Vec3f half = size * 0.5f;
  BoxSet set;
  set.addRotatedY(move + Vec3f{c * half.x + s * half.z, half.y, -s * half.x + c * half.z}, half, degrees);
  return scene.addShape(name, std::move(set), material);
}

SceneDescription emptyCornellRoom(std::uint32_t samplesPerPixel, bool twoSidedLight = false) {
  SceneDescription scene;
  addCornellWalls(scene);
  addCornellLight(scene, twoSidedLight);
  scene.camera = cornellCamera();
  scene.defaults = {.width = 600, .height = 600, .samplesPerPixel = samplesPerPixel, .maxDepth = 49};
  return scene;
}

}  // namespace

Id whiteOf(SceneDescription& scene) {
  for (std::size_t i = 0; i < scene.materials.size(); ++i)
    if (scene.materials[i].name == "white") return static_cast<Id>(i);
  return addLambert(scene, "white", {0.73f, 0.73f, 0.73f});
}

std::vector<Id> addCornellWalls(SceneDescription& scene) {
  const Id red = addLambert(scene, "red", {0.65f, 0.05f, 0.05f});
  const Id green = addLambert(scene, "green", {0.12f, 0.45f, 0.15f});
  const Id white = whiteOf(scene);
  const Vec3f x{kSide, 0.0f, 0.0f}, y{0.0f, kSide, 0.0f}, z{0.0f, 0.0f, kSide};
  return {addQuad(scene, "left wall", x, z, y, green),  // left in the picture: the camera looks along +z
          addQuad(scene, "right wall", z, -z, y, red), addQuad(scene, "ceiling", y, x, z, white),
          addQuad(scene, "floor", z, x, -z, white), addQuad(scene, "back wall", x + z, -x, y, white)};
}

Id addCornellLight(SceneDescription& scene, bool twoSided) {
  const Id black = scene.addMaterial("light", AbsorberMaterial{});
  const Id light = addQuad(scene, "light", {213.0f, 554.0f, 227.0f}, {130.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 105.0f}, black);
  scene.setEmission(light, {{15.0f, 15.0f, 15.0f}, twoSided});
  return light;
}

Id addTallBox(SceneDescription& scene, Id material) {
  return addTurnedBox(scene, "tall box", {165.0f, 330.0f, 165.0f}, 15.0f, {265.0f, 0.0f, 295.0f}, material);
}

Id addShortBox(SceneDescription& scene, Id material) {
  return addTurnedBox(scene, "short box", {165.0f, 165.0f, 165.0f}, -18.0f, {130.0f, 0.0f, 65.0f}, material);
}

PerspectiveCamera cornellCamera() {
  return {.lookFrom = {278.0f, 278.0f, -800.0f}, .lookAt = {278.0f, 278.0f, 0.0f}, .verticalFov = 40.0f};
}

SceneDescription cornellOriginal() {
  SceneDescription scene = emptyCornellRoom(200, true);
  addTallBox(scene, whiteOf(scene));
  addShortBox(scene, whiteOf(scene));
  return scene;
}

SceneDescription cornellSmoke() {
  SceneDescription scene;
  addCornellWalls(scene);
  const Id black = scene.addMaterial("light", AbsorberMaterial{});
  const Id light = addQuad(scene, "light", {113.0f, 554.0f, 127.0f}, {330.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 305.0f}, black);
  scene.setEmission(light, {{7.0f, 7.0f, 7.0f}, true});
  const Id boundary = scene.addMaterial("boundary", InterfaceMaterial{});
  const Id smoke = scene.addMedium({.name = "smoke", .absorption = grey(0.01f)});
  const Id fog = scene.addMedium({.name = "fog", .scattering = grey(0.01f)});
  scene.shapes[addTallBox(scene, boundary)].interior = Interior{smoke};
  scene.shapes[addShortBox(scene, boundary)].interior = Interior{fog};
  scene.camera = cornellCamera();
  scene.defaults = {.width = 600, .height = 600, .samplesPerPixel = 200, .maxDepth = 49};
  return scene;
}

SceneDescription cornellUniformDiffuse() {
  SceneDescription scene = cornellOriginal();
  for (MaterialDescription& material : scene.materials)
    if (const auto* lambert = std::get_if<LambertMaterial>(&material.model))
      material.model = UniformDiffuseMaterial{lambert->reflectance};
  return scene;
}

SceneDescription cornellBox() {
  SceneDescription scene = emptyCornellRoom(64);
  addTallBox(scene, whiteOf(scene));
  addShortBox(scene, whiteOf(scene));
  return scene;
}

SceneDescription cornellAluminium() {
  SceneDescription scene = emptyCornellRoom(1000);
  const Id aluminium = scene.addMaterial("aluminium", MetalMaterial{scene.addColour({0.8f, 0.85f, 0.88f}), 0.0f});
  addTallBox(scene, aluminium);
  addShortBox(scene, whiteOf(scene));
  return scene;
}

SceneDescription cornellGlassSphere() {
  SceneDescription scene = emptyCornellRoom(1000);
  addTallBox(scene, whiteOf(scene));
  SphereSet set;
  set.add({190.0f, 90.0f, 190.0f}, 90.0f);
  const Id glass = scene.addMaterial("glass", DielectricMaterial{.eta = 1.5f});
  const Id sphere = scene.addShape("glass sphere", std::move(set), glass);
  scene.shapes[sphere].target = true;
  for (ShapeDescription& shape : scene.shapes) shape.target = shape.target || shape.emission != kNone;
  return scene;
}

}  // namespace steradian::scenes
