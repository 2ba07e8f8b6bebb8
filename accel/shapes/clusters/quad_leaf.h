#pragma once
/// Quads in any position, as a leaf kind (leaf.h).
#include <optional>

#include "steradian/accel/shapes/clusters/aligned_quad_leaf.h"
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

struct QuadLeaf {
  using Set = QuadSet;
  using Shape = Quad<float>;
  static bool takes(const Set& set) { return !areAligned(set); }
  static Shape at(const Set& set, std::size_t i) { return quadAt(set, i); }

  static constexpr int rows = 9;
  static void put(ClusterRow* to, int i, const Shape& q) {
    putColumn<rows>(to, i, {q.corner.x, q.corner.y, q.corner.z, q.u.x, q.u.y, q.u.z, q.v.x, q.v.y, q.v.z});
  }
  static Shape get(const ClusterRow* from, int i) {
    return {vectorAt(from, 0, i), vectorAt(from, 3, i), vectorAt(from, 6, i)};
  }
  template <class F>
  static ShapeHit<F> intersect(const ClusterRow* from, int i, const Ray<F>& ray) {
    const Quad<F> quad{loadVector<F>(from, 0, i), loadVector<F>(from, 3, i), loadVector<F>(from, 6, i)};
    return steradian::intersect(quad, ray);
  }

  using Flat = Shape;
  static Flat flat(const Shape& q) { return q; }
  template <class F>
  static ShapeHit<F> intersectFlat(const Flat& q, const Ray<F>& ray, const RayByAxis<F>&) {
    return steradian::intersect(inLanes<F>(q), ray);
  }

  /// Points on a quad that is aligned, although others of its set are not, are exactly in its plane.
  using PointsLike = AlignedQuadLeaf;
  static std::optional<AlignedQuad> pointsLike(const Shape& q) { return AlignedQuad::of(q); }

  /// Corner and edges, then the error and the normal that all points share.
  static constexpr int pointRows = 4;
  static void writePoint(PointNumbers& to, const Shape& q) {
    const ShapePoint<float> on = shapePoint(q, {}, {});
    writeVectors(to, {q.corner, q.u, q.v, on.error, on.normal});
  }
  template <class F>
  static ShapePoint<F> point(const PointRows<F>& rowsOf, const Ray<F>& ray, const ShapeHit<F>& hit,
                             bool parametersKnown, Vec2<F>* uv) {
    const auto n = rowsOf.template read<pointRows>();
    const Quad<F> quad{vectorOf(n, 0), vectorOf(n, 1), vectorOf(n, 2)};
    const ShapeHit<F> at = parametersKnown ? hit : steradian::intersect(quad, ray);
    if (uv) *uv = quadUv(at);
    return {positionOf(quad, at), vectorOf(n, 3), vectorOf(n, 4)};
  }
};

}  // namespace steradian
