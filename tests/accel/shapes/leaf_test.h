#pragma once
/// What the tests of the leaf kernels share: random rays, and the comparison with a result in double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "steradian/accel/shapes/clusters/cluster.h"

namespace steradian::test {

using Vec3d = Vec3<double>;

inline Vec3d toDouble(Vec3f v) { return {v.x, v.y, v.z}; }

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
  /// From within `reach` of the origin towards a point within `aim` of `target`.
  Ray<float> rayTowards(Vec3f target, float aim, float reach) {
    const Vec3f origin = point(reach);
    return {origin, normalize(target + point(aim) - origin)};
  }
};

/// The result in double precision. `margin`: how far the ray would have to move to change it, scene units.
struct Truth {
  bool hit = false;
  double t = 0.0;
  double margin = 0.0;
};

/// Compares one kernel call with the result in double precision, if its margin exceeds `clear`.
inline void expectAgrees(const ShapeHit<float>& hit, const Truth& truth, double clear, double tolerance) {
  if (truth.margin < clear) return;
  ASSERT_EQ(hit.valid, truth.hit) << "margin " << truth.margin << ", true t " << truth.t << ", t " << hit.t;
  if (truth.hit) {
    ASSERT_NEAR(hit.t, truth.t, tolerance);
  }
}

/// Lane i of `wide` is exactly what width 1 gives.
template <class F>
void expectLane(const ShapeHit<F>& wide, int i, const ShapeHit<float>& one) {
  ASSERT_EQ(lane(wide.valid, i), one.valid);
  if (!one.valid) return;
  ASSERT_EQ(lane(wide.t, i), one.t);
  ASSERT_EQ(lane(wide.u, i), one.u);
  ASSERT_EQ(lane(wide.v, i), one.v);
}

/// Lanes over primitives with one ray, and lanes over rays with one primitive, give what width 1 gives. `widen` makes
/// a shape of F from eight shapes, `make` a random shape, `aim` a random ray at it.
template <class Make, class Widen>
void expectWidthsAgree(unsigned seed, const Make& make, const Widen& widen) {
  using F = Lanes<8>;
  Random random(seed);
  for (int round = 0; round < 200; ++round) {
    decltype(make(random)) shapes[8];
    for (auto& shape : shapes) shape = make(random);
    const Ray<float> ray = random.rayTowards({0.0f, 0.0f, 0.0f}, 1.0f, 4.0f);
    const ShapeHit<F> overShapes = intersect(widen(shapes), broadcastRay<F>(ray));
    for (int i = 0; i < 8; ++i) ASSERT_NO_FATAL_FAILURE(expectLane(overShapes, i, intersect(shapes[i], ray)));

    decltype(make(random)) same[8];
    for (auto& shape : same) shape = shapes[0];
    Ray<F> rays;
    Ray<float> each[8];
    for (int i = 0; i < 8; ++i) {
      each[i] = random.rayTowards({0.0f, 0.0f, 0.0f}, 1.0f, 4.0f);
      setLane(rays, i, each[i]);
    }
    const ShapeHit<F> overRays = intersect(widen(same), rays);
    for (int i = 0; i < 8; ++i) ASSERT_NO_FATAL_FAILURE(expectLane(overRays, i, intersect(shapes[0], each[i])));
  }
}

/// Eight values of a member, side by side.
template <class Shape, class Member>
Lanes<8> gatherLanes(const Shape (&shapes)[8], const Member& member) {
  Lanes<8> r;
  for (int i = 0; i < 8; ++i) r.set(i, member(shapes[i]));
  return r;
}
template <class Shape>
Vec3<Lanes<8>> gatherVectors(const Shape (&shapes)[8], Vec3f Shape::*member) {
  Vec3<Lanes<8>> r;
  for (int i = 0; i < 8; ++i) steradian::setLane(r, i, shapes[i].*member);
  return r;
}

}  // namespace steradian::test
