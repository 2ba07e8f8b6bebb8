#pragma once
/// Quads along the axes, as a leaf kind (leaf.h). A set is of this kind if all of its quads are.
#include "steradian/accel/shapes/clusters/leaf.h"
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

struct AlignedQuadLeaf {
  using Set = QuadSet;
  using Shape = AlignedQuad;
  static bool takes(const Set& set) { return areAligned(set); }
  static Shape at(const Set& set, std::size_t i) { return *AlignedQuad::of(quadAt(set, i)); }

  /// Corner and edges of AlignedQuad, and a code for its axes: 2 * that of the normal + 1 if v lies along the next
  /// axis after it.
  static constexpr int rows = 6;
  static void put(ClusterRow* to, int i, const Shape& q) {
    const int code = 2 * q.axis[2] + (q.axis[1] == (q.axis[2] + 1) % 3 ? 1 : 0);
    putColumn<rows>(to, i, {q.corner[0], q.corner[1], q.corner[2], q.edge[0], q.edge[1], static_cast<float>(code)});
  }
  static Shape get(const ClusterRow* c, int i) {
    const int code = static_cast<int>(c[5][i]), normal = code / 2, next = (normal + 1) % 3, last = (normal + 2) % 3;
    const bool swapped = code % 2 != 0;
    return {{swapped ? last : next, swapped ? next : last, normal},
            {c[0][i], c[1][i], c[2][i]},
            {c[3][i], c[4][i]},
            {1.0f / c[3][i], 1.0f / c[4][i]}};
  }
  template <class F>
  static ShapeHit<F> intersect(const ClusterRow* c, int i, const Ray<F>& ray) {
    const F code = load<F>(c[5] + i), one(1.0f);
    const MaskOf<F> isX = code < F(2.0f), isY = (code >= F(2.0f)) & (code < F(4.0f));
    const MaskOf<F> swapped = (code == F(1.0f)) | (code == F(3.0f)) | (code == F(5.0f));
    // The components of a vector along u, v and the normal.
    const auto along = [&](const Vec3<F>& v) {
      const F next = select(isX, v.y, select(isY, v.z, v.x)), last = select(isX, v.z, select(isY, v.x, v.y));
      return std::array<F, 3>{select(swapped, last, next), select(swapped, next, last),
                              select(isX, v.x, select(isY, v.y, v.z))};
    };
    const std::array<F, 3> d = along(ray.direction);
    return crossAlignedQuad<F>({load<F>(c[0] + i), load<F>(c[1] + i), load<F>(c[2] + i)},
                               {one / load<F>(c[3] + i), one / load<F>(c[4] + i)}, along(ray.origin), {d[0], d[1]},
                               reciprocalOfComponent(d[2]), ray.tMin, ray.tMax);
  }

  using Flat = Shape;
  static Flat flat(const Shape& q) { return q; }
  template <class F>
  static ShapeHit<F> intersectFlat(const Flat& q, const Ray<F>& ray, const RayByAxis<F>& byAxis) {
    return steradian::intersect(q, byAxis, ray.tMin, ray.tMax);
  }

  /// The lowest and the highest corner, then the error and the normal that all points share.
  static constexpr int pointRows = 3;
  static void writePoint(PointNumbers& to, const Shape& shape) {
    const Quad<float> q = shape.quad();
    const ShapePoint<float> on = shapePoint(q, {}, {});
    const Vec3f opposite = q.corner + q.u + q.v;
    writeVectors(to, {minimum(q.corner, opposite), maximum(q.corner, opposite), on.error, on.normal});
  }
  template <class F>
  static ShapePoint<F> point(const PointRows<F>& rowsOf, const Ray<F>& ray, const ShapeHit<F>& hit, bool, Vec2<F>* uv) {
    const auto n = rowsOf.template read<pointRows>();
    if (uv) *uv = quadUv(hit);
    return {positionBetween(vectorOf(n, 0), vectorOf(n, 1), ray, hit.t), vectorOf(n, 2), vectorOf(n, 3)};
  }
};

}  // namespace steradian
