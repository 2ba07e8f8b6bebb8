/// A room that is lit through the gap under its door ("The Rest of Your Life", 1: light that direct light sampling
/// cannot find).
#include "steradian/apps/scenes/builders.h"

namespace steradian::scenes {

SceneDescription doorCrack() {
  SceneDescription scene;  // lengths in m
  const Id wall = scene.addMaterial("wall", LambertMaterial{scene.addColour({0.75f, 0.74f, 0.7f})});
  const Id wood = scene.addMaterial("wood", LambertMaterial{scene.addColour({0.35f, 0.2f, 0.1f})});
  const Id floor = scene.addMaterial("floor", LambertMaterial{scene.addColour({0.6f, 0.55f, 0.5f})});
  const auto box = [](BoxSet& set, Vec3f low, Vec3f high) { set.add((low + high) * 0.5f, (high - low) * 0.5f); };

  // The room, and beyond z = 4.1 the corridor.
  BoxSet walls;
  box(walls, {-0.1f, 0.0f, -0.1f}, {0.0f, 2.6f, 6.1f});
  box(walls, {4.0f, 0.0f, -0.1f}, {4.1f, 2.6f, 6.1f});
  box(walls, {0.0f, 0.0f, -0.1f}, {4.0f, 2.6f, 0.0f});
  box(walls, {0.0f, 0.0f, 6.0f}, {4.0f, 2.6f, 6.1f});
  box(walls, {-0.1f, 2.6f, -0.1f}, {4.1f, 2.7f, 6.1f});
  box(walls, {0.0f, 0.0f, 4.0f}, {1.5f, 2.6f, 4.1f});
  box(walls, {2.5f, 0.0f, 4.0f}, {4.0f, 2.6f, 4.1f});
  box(walls, {1.5f, 2.1f, 4.0f}, {2.5f, 2.6f, 4.1f});
  scene.addShape("walls", std::move(walls), wall);
  BoxSet ground;
  box(ground, {-0.1f, -0.1f, -0.1f}, {4.1f, 0.0f, 6.1f});
  scene.addShape("floor", std::move(ground), floor);
  BoxSet door;
  box(door, {1.5f, 0.05f, 4.02f}, {2.5f, 2.1f, 4.06f});
  scene.addShape("door", std::move(door), wood);

  // Invisible: the gap that light comes through, as a sampling target (--target).
  QuadSet gap;
  gap.add({1.5f, 0.0f, 4.02f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.05f, 0.0f});
  scene.shapes[scene.addShape("gap", std::move(gap), scene.addMaterial("air", InterfaceMaterial{}))].target = true;

  SphereSet ball;
  ball.add({1.2f, 0.25f, 2.9f}, 0.25f);
  scene.addShape("ball", std::move(ball), wall);
  BoxSet chest;
  chest.addRotatedY({2.9f, 0.3f, 3.0f}, {0.35f, 0.3f, 0.25f}, 25.0f);
  scene.addShape("chest", std::move(chest), wood);

  QuadSet lamp;
  lamp.add({1.4f, 2.59f, 4.6f}, {1.2f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.4f});  // faces down
  scene.setEmission(scene.addShape("lamp", std::move(lamp), scene.addMaterial("lamp", AbsorberMaterial{})),
                    {{2400.0f, 2200.0f, 1900.0f}, false});
  scene.camera = PerspectiveCamera{.lookFrom = {2.0f, 1.3f, 0.3f}, .lookAt = {2.0f, 0.7f, 4.0f}, .verticalFov = 50.0f};
  scene.defaults = {.width = 600, .height = 400, .samplesPerPixel = 256, .maxDepth = 49};
  return scene;
}

}  // namespace steradian::scenes
