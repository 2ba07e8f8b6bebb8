#pragma once
/// Small scenes of lights, and points to gather their light at.
#include <cmath>
#include <string>
#include <utility>

#include "steradian/core/samplers/rng.h"
#include "steradian/lights/light_set.h"

namespace steradian::test {

inline constexpr Bounds3 kBounds{{-1.0f, -1.0f, -1.0f}, {1.0f, 1.0f, 1.0f}};

inline LightRandom<float> lightRandom(std::uint32_t index) {
  const auto w = randomWords<std::uint32_t>(index, 11u, 12u, 13u);
  return {toUnitFloat<float>(w[0]), {toUnitFloat<float>(w[1]), toUnitFloat<float>(w[2])}};
}

/// A point of a surface that faces up.
inline ScatterPoint<float> pointAt(Vec3f position) {
  ScatterPoint<float> from;
  from.position = position;
  from.geometricNormal = {0.0f, 1.0f, 0.0f};
  return from;
}

inline Id addEmitter(SceneDescription& scene, ShapeGeometry geometry, Rgb radiance, bool twoSided = false,
                     const std::string& name = "emitter") {
  const Id shape = scene.addShape(name, std::move(geometry), kNone);
  scene.setEmission(shape, {radiance, twoSided});
  return shape;
}

inline SphereSet sphere(Vec3f center, float radius) {
  SphereSet set;
  set.add(center, radius);
  return set;
}
inline QuadSet quad(Vec3f corner, Vec3f u, Vec3f v) {
  QuadSet set;
  set.add(corner, u, v);
  return set;
}
inline DiskSet disk(Vec3f center, Vec3f normal, float radius) {
  DiskSet set;
  set.add(center, normal, radius);
  return set;
}
/// The square of that edge above the origin, facing down.
inline QuadSet ceilingSquare(float edge, float height) {
  return quad({-0.5f * edge, height, -0.5f * edge}, {edge, 0.0f, 0.0f}, {0.0f, 0.0f, edge});
}
inline BoxSet box(Vec3f center, Vec3f half, float degrees) {
  BoxSet set;
  set.addRotatedY(center, half, degrees);
  return set;
}
inline TriangleMesh mesh() {
  TriangleMesh m;
  m.positions = {{-1, 2, -1}, {1, 2, -1}, {1, 2.5f, 1}, {-1, 2, 1}};
  m.indices = {0, 1, 2, 0, 2, 3};  // facing down
  return m;
}

}  // namespace steradian::test
