#pragma once
/// Vectors, points, normals: two and three components of F. Scenes are right-handed, y up.
#include <cmath>

#include "steradian/core/math/math.h"

namespace STERADIAN_API steradian {

template <class F>
struct Vec2 {
  F x{}, y{};
};

template <class F>
struct Vec3 {
  F x{}, y{}, z{};

  friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
  friend Vec3 operator*(Vec3 a, F s) { return {a.x * s, a.y * s, a.z * s}; }
  friend Vec3 operator*(F s, Vec3 a) { return a * s; }
  friend Vec3 operator/(Vec3 a, F s) { return {a.x / s, a.y / s, a.z / s}; }
  friend Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  Vec3& operator+=(Vec3 b) { return *this = *this + b; }
  Vec3& operator-=(Vec3 b) { return *this = *this - b; }
  Vec3& operator*=(F s) { return *this = *this * s; }
};

// clang++ 14 does not deduce aggregates.
template <class F>
Vec2(F, F) -> Vec2<F>;
template <class F>
Vec3(F, F, F) -> Vec3<F>;

using Vec2f = Vec2<float>;
using Vec3f = Vec3<float>;

/// The same value in every lane.
template <class F>
Vec3<F> broadcast(Vec3f v) {
  return {F(v.x), F(v.y), F(v.z)};
}
template <class F>
Vec3f lane(const Vec3<F>& v, int i) {
  return {lane(v.x, i), lane(v.y, i), lane(v.z, i)};
}
template <class F>
void setLane(Vec3<F>& v, int i, Vec3f value) {
  setLane(v.x, i, value.x);
  setLane(v.y, i, value.y);
  setLane(v.z, i, value.z);
}
template <class F>
Vec2f lane(const Vec2<F>& v, int i) {
  return {lane(v.x, i), lane(v.y, i)};
}
template <class F>
void setLane(Vec2<F>& v, int i, Vec2f value) {
  setLane(v.x, i, value.x);
  setLane(v.y, i, value.y);
}

template <class F>
Vec2<F> select(MaskOf<F> m, const Vec2<F>& a, const Vec2<F>& b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y)};
}
template <class F>
Vec3<F> select(MaskOf<F> m, const Vec3<F>& a, const Vec3<F>& b) {
  return {select(m, a.x, b.x), select(m, a.y, b.y), select(m, a.z, b.z)};
}
template <class F>
F dot(Vec3<F> a, Vec3<F> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class F>
F absDot(Vec3<F> a, Vec3<F> b) {
  return absolute(dot(a, b));
}
template <class F>
Vec3<F> cross(Vec3<F> a, Vec3<F> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class F>
F lengthSquared(Vec3<F> a) {
  return dot(a, a);
}
template <class F>
F length(Vec3<F> a) {
  return squareRoot(dot(a, a));
}
/// Unit vector along a; a must not be zero.
template <class F>
Vec3<F> normalize(Vec3<F> a) {
  return a * (F(1.0f) / length(a));
}
template <class F>
Vec3<F> absolute(Vec3<F> a) {
  return {absolute(a.x), absolute(a.y), absolute(a.z)};
}
template <class F>
Vec3<F> minimum(Vec3<F> a, Vec3<F> b) {
  return {minimum(a.x, b.x), minimum(a.y, b.y), minimum(a.z, b.z)};
}
template <class F>
Vec3<F> maximum(Vec3<F> a, Vec3<F> b) {
  return {maximum(a.x, b.x), maximum(a.y, b.y), maximum(a.z, b.z)};
}
template <class F>
F maxComponent(Vec3<F> a) {
  return maximum(maximum(a.x, a.y), a.z);
}
/// v turned to the side of `reference`: dot(result, reference) >= 0.
template <class F>
Vec3<F> faceForward(Vec3<F> v, Vec3<F> reference) {
  return select(dot(v, reference) < F(0.0f), -v, v);
}

}  // namespace steradian
