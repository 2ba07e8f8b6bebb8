#pragma once
/// Triangles of meshes, as a leaf kind (leaf.h).
#include "steradian/accel/shapes/clusters/leaf.h"
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

struct TriangleLeaf {
  using Set = TriangleMesh;
  using Shape = Triangle<float>;
  static bool takes(const Set&) { return true; }
  static Shape at(const Set& set, std::size_t i) { return triangleAt(set, i); }

  static constexpr int rows = 9;
  static void put(ClusterRow* to, int i, const Shape& t) {
    putColumn<rows>(to, i, {t.a.x, t.a.y, t.a.z, t.b.x, t.b.y, t.b.z, t.c.x, t.c.y, t.c.z});
  }
  static Shape get(const ClusterRow* from, int i) {
    return {vectorAt(from, 0, i), vectorAt(from, 3, i), vectorAt(from, 6, i)};
  }
  template <class F>
  static ShapeHit<F> intersect(const ClusterRow* from, int i, const Ray<F>& ray) {
    const Triangle<F> triangle{loadVector<F>(from, 0, i), loadVector<F>(from, 3, i), loadVector<F>(from, 6, i)};
    return steradian::intersect(triangle, ray);
  }

  using Flat = Shape;
  static Flat flat(const Shape& t) { return t; }
  template <class F>
  static ShapeHit<F> intersectFlat(const Flat& t, const Ray<F>& ray, const RayByAxis<F>&) {
    return steradian::intersect(inLanes<F>(t), ray);
  }

  /// Vertices, then the error and the normal that all points share.
  static constexpr int pointRows = 4;
  static void writePoint(PointNumbers& to, const Shape& t) {
    const ShapePoint<float> on = shapePoint(t, {}, {});
    writeVectors(to, {t.a, t.b, t.c, on.error, on.normal});
  }
  template <class F>
  static ShapePoint<F> point(const PointRows<F>& rowsOf, const Ray<F>& ray, const ShapeHit<F>& hit,
                             bool parametersKnown, Vec2<F>* uv) {
    const auto n = rowsOf.template read<pointRows>();
    const Triangle<F> triangle{vectorOf(n, 0), vectorOf(n, 1), vectorOf(n, 2)};
    const ShapeHit<F> at = parametersKnown ? hit : steradian::intersect(triangle, ray);
    if (uv) *uv = triangleUv(at);
    return {positionOf(triangle, at), vectorOf(n, 3), vectorOf(n, 4)};
  }
};

}  // namespace steradian
