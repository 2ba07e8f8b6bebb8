/// A tumbler of tea: a liquid that touches its glass, by priorities (Schmidt & Budge 2002).
#include <cmath>
#include <span>

#include "steradian/apps/scenes/builders.h"

namespace steradian::scenes {

namespace {

/// A body of revolution about the vertical through `base`. The profile runs from axis to axis with the body on its
/// left, as radius and height above the base; its corners stay sharp.
TriangleMesh lathe(Vec3f base, std::span<const Vec2f> profile) {
  constexpr int segments = 192;
  TriangleMesh mesh;
  for (std::size_t k = 0; k + 1 < profile.size(); ++k) {
    const Vec2f a = profile[k], b = profile[k + 1];
    const double edge = std::hypot(static_cast<double>(b.x - a.x), static_cast<double>(b.y - a.y));
    const float out = static_cast<float>((b.y - a.y) / edge), up = static_cast<float>((a.x - b.x) / edge);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (int i = 0; i <= segments; ++i) {
      const double angle = 6.283185307179586 * (i % segments) / segments;
      const float c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
      for (const Vec2f p : {a, b}) {
        mesh.positions.push_back(base + Vec3f{p.x * c, p.y, p.x * s});
        mesh.normals.push_back({out * c, up, out * s});
      }
    }
    for (std::uint32_t i = 0; i < segments; ++i) {
      const std::uint32_t q = first + 2 * i;
      if (a.x > 0.0f) mesh.indices.insert(mesh.indices.end(), {q, q + 1, q + 2});
      if (b.x > 0.0f) mesh.indices.insert(mesh.indices.end(), {q + 2, q + 1, q + 3});
    }
  }
  return mesh;
}

}  // namespace

SceneDescription nestedGlass() {
  SceneDescription scene;
  addCornellWalls(scene);
  addCornellLight(scene, false);
  const Vec3f base{278.0f, 0.5f, 230.0f};

  const Vec2f glass[]{{0.0f, 0.0f}, {100.0f, 0.0f}, {100.0f, 270.0f}, {90.0f, 270.0f}, {90.0f, 20.0f}, {0.0f, 20.0f}};
  const Id tumbler =
      scene.addShape("tumbler", lathe(base, glass), scene.addMaterial("glass", DielectricMaterial{.eta = 1.5f}));
  scene.shapes[tumbler].interior = Interior{.priority = 2};

  // Overlaps the glass, whose higher priority determines where the liquid ends.
  const Vec2f liquid[]{{0.0f, 15.0f}, {94.0f, 15.0f}, {94.0f, 190.0f}, {0.0f, 190.0f}};
  const Id tea =
      scene.addShape("tea", lathe(base, liquid), scene.addMaterial("water", DielectricMaterial{.eta = 1.33f}));
  scene.shapes[tea].interior =
      Interior{.medium = scene.addMedium({.name = "tea", .absorption = {0.0012f, 0.0055f, 0.02f}}), .priority = 1};

  BoxSet straw;
  straw.add(base + Vec3f{5.0f, 185.0f, 0.0f}, {6.0f, 180.0f, 6.0f});
  const double lean = 0.5 * 0.35;  // half of the angle about the axis of view
  straw.rotationW = {static_cast<float>(std::cos(lean))};
  straw.rotationX = straw.rotationY = {0.0f};
  straw.rotationZ = {static_cast<float>(std::sin(lean))};
  scene.addShape("straw", std::move(straw),
                 scene.addMaterial("red", LambertMaterial{scene.addColour({0.8f, 0.1f, 0.08f})}));
  scene.camera = PerspectiveCamera{
      .lookFrom = {278.0f, 330.0f, -560.0f}, .lookAt = {278.0f, 165.0f, 230.0f}, .verticalFov = 34.0f};
  scene.defaults = {.width = 600, .height = 600, .samplesPerPixel = 256, .maxDepth = 49};
  return scene;
}

}  // namespace steradian::scenes
