#pragma once
/// The same shape in every lane.
#include "steradian/accel/shapes/primitives/box.h"
#include "steradian/accel/shapes/primitives/disk.h"
#include "steradian/accel/shapes/primitives/moving_sphere.h"
#include "steradian/accel/shapes/primitives/quad.h"
#include "steradian/accel/shapes/primitives/sphere.h"
#include "steradian/accel/shapes/primitives/triangle.h"

namespace STERADIAN_API steradian {

template <class F>
Sphere<F> inLanes(const Sphere<float>& s) {
  return {broadcast<F>(s.center), F(s.radius)};
}
template <class F>
MovingSphere<F> inLanes(const MovingSphere<float>& s) {
  return {broadcast<F>(s.center), broadcast<F>(s.move), F(s.radius)};
}
template <class F>
Quad<F> inLanes(const Quad<float>& q) {
  return {broadcast<F>(q.corner), broadcast<F>(q.u), broadcast<F>(q.v)};
}
template <class F>
Disk<F> inLanes(const Disk<float>& d) {
  return {broadcast<F>(d.center), broadcast<F>(d.normal), F(d.radius)};
}
template <class F>
Triangle<F> inLanes(const Triangle<float>& t) {
  return {broadcast<F>(t.a), broadcast<F>(t.b), broadcast<F>(t.c)};
}
template <class F>
Frame<F> inLanes(const Frame<float>& f) {
  return {broadcast<F>(f.x), broadcast<F>(f.y), broadcast<F>(f.z)};
}
template <class F>
AxesAboutY<F> inLanes(const AxesAboutY<float>& a) {
  return {F(a.cosine), F(a.sine)};
}
template <class F>
Box<F> inLanes(const Box<float>& b) {
  return {broadcast<F>(b.center), broadcast<F>(b.half), inLanes<F>(b.axes)};
}
template <class F>
UprightBox<F> inLanes(const UprightBox<float>& b) {
  return {broadcast<F>(b.center), broadcast<F>(b.half), inLanes<F>(b.axes)};
}

}  // namespace steradian
