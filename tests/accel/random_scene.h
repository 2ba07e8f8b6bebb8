#pragma once
/// Random scenes of all kinds of primitives.
#include <cmath>
#include <random>

#include "steradian/accel/shapes/primitives/shape_at.h"
#include "steradian/core/scene/description.h"

namespace steradian::test {

struct Random {
  std::mt19937 engine;
  explicit Random(unsigned seed) : engine(seed) {}

  float uniform(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine); }
  Vec3f point(float reach) { return {uniform(-reach, reach), uniform(-reach, reach), uniform(-reach, reach)}; }
  Vec3f direction() {
    for (;;) {
      const Vec3f p = point(1.0f);
      const float l = lengthSquared(p);
      if (l > 0.01f && l < 1.0f) return normalize(p);
    }
  }
  /// From within `reach` towards somewhere within 5 of the origin; one in eight along an axis.
  Ray<float> ray(float reach) {
    const Vec3f origin = point(reach);
    const Vec3f direction = normalize(point(5.0f) - origin);
    switch (engine() % 24) {
      case 0:
        return {origin, {1.0f, 0.0f, 0.0f}};
      case 1:
        return {origin, {0.0f, -1.0f, 0.0f}};
      case 2:
        return {origin, {0.0f, 0.0f, 1.0f}};
      default:
        return {origin, direction};
    }
  }
};

inline void addTo(SphereSet& set, const Sphere<float>& s) {
  set.centerX.push_back(s.center.x);
  set.centerY.push_back(s.center.y);
  set.centerZ.push_back(s.center.z);
  set.radius.push_back(s.radius);
}

inline void addTo(QuadSet& set, const Quad<float>& q) {
  set.cornerX.push_back(q.corner.x);
  set.cornerY.push_back(q.corner.y);
  set.cornerZ.push_back(q.corner.z);
  set.uX.push_back(q.u.x);
  set.uY.push_back(q.u.y);
  set.uZ.push_back(q.u.z);
  set.vX.push_back(q.v.x);
  set.vY.push_back(q.v.y);
  set.vZ.push_back(q.v.z);
}

inline void addTo(DiskSet& set, const Disk<float>& d) {
  set.centerX.push_back(d.center.x);
  set.centerY.push_back(d.center.y);
  set.centerZ.push_back(d.center.z);
  set.normalX.push_back(d.normal.x);
  set.normalY.push_back(d.normal.y);
  set.normalZ.push_back(d.normal.z);
  set.radius.push_back(d.radius);
}

inline void addTo(BoxSet& set, const TurnedBox& b) {
  set.centerX.push_back(b.center.x);
  set.centerY.push_back(b.center.y);
  set.centerZ.push_back(b.center.z);
  set.halfX.push_back(b.half.x);
  set.halfY.push_back(b.half.y);
  set.halfZ.push_back(b.half.z);
  const float scale = 1.0f / std::sqrt(b.w * b.w + b.x * b.x + b.y * b.y + b.z * b.z);
  set.rotationW.push_back(b.w * scale);
  set.rotationX.push_back(b.x * scale);
  set.rotationY.push_back(b.y * scale);
  set.rotationZ.push_back(b.z * scale);
}

inline void addTo(TriangleMesh& mesh, Vec3f a, Vec3f b, Vec3f c) {
  for (const Vec3f p : {a, b, c}) {
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.push_back(p);
  }
}

/// A custom shape: the part of the plane z = height within a square of half edge `half`; its normal is +z.
class Slab : public CustomShape {
 public:
  explicit Slab(float half, float height = 0.0f) : half_(half), height_(height) {}
  Bounds3 bounds() const override { return {{-half_, -half_, height_}, {half_, half_, height_}}; }
  std::optional<CustomHit> intersect(const Ray<float>& ray) const override {
    const float t = (height_ - ray.origin.z) / ray.direction.z;
    const Vec3f p = ray.at(t);
    if (!(t > ray.tMin && t < ray.tMax && std::abs(p.x) <= half_ && std::abs(p.y) <= half_)) return std::nullopt;
    return CustomHit{t, {0.0f, 0.0f, 1.0f}, {0.5f + 0.5f * p.x / half_, 0.5f + 0.5f * p.y / half_}};
  }

 private:
  float half_, height_;
};

inline Vec3f randomHalf(Random& random) {
  return {random.uniform(0.05f, 0.3f), random.uniform(0.05f, 0.3f), random.uniform(0.05f, 0.3f)};
}

/// `count` small primitives of each kind within 5 of the origin, and two custom shapes. Shape i has material i.
inline SceneDescription randomScene(unsigned seed, int count) {
  Random random(seed);
  SphereSet spheres;
  QuadSet quads;
  DiskSet disks;
  BoxSet upright, turned;
  TriangleMesh mesh;
  for (int i = 0; i < count; ++i) {
    addTo(spheres, {random.point(5.0f), random.uniform(0.05f, 0.3f)});
    addTo(quads, {random.point(5.0f), random.direction() * random.uniform(0.1f, 0.6f), random.direction() * 0.3f});
    addTo(disks, {random.point(5.0f), random.direction(), random.uniform(0.05f, 0.3f)});
    addTo(upright,
          {random.point(5.0f), randomHalf(random), random.uniform(0.1f, 1.0f), 0.0f, random.uniform(-1, 1), 0.0f});
    addTo(turned, {random.point(5.0f), randomHalf(random), random.uniform(0.1f, 1.0f), random.uniform(-1.0f, 1.0f),
                   random.uniform(-1.0f, 1.0f), random.uniform(-1.0f, 1.0f)});
    const Vec3f a = random.point(5.0f);
    addTo(mesh, a, a + random.direction() * 0.5f, a + random.direction() * 0.5f);
  }
  SceneDescription scene;
  const ShapeGeometry all[] = {spheres, quads, disks, upright, turned, mesh};
  Id material = 0;
  for (const ShapeGeometry& geometry : all) scene.addShape("shape", geometry, material++);
  scene.addShape("custom", CustomShapeSet{{std::make_shared<Slab>(1.0f), std::make_shared<Slab>(2.0f, 3.0f)}},
                 material);
  return scene;
}

/// Scale, then rotate about x, y, z (radians), then translate.
inline Matrix transformOf(Vec3f rotation, Vec3f scale, Vec3f translation) {
  Matrix s, r, t;
  s.setScale(toImath(scale));
  r.setEulerAngles(toImath(rotation));
  t.setTranslation(toImath(translation));
  return s * r * t;
}

}  // namespace steradian::test
