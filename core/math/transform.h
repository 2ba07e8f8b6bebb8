#pragma once
/// Affine transforms as Imath matrices. Imath multiplies row vectors: p' = p M, and A * B applies A first.
#include <Imath/ImathMatrix.h>

#include "steradian/core/math/bounds.h"

namespace STERADIAN_API steradian {

using Matrix = Imath::M44f;

inline Imath::V3f toImath(Vec3f v) { return {v.x, v.y, v.z}; }
inline Vec3f fromImath(const Imath::V3f& v) { return {v.x, v.y, v.z}; }

/// An affine map for each lane; rows as in Matrix.
template <class F>
struct AffineLanes {
  F rows[4][3];
  const F* operator[](int i) const { return rows[i]; }
};
/// Lane i of the map is matrices[i].
template <class F>
AffineLanes<F> affineLanes(const Matrix* matrices) {
  UintOf<F> offset(0u);
  for (int i = 0; i < widthOf<F>; ++i) setLane(offset, i, static_cast<std::uint32_t>(i * 16));
  AffineLanes<F> map;
  for (std::size_t r = 0; r < 4; ++r) {
    const auto row = gather4(&matrices[0][0][0] + 4 * r, offset);
    for (std::size_t k = 0; k < 3; ++k) map.rows[r][k] = row[k];
  }
  return map;
}

// M: Matrix, or AffineLanes<F>.

template <class M, class F>
Vec3<F> transformPoint(const M& m, Vec3<F> p) {
  return {p.x * F(m[0][0]) + p.y * F(m[1][0]) + p.z * F(m[2][0]) + F(m[3][0]),
          p.x * F(m[0][1]) + p.y * F(m[1][1]) + p.z * F(m[2][1]) + F(m[3][1]),
          p.x * F(m[0][2]) + p.y * F(m[1][2]) + p.z * F(m[2][2]) + F(m[3][2])};
}
template <class M, class F>
Vec3<F> transformVector(const M& m, Vec3<F> v) {
  return {v.x * F(m[0][0]) + v.y * F(m[1][0]) + v.z * F(m[2][0]),
          v.x * F(m[0][1]) + v.y * F(m[1][1]) + v.z * F(m[2][1]),
          v.x * F(m[0][2]) + v.y * F(m[1][2]) + v.z * F(m[2][2])};
}
/// A normal (not renormalised), by the inverse matrix of the transform: n' = n (M^-1)^T.
template <class M, class F>
Vec3<F> transformNormal(const M& inverse, Vec3<F> n) {
  return {n.x * F(inverse[0][0]) + n.y * F(inverse[0][1]) + n.z * F(inverse[0][2]),
          n.x * F(inverse[1][0]) + n.y * F(inverse[1][1]) + n.z * F(inverse[1][2]),
          n.x * F(inverse[2][0]) + n.y * F(inverse[2][1]) + n.z * F(inverse[2][2])};
}

/// The inverse of an affine, invertible matrix, exact but for the last rounding: error bounds rely on it.
Matrix affineInverse(const Matrix& m);
/// Bounds of the eight corners, moved by an affine map.
Bounds3 transformedBounds(const Bounds3& bounds, const Matrix& matrix);

}  // namespace steradian
