#pragma once
/// Spheres at rest, as a leaf kind (leaf.h).
#include "steradian/accel/shapes/clusters/leaf.h"
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

struct SphereLeaf {
  using Set = SphereSet;
  using Shape = Sphere<float>;
  static bool takes(const Set& set) { return !areMoving(set); }
  static Shape at(const Set& set, std::size_t i) { return sphereAt(set, i); }

  static constexpr int rows = 4;
  static void put(ClusterRow* to, int i, const Shape& s) {
    putColumn<rows>(to, i, {s.center.x, s.center.y, s.center.z, s.radius});
  }
  static Shape get(const ClusterRow* from, int i) { return {vectorAt(from, 0, i), from[3][i]}; }
  template <class F>
  static ShapeHit<F> intersect(const ClusterRow* from, int i, const Ray<F>& ray) {
    return steradian::intersect(Sphere<F>{loadVector<F>(from, 0, i), load<F>(from[3] + i)}, ray);
  }

  using Flat = Shape;
  static Flat flat(const Shape& s) { return s; }
  template <class F>
  static ShapeHit<F> intersectFlat(const Flat& s, const Ray<F>& ray, const RayByAxis<F>&) {
    return steradian::intersect(inLanes<F>(s), ray);
  }

  static constexpr int pointRows = 1;
  static void writePoint(PointNumbers& to, const Shape& s) { writeVectors(to, {s.center, {s.radius, 0.0f, 0.0f}}); }
  template <class F>
  static ShapePoint<F> point(const PointRows<F>& rowsOf, const Ray<F>& ray, const ShapeHit<F>& hit, bool, Vec2<F>* uv) {
    const auto n = rowsOf.template read<pointRows>();
    return pointOn(Sphere<F>{vectorOf(n, 0), n[3]}, ray, hit, uv);
  }
  template <class F>
  static ShapePoint<F> pointOn(const Sphere<F>& sphere, const Ray<F>& ray, const ShapeHit<F>& hit, Vec2<F>* uv) {
    const ShapePoint<F> on = shapePoint(sphere, ray, hit);
    if (uv) *uv = sphereUv(on.normal);
    return on;
  }
};

}  // namespace steradian
