#include "steradian/core/math/transform.h"

namespace steradian {

Matrix affineInverse(const Matrix& m) {
  using Vec3d = Vec3<double>;
  const auto row = [&](int i) { return Vec3d{m[i][0], m[i][1], m[i][2]}; };
  const Vec3d x = row(0), y = row(1), z = row(2), origin = row(3);
  // Columns of the inverse: cross products of the rows over the determinant.
  const Vec3d yz = cross(y, z);
  const double scale = 1.0 / dot(x, yz);
  const Vec3d columns[3] = {yz * scale, cross(z, x) * scale, cross(x, y) * scale};
  Matrix inverse;
  for (int j = 0; j < 3; ++j) {
    inverse[0][j] = static_cast<float>(columns[j].x);
    inverse[1][j] = static_cast<float>(columns[j].y);
    inverse[2][j] = static_cast<float>(columns[j].z);
    inverse[3][j] = static_cast<float>(-dot(origin, columns[j]));
  }
  return inverse;
}

Bounds3 transformedBounds(const Bounds3& bounds, const Matrix& matrix) {
  Bounds3 result;
  if (bounds.empty()) return result;
  for (int corner = 0; corner < 8; ++corner) {
    result.include(transformPoint(
        matrix, Vec3f{corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y,
                      corner & 4 ? bounds.high.z : bounds.low.z}));
  }
  return result;
}

}  // namespace steradian
