#pragma once
/// Spheres that move along lines, as a leaf kind (leaf.h).
#include "steradian/accel/shapes/clusters/sphere_leaf.h"
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

struct MovingSphereLeaf {
  using Set = SphereSet;
  using Shape = MovingSphere<float>;
  static bool takes(const Set& set) { return areMoving(set); }
  static Shape at(const Set& set, std::size_t i) { return movingSphereAt(set, i); }

  static constexpr int rows = 7;
  static void put(ClusterRow* to, int i, const Shape& s) {
    putColumn<rows>(to, i, {s.center.x, s.center.y, s.center.z, s.move.x, s.move.y, s.move.z, s.radius});
  }
  static Shape get(const ClusterRow* from, int i) { return {vectorAt(from, 0, i), vectorAt(from, 3, i), from[6][i]}; }
  template <class F>
  static ShapeHit<F> intersect(const ClusterRow* from, int i, const Ray<F>& ray) {
    const MovingSphere<F> sphere{loadVector<F>(from, 0, i), loadVector<F>(from, 3, i), load<F>(from[6] + i)};
    return steradian::intersect(sphere, ray);
  }

  using Flat = Shape;
  static Flat flat(const Shape& s) { return s; }
  template <class F>
  static ShapeHit<F> intersectFlat(const Flat& s, const Ray<F>& ray, const RayByAxis<F>&) {
    return steradian::intersect(inLanes<F>(s), ray);
  }

  static constexpr int pointRows = 2;
  static void writePoint(PointNumbers& to, const Shape& s) {
    writeVectors(to, {s.center, s.move, {s.radius, 0.0f, 0.0f}});
  }
  template <class F>
  static ShapePoint<F> point(const PointRows<F>& rowsOf, const Ray<F>& ray, const ShapeHit<F>& hit, bool, Vec2<F>* uv) {
    const auto n = rowsOf.template read<pointRows>();
    const MovingSphere<F> sphere{vectorOf(n, 0), vectorOf(n, 1), n[6]};
    return SphereLeaf::pointOn(sphere.at(ray.time), ray, hit, uv);
  }
};

}  // namespace steradian
