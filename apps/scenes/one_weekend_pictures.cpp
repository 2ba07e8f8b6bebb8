/// The scenes of the numbered pictures of "Ray Tracing in One Weekend" v4, from the first with normals on.
#include <cmath>

#include "steradian/apps/scenes/builders.h"

namespace steradian::scenes {

namespace {

/// "In One Weekend" before it has a positionable camera: from the origin along -z.
constexpr PerspectiveCamera kFirstCamera{.verticalFov = 90.0f};
constexpr PerspectiveCamera kDistantCamera{
    .lookFrom = {-2.0f, 2.0f, 1.0f}, .lookAt = {0.0f, 0.0f, -1.0f}, .verticalFov = 90.0f};

Id lambert(SceneDescription& scene, const char* name, Rgb reflectance) {
  return scene.addMaterial(name, LambertMaterial{scene.addColour(reflectance)});
}

void addSphere(SceneDescription& scene, const char* name, Vec3f center, float radius, Id material) {
  SphereSet set;
  set.add(center, radius);
  scene.addShape(name, std::move(set), material);
}

/// Chapters 6 to 9: a sphere of one material, on a large one or alone.
void addFirstSpheres(SceneDescription& scene, Id material, bool ground) {
  addSphere(scene, "sphere", {0.0f, 0.0f, -1.0f}, 0.5f, material);
  if (ground) addSphere(scene, "ground", {0.0f, -100.5f, -1.0f}, 100.0f, material);
}

/// 9.5. The book joins five renders; here are five spheres of reflectance 0.1, 0.3, 0.5, 0.7 and 0.9, each on a strip
/// of ground of its own reflectance.
void addGamut(SceneDescription& scene) {
  for (int i = 0; i < 5; ++i) {
    const float x = static_cast<float>(i - 2);
    const Id material = lambert(scene, "grey", grey(0.1f + 0.2f * static_cast<float>(i)));
    addSphere(scene, "sphere", {x, 0.0f, -2.0f}, 0.4f, material);
    QuadSet strip;
    strip.add({x - 0.5f, -0.4f, 3.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -103.0f});
    scene.addShape("ground", std::move(strip), material);
  }
}

/// Chapters 10 to 13: what the spheres to the left and to the right are made of, and the fuzz of metal.
void addThreeSpheres(SceneDescription& scene, const MaterialModel& left, float fuzzOfRight, bool hollow = false) {
  addSphere(scene, "ground", {0.0f, -100.5f, -1.0f}, 100.0f, lambert(scene, "ground", {0.8f, 0.8f, 0.0f}));
  addSphere(scene, "center", {0.0f, 0.0f, -1.2f}, 0.5f, lambert(scene, "center", {0.1f, 0.2f, 0.5f}));
  addSphere(scene, "left", {-1.0f, 0.0f, -1.0f}, 0.5f, scene.addMaterial("left", left));
  const MetalMaterial metal{scene.addColour({0.8f, 0.6f, 0.2f}), fuzzOfRight};
  addSphere(scene, "right", {1.0f, 0.0f, -1.0f}, 0.5f, scene.addMaterial("right", metal));
  if (!hollow) return;
  const DielectricMaterial bubble{.eta = 1.0f / 1.5f, .schlick = true};
  addSphere(scene, "bubble", {-1.0f, 0.0f, -1.0f}, 0.4f, scene.addMaterial("bubble", bubble));
}

/// 12.1: two spheres that touch, seen at 90 degrees.
void addWideAngle(SceneDescription& scene) {
  const float r = std::sqrt(0.5f);
  addSphere(scene, "left", {-r, 0.0f, -1.0f}, r, lambert(scene, "blue", {0.0f, 0.0f, 1.0f}));
  addSphere(scene, "right", {r, 0.0f, -1.0f}, r, lambert(scene, "red", {1.0f, 0.0f, 0.0f}));
}

void addChapters10To13(SceneDescription& scene, std::uint32_t picture) {
  constexpr DielectricMaterial glass{.eta = 1.5f, .schlick = true}, air{.eta = 1.0f / 1.33f, .schlick = true};
  if (picture == 13 || picture == 14) {
    const Id silver = scene.addColour({0.8f, 0.8f, 0.8f});
    return addThreeSpheres(scene, MetalMaterial{silver, picture == 13 ? 0.0f : 0.3f}, picture == 13 ? 0.0f : 1.0f);
  }
  if (picture <= 16) return addThreeSpheres(scene, glass, 1.0f);
  if (picture == 17) return addThreeSpheres(scene, air, 1.0f);
  addThreeSpheres(scene, glass, picture == 18 ? 0.0f : 1.0f, true);
}

CameraDescription cameraOf(std::uint32_t picture) {
  PerspectiveCamera camera = picture < 20 ? kFirstCamera : kDistantCamera;
  if (picture == 11 || picture == 12) {
    camera.lookFrom = {0.0f, 0.4f, 1.5f};
    camera.lookAt = {0.0f, 0.0f, -2.0f};
    camera.verticalFov = 45.0f;
  }
  if (picture >= 21) camera.verticalFov = 20.0f;
  if (picture == 22) {
    camera.defocusAngle = 10.0f;
    camera.focusDistance = 3.4f;
  }
  return camera;
}

}  // namespace

SceneDescription oneWeekendPicture(std::uint32_t picture) {
  if (picture == 23) return oneWeekend();
  SceneDescription scene;
  if (picture <= 5) {
    addFirstSpheres(scene, lambert(scene, "grey", grey(0.5f)), picture == 5);
  } else if (picture <= 9) {
    // Image 6 shows normals: any material will do.
    addFirstSpheres(scene, scene.addMaterial("grey", UniformDiffuseMaterial{scene.addColour(grey(0.5f))}), true);
  } else if (picture == 10) {
    addFirstSpheres(scene, lambert(scene, "grey", grey(0.5f)), true);
  } else if (picture <= 12) {
    addGamut(scene);
  } else if (picture == 19) {
    addWideAngle(scene);
  } else {
    addChapters10To13(scene, picture);
  }
  scene.addLight("sky", bookSky());
  scene.camera = cameraOf(picture);
  scene.defaults = {.width = 400, .height = 225, .samplesPerPixel = 100, .maxDepth = 49};
  return scene;
}

}  // namespace steradian::scenes
