#pragma once
/// What a leaf kind is: one kind of primitive, as clusters keep it and as rays are intersected with it.
///
/// Each kind is a struct in a file of its own, and stands in the one list of them (leaf_kinds.h). It has
///
///     using Set = QuadSet;              // the alternative of ShapeGeometry that holds such primitives
///     using Shape = Quad<float>;        // a primitive; another type for each kind
///     static bool takes(const Set&);    // whether this kind takes the set: as a whole or not at all
///     static Shape at(const Set&, std::size_t i);
///
///     // In a cluster: `rows` floats of each primitive, one ray against kClusterSize primitives.
///     static constexpr int rows;
///     static void put(ClusterRow* rows, int i, const Shape&);
///     static Shape get(const ClusterRow* rows, int i);
///     template <class F> static ShapeHit<F> intersect(const ClusterRow* rows, int first, const Ray<F>&);
///
///     // By itself: rays in lanes against one primitive (flat_primitives.h).
///     using Flat = Quad<float>;
///     static Flat flat(const Shape&);
///     template <class F> static ShapeHit<F> intersectFlat(const Flat&, const Ray<F>&, const RayByAxis<F>&);
///
///     // The points of hits in lanes (point_record.h): `pointRows` times four floats of each primitive.
///     static constexpr int pointRows;
///     static void writePoint(PointNumbers&, const Shape&);
///     template <class F> static ShapePoint<F> point(const PointRows<F>&, const Ray<F>&, const ShapeHit<F>&,
///                                                   bool parametersKnown, Vec2<F>* uv);
///
/// The two intersections and the points give the same bits as those of a single primitive and a single ray.
#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <utility>

#include "steradian/accel/shapes/primitives/aligned_quad.h"
#include "steradian/accel/shapes/primitives/in_lanes.h"
#include "steradian/accel/shapes/primitives/shape_at.h"
#include "steradian/accel/shapes/primitives/shape_point.h"
#include "steradian/core/base/api.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

/// Primitives of a cluster.
inline constexpr int kClusterSize = 8;

/// Rows of a cluster: one float of each primitive side by side.
using ClusterRow = float[kClusterSize];

/// Writes the values down column i, one in each row.
template <std::size_t n>
void putColumn(ClusterRow* rows, int i, const std::array<float, n>& values) {
  for (std::size_t r = 0; r < n; ++r) rows[r][i] = values[r];
}
/// The vector whose components are in three rows, from row `first` on.
template <class F>
Vec3<F> loadVector(const ClusterRow* rows, int first, int i) {
  return {load<F>(rows[first] + i), load<F>(rows[first + 1] + i), load<F>(rows[first + 2] + i)};
}
inline Vec3f vectorAt(const ClusterRow* rows, int first, int i) {
  return {rows[first][i], rows[first + 1][i], rows[first + 2][i]};
}

/// What the points on a primitive need: 16 floats at most.
using PointNumbers = std::array<float, 16>;

inline void writeVectors(PointNumbers& numbers, std::initializer_list<Vec3f> vectors) {
  float* to = numbers.data();
  for (const Vec3f v : vectors) {
    *to++ = v.x;
    *to++ = v.y;
    *to++ = v.z;
  }
}

/// The numbers of the primitives that the lanes' rays hit, read four at a time. `offset`: where each lane's numbers
/// begin in the table, in floats.
template <class F>
class PointRows {
 public:
  PointRows(const float* table, const UintOf<F>& offset) : table_(table), offset_(offset) {}

  /// The first n x 4 floats.
  template <int n>
  std::array<F, 4 * n> read() const {
    std::array<F, 4 * n> all;
    for (std::size_t r = 0; r < n; ++r) {
      const auto row = gather4(table_ + 4 * r, offset_);
      for (std::size_t k = 0; k < 4; ++k) all[4 * r + k] = row[k];
    }
    return all;
  }

 private:
  const float* table_;
  const UintOf<F>& offset_;
};

/// Vector k of numbers that are vectors side by side.
template <class F, std::size_t n>
Vec3<F> vectorOf(const std::array<F, n>& numbers, std::size_t k) {
  return {numbers[3 * k], numbers[3 * k + 1], numbers[3 * k + 2]};
}

}  // namespace steradian
