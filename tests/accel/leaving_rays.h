#pragma once
/// Rays that leave surfaces must not hit them again.
#include <optional>

#include "steradian/accel/geometry.h"
#include "steradian/core/transport/ray_offset.h"
#include "steradian/tests/accel/random_scene.h"

namespace steradian::test {

/// Shapes of about `size` at about `place` from the origin.
inline ShapeGeometry randomShape(int kind, Random& random, float place, float size) {
  const Vec3f at = random.point(place);
  const auto edge = [&] { return random.direction() * (size * random.uniform(0.3f, 1.0f)); };
  const auto half = [&] { return size * random.uniform(0.3f, 1.0f); };
  const auto turn = [&] { return random.uniform(-1.0f, 1.0f); };
  SphereSet sphere;
  QuadSet quad;
  DiskSet disk;
  BoxSet box;
  TriangleMesh mesh;
  switch (kind) {
    case 0:
      return addTo(sphere, {at, half()}), sphere;
    case 1:
      return addTo(quad, {at, edge(), edge()}), quad;
    case 2:
      return addTo(disk, {at, random.direction(), half()}), disk;
    case 3:
      return addTo(box, {at, {half(), half(), half()}, turn(), 0.0f, turn(), 0.0f}), box;
    case 4:
      return addTo(box, {at, {half(), half(), half()}, turn(), turn(), turn(), turn()}), box;
    default:
      return addTo(mesh, at, at + edge(), at + edge()), mesh;
  }
}
inline bool isClosed(int kind) { return kind == 0 || kind == 3 || kind == 4; }

/// A direction on the side of `normal`; every other one close to the surface.
inline Vec3f leaving(Random& random, Vec3f normal, int i) {
  const Vec3f d = faceForward(random.direction(), normal);
  if (i % 2 == 0) return d;
  const Vec3f tangent = d - normal * dot(d, normal);
  return normalize(normalize(tangent) + normal * std::exp(random.uniform(-9.0f, 0.0f)));
}

struct Leaks {
  int points = 0, touched = 0, escaped = 0;
};

/// Rays leave random points of `geometry`'s single convex primitive: outwards they must not hit it again, and inwards
/// (closed shapes) they must, but not at once. `size` is that of the shape in the world. Moving shapes are tested at
/// one time, at which they are within `place`.
inline void leaveBy(const Geometry& geometry, bool closed, Random& random, float size, Leaks& leaks, float time = 0.0f,
                    std::optional<Bounds3> place = std::nullopt) {
  const Bounds3 bounds = place.value_or(geometry.bounds());
  for (int i = 0; i < 40; ++i) {
    const Vec3f target = bounds.center() + random.point(0.3f) * bounds.extent();
    const Vec3f origin = target + random.direction() * (size * std::exp(random.uniform(0.5f, 4.0f)));
    const Ray<float> ray{origin, normalize(target - origin), kInfinity, time};
    const SurfacePoint<float> p = geometry.surfacePoint(ray, geometry.intersect(ray));
    if (!p.valid) continue;
    ++leaks.points;
    const ScatterPoint<float> from{p.position, p.positionError, p.geometricNormal, time};
    const Vec3f out = leaving(random, p.geometricNormal, i), in = -leaving(random, p.geometricNormal, 2 * i);
    leaks.touched += geometry.intersect(spawnRay(from, out, kInfinity)).valid;
    const Ray<float> inward = spawnRay(from, in, kInfinity);
    const Hit<float> exit = geometry.intersect(inward);
    if (!closed) {
      leaks.touched += exit.valid;
    } else if (dot(in, p.geometricNormal) < -0.2f) {
      // The other side may be close by at the edges of a box, but a hit at the start would be the surface itself.
      leaks.escaped += !exit.valid && length(p.position - bounds.center()) < 0.3f * size;
      leaks.touched += exit.valid && exit.t == 0.0f;
    }
  }
}

}  // namespace steradian::test
