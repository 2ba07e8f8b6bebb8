#pragma once
/// A scene of every kind of shape that goes into clusters.
#include <random>
#include <vector>

#include "steradian/core/scene/description.h"

namespace steradian::test {

class Numbers {
 public:
  float operator()(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine_); }
  Vec3f point(float reach) {
    const float x = (*this)(-reach, reach), y = (*this)(-reach, reach);
    return {x, y, (*this)(-reach, reach)};
  }

 private:
  std::mt19937 engine_{7};
};

/// Some of every kind, one behind the other and in two shapes each; the last quads are copies of the first.
inline SceneDescription mixedScene() {
  Numbers number;
  SceneDescription scene;
  for (int round = 0; round < 2; ++round) {
    QuadSet quads, walls;
    SphereSet spheres, rising;
    BoxSet upright, turned;
    DiskSet disks;
    TriangleMesh mesh;
    for (int i = 0; i < 3; ++i) {
      quads.add(number.point(2.0f), number.point(1.0f), number.point(1.0f));
      const Vec3f edges = number.point(2.0f);
      walls.add(number.point(2.0f), {0.0f, edges.x, 0.0f}, {i == 0 ? edges.y : 0.0f, 0.0f, i == 0 ? 0.0f : edges.z});
      spheres.add(number.point(2.0f), number(0.2f, 0.8f));
      const Vec3f start = number.point(2.0f);
      rising.addMoving(start, start + number.point(1.0f), 0.5f);
      upright.addRotatedY(number.point(2.0f), {0.3f, 0.5f, 0.2f}, number(0.0f, 90.0f));
      turned.addRotatedY(number.point(2.0f), {0.4f, 0.2f, 0.3f}, 30.0f);
      turned.rotationX.back() = 0.3f;
      disks.add(number.point(2.0f), normalize(number.point(1.0f)), 0.7f);
      for (int k = 0; k < 3; ++k) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(number.point(2.0f));
      }
    }
    scene.addShape("quads", quads, static_cast<Id>(round));
    scene.addShape("walls", walls, 6);
    if (round == 1) {
      // Not aligned as a whole, but one of them by itself.
      quads.add({0.5f, 0.0f, -1.0f}, {0.0f, 0.0f, 2.0f}, {0.0f, 1.0f, 0.0f});
      scene.addShape("one wall", quads, 7);
    }
    scene.addShape("spheres", spheres, 1);
    scene.addShape("rising", rising, 8);
    scene.addShape("upright", upright, 2);
    scene.addShape("turned", turned, 3);
    scene.addShape("disks", disks, 4);
    scene.addShape("mesh", mesh, 5);
    if (round == 1) scene.shapes.push_back(scene.shapes.front());
  }
  return scene;
}

inline std::vector<Id> allShapes(const SceneDescription& scene) {
  std::vector<Id> ids;
  for (Id i = 0; i < scene.shapes.size(); ++i) ids.push_back(i);
  return ids;
}

}  // namespace steradian::test
