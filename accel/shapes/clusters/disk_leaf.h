#pragma once
/// Disks, as a leaf kind (leaf.h).
#include "steradian/accel/shapes/clusters/leaf.h"
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

struct DiskLeaf {
  using Set = DiskSet;
  using Shape = Disk<float>;
  static bool takes(const Set&) { return true; }
  static Shape at(const Set& set, std::size_t i) { return diskAt(set, i); }

  static constexpr int rows = 7;
  static void put(ClusterRow* to, int i, const Shape& d) {
    putColumn<rows>(to, i, {d.center.x, d.center.y, d.center.z, d.normal.x, d.normal.y, d.normal.z, d.radius});
  }
  static Shape get(const ClusterRow* from, int i) { return {vectorAt(from, 0, i), vectorAt(from, 3, i), from[6][i]}; }
  template <class F>
  static ShapeHit<F> intersect(const ClusterRow* from, int i, const Ray<F>& ray) {
    const Disk<F> disk{loadVector<F>(from, 0, i), loadVector<F>(from, 3, i), load<F>(from[6] + i)};
    return steradian::intersect(disk, ray);
  }

  using Flat = Shape;
  static Flat flat(const Shape& d) { return d; }
  template <class F>
  static ShapeHit<F> intersectFlat(const Flat& d, const Ray<F>& ray, const RayByAxis<F>&) {
    return steradian::intersect(inLanes<F>(d), ray);
  }

  static constexpr int pointRows = 2;
  static void writePoint(PointNumbers& to, const Shape& d) {
    writeVectors(to, {d.center, d.normal, {d.radius, 0.0f, 0.0f}});
  }
  template <class F>
  static ShapePoint<F> point(const PointRows<F>& rowsOf, const Ray<F>& ray, const ShapeHit<F>& hit, bool, Vec2<F>* uv) {
    const auto n = rowsOf.template read<pointRows>();
    const Disk<F> disk{vectorOf(n, 0), vectorOf(n, 1), n[6]};
    const ShapePoint<F> on = shapePoint(disk, ray, hit);
    if (uv) *uv = uvOf(disk, on.position);
    return on;
  }
};

}  // namespace steradian
