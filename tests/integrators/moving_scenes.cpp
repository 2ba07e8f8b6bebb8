#include "steradian/tests/integrators/moving_scenes.h"

#include "steradian/core/math/motion.h"
#include "steradian/tests/integrators/small_scenes.h"

namespace steradian::test {
namespace {

void addFlyingSphere(SceneDescription& scene) {
  SphereSet spheres;
  spheres.add({0.6f, -0.7f, 0.3f}, 0.3f);
  spheres.addMoving({-0.6f, -0.6f, 0.2f}, {0.2f, 0.1f, 0.2f}, 0.3f);
  scene.addShape("flying", spheres, addLambert(scene, grey(0.8f)));
}

void addTumblingBox(SceneDescription& scene) {
  BoxSet box;
  box.add({0.0f, 0.0f, 0.0f}, {0.3f, 0.2f, 0.1f});
  const Id id = scene.addShape("tumbling", box, addLambert(scene, {0.8f, 0.6f, 0.3f}));
  scene.shapes[id].motion =
      Motion{placed({-0.3f, 0.3f, 0.0f}), placed({0.3f, 0.0f, 0.0f}, {0.3f, 0.5f, 2.2f}, {1.5f, 1.0f, 2.0f})};
}

void addTumblingInstances(SceneDescription& scene) {
  BoxSet box;
  box.add({0.0f, 0.0f, 0.0f}, {0.25f, 0.05f, 0.1f});
  SphereSet ball;
  ball.add({0.0f, 0.2f, 0.0f}, 0.15f);
  const Id plank = scene.addShape("plank", box, addLambert(scene, grey(0.7f)));
  const Id rolling = scene.addShape("rolling", ball, addLambert(scene, {0.3f, 0.3f, 0.9f}));
  scene.shapes[rolling].motion = Motion{placed({-0.2f, 0.0f, 0.0f}), placed({0.2f, 0.0f, 0.0f})};
  scene.groups.push_back({"see-saw", {plank, rolling}});
  scene.instances.push_back({static_cast<Id>(scene.groups.size() - 1),
                             {placed({-0.5f, -0.4f, 0.4f}), placed({0.5f, 0.3f, -0.2f}, {0.0f, 0.0f, 0.5f})},
                             {placed({-0.4f, -0.4f, 0.4f}, {0.0f, 0.0f, 1.2f}),
                              placed({0.4f, 0.5f, -0.2f}, {0.0f, 1.5f, 0.0f}, {-1.0f, -1.0f, 1.4f})},
                             {}});
  // At rest, but for what moves in it.
  scene.instances.push_back(
      {static_cast<Id>(scene.groups.size() - 1), {placed({0.5f, -0.6f, 0.5f}, {0.0f, 0.4f, 0.0f})}, {}, {}});
}

void addMovingLights(SceneDescription& scene) {
  const Id black = addAbsorber(scene);
  const Id panel = addQuad(scene, {-0.2f, 0.0f, -0.2f}, {0.4f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.3f}, black);
  scene.setEmission(panel, {grey(6.0f), false});
  scene.shapes[panel].motion =
      Motion{placed({-0.5f, 0.9f, 0.0f}), placed({0.5f, 0.6f, 0.2f}, {0.2f, 0.0f, 0.9f}, {1.5f, 1.0f, 1.0f})};
  const Id egg = addSphere(scene, {0.0f, 0.0f, 0.0f}, 0.15f, black);
  scene.setEmission(egg, {{4.0f, 2.0f, 1.0f}, false});
  scene.shapes[egg].motion =
      Motion{placed({0.6f, -0.2f, 0.3f}), placed({0.5f, 0.2f, 0.3f}, {0.0f, 0.0f, 1.0f}, {2.0f, 0.8f, 1.0f})};
  SphereSet comet;
  comet.addMoving({-0.7f, -0.8f, 0.5f}, {0.6f, -0.7f, 0.3f}, 0.1f);
  scene.setEmission(scene.addShape("comet", comet, black), {{1.0f, 3.0f, 6.0f}, false});
  DiskSet disk;
  disk.add({0.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 1.0f}, 0.2f);
  const Id lamp = scene.addShape("lamp", disk, black);
  scene.setEmission(lamp, {grey(3.0f), true});
  scene.groups.push_back({"lamp", {lamp}});
  scene.instances.push_back({static_cast<Id>(scene.groups.size() - 1),
                             {placed({-0.6f, 0.2f, -0.3f})},
                             {placed({-0.5f, 0.0f, 0.0f}, {1.3f, 0.2f, 0.0f}, {1.0f, 1.8f, 1.0f})},
                             {}});
}

}  // namespace

Matrix placed(Vec3f translation, Vec3f rotation, Vec3f scale) {
  Matrix s, r, t;
  s.setScale(toImath(scale));
  r.setEulerAngles(toImath(rotation));
  t.setTranslation(toImath(translation));
  return s * r * t;
}

SceneDescription flyingSphere() {
  SceneDescription scene = room();
  addFlyingSphere(scene);
  return scene;
}

SceneDescription tumblingBox() {
  SceneDescription scene = room();
  addTumblingBox(scene);
  return scene;
}

SceneDescription tumblingInstances() {
  SceneDescription scene = room();
  addTumblingInstances(scene);
  return scene;
}

SceneDescription movingLights() {
  SceneDescription scene = room();
  for (ShapeDescription& shape : scene.shapes) shape.emission = kNone;
  addMovingLights(scene);
  return scene;
}

SceneDescription everythingMoves() {
  SceneDescription scene = room();
  addFlyingSphere(scene);
  addTumblingBox(scene);
  addTumblingInstances(scene);
  addMovingLights(scene);
  return scene;
}

SceneDescription frozen(const SceneDescription& scene, float time) {
  SceneDescription still = scene;
  std::vector<bool> grouped(still.shapes.size(), false);
  for (const Group& group : still.groups) {
    for (const Id shape : group.shapes) grouped[shape] = true;
  }
  for (InstanceSet& set : still.instances) {
    for (std::size_t i = 0; i < set.closing.size(); ++i) {
      set.transforms[i] = MovingTransform({set.transforms[i], set.closing[i]}).at(time);
    }
    set.closing.clear();
  }
  for (Id id = 0; id < still.shapes.size(); ++id) {
    ShapeDescription& shape = still.shapes[id];
    if (auto* spheres = std::get_if<SphereSet>(&shape.geometry); spheres && !spheres->moveX.empty()) {
      for (std::size_t i = 0; i < spheres->radius.size(); ++i) {
        spheres->centerX[i] += spheres->moveX[i] * time;
        spheres->centerY[i] += spheres->moveY[i] * time;
        spheres->centerZ[i] += spheres->moveZ[i] * time;
      }
      spheres->moveX.clear(), spheres->moveY.clear(), spheres->moveZ.clear();
    }
    if (!shape.motion) continue;
    const Matrix then = MovingTransform(*shape.motion).at(time);
    shape.motion.reset();
    if (grouped[id]) {
      shape.motion = Motion{then, then};
    } else {
      still.groups.push_back({shape.name, {id}});
      still.instances.push_back({static_cast<Id>(still.groups.size() - 1), {then}, {}, {}});
    }
  }
  return still;
}

}  // namespace steradian::test
