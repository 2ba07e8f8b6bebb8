#pragma once
/// Boxes, as two leaf kinds (leaf.h): those rotated about y alone or not at all, and all others. The face that is hit
/// is computed with the surface point.
#include "steradian/accel/shapes/clusters/leaf.h"
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

namespace detail {
template <class F, class Axes>
ShapeHit<F> intersectBox(const OrientedBox<F, Axes>& box, const Ray<F>& ray) {
  const BoxCrossing<F> crossing = crossBox(box, ray);
  return {crossing.valid, crossing.t, F(0.0f), F(0.0f)};
}
template <class F, class Axes>
ShapePoint<F> pointOnBox(const OrientedBox<F, Axes>& box, const Ray<F>& ray, const ShapeHit<F>& hit, Vec2<F>* uv) {
  const BoxPlace<F> place = boxPlace(box, ray, hit.t);
  if (uv) *uv = uvOf(box, place);
  return shapePoint(box, place);
}
}  // namespace detail

/// Two floats of orientation, and half the work of TurnedBoxLeaf.
struct UprightBoxLeaf {
  using Set = BoxSet;
  using Shape = UprightBox<float>;
  static bool takes(const Set& set) { return areUpright(set); }
  static Shape at(const Set& set, std::size_t i) { return uprightBoxAt(set, i); }

  static constexpr int rows = 8;
  static void put(ClusterRow* to, int i, const Shape& b) {
    putColumn<rows>(to, i,
                    {b.center.x, b.center.y, b.center.z, b.half.x, b.half.y, b.half.z, b.axes.cosine, b.axes.sine});
  }
  static Shape get(const ClusterRow* from, int i) {
    return {vectorAt(from, 0, i), vectorAt(from, 3, i), {from[6][i], from[7][i]}};
  }
  template <class F>
  static ShapeHit<F> intersect(const ClusterRow* from, int i, const Ray<F>& ray) {
    const UprightBox<F> box{
        loadVector<F>(from, 0, i), loadVector<F>(from, 3, i), {load<F>(from[6] + i), load<F>(from[7] + i)}};
    return detail::intersectBox(box, ray);
  }

  using Flat = Shape;
  static Flat flat(const Shape& b) { return b; }
  template <class F>
  static ShapeHit<F> intersectFlat(const Flat& b, const Ray<F>& ray, const RayByAxis<F>&) {
    return detail::intersectBox(inLanes<F>(b), ray);
  }

  static constexpr int pointRows = 2;
  static void writePoint(PointNumbers& to, const Shape& b) {
    writeVectors(to, {b.center, b.half, {b.axes.cosine, b.axes.sine, 0.0f}});
  }
  template <class F>
  static ShapePoint<F> point(const PointRows<F>& rowsOf, const Ray<F>& ray, const ShapeHit<F>& hit, bool, Vec2<F>* uv) {
    const auto n = rowsOf.template read<pointRows>();
    return detail::pointOnBox(UprightBox<F>{vectorOf(n, 0), vectorOf(n, 1), {n[6], n[7]}}, ray, hit, uv);
  }
};

/// In any orientation, by a unit quaternion.
struct TurnedBoxLeaf {
  using Set = BoxSet;
  using Shape = TurnedBox;
  static bool takes(const Set& set) { return !areUpright(set); }
  static Shape at(const Set& set, std::size_t i) { return turnedBoxAt(set, i); }

  static constexpr int rows = 10;
  static void put(ClusterRow* to, int i, const Shape& b) {
    putColumn<rows>(to, i, {b.center.x, b.center.y, b.center.z, b.half.x, b.half.y, b.half.z, b.w, b.x, b.y, b.z});
  }
  static Shape get(const ClusterRow* c, int i) {
    return {vectorAt(c, 0, i), vectorAt(c, 3, i), c[6][i], c[7][i], c[8][i], c[9][i]};
  }
  template <class F>
  static ShapeHit<F> intersect(const ClusterRow* c, int i, const Ray<F>& ray) {
    const Box<F> box{loadVector<F>(c, 0, i), loadVector<F>(c, 3, i),
                     axesOfQuaternion(load<F>(c[6] + i), load<F>(c[7] + i), load<F>(c[8] + i), load<F>(c[9] + i))};
    return detail::intersectBox(box, ray);
  }

  using Flat = Box<float>;
  static Flat flat(const Shape& b) { return boxOf(b); }
  template <class F>
  static ShapeHit<F> intersectFlat(const Flat& b, const Ray<F>& ray, const RayByAxis<F>&) {
    return detail::intersectBox(inLanes<F>(b), ray);
  }

  static constexpr int pointRows = 4;
  static void writePoint(PointNumbers& to, const Shape& turned) {
    const Box<float> b = boxOf(turned);
    writeVectors(to, {b.center, b.half, b.axes.x, b.axes.y, b.axes.z});
  }
  template <class F>
  static ShapePoint<F> point(const PointRows<F>& rowsOf, const Ray<F>& ray, const ShapeHit<F>& hit, bool, Vec2<F>* uv) {
    const auto n = rowsOf.template read<pointRows>();
    const Box<F> box{vectorOf(n, 0), vectorOf(n, 1), {vectorOf(n, 2), vectorOf(n, 3), vectorOf(n, 4)}};
    return detail::pointOnBox(box, ray, hit, uv);
  }
};

}  // namespace steradian
