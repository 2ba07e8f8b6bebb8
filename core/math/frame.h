#pragma once
/// Orthonormal frame about a unit z axis: local directions have the normal along (0, 0, 1).
#include "steradian/core/math/vec.h"

namespace STERADIAN_API steradian {

template <class F>
struct Frame {
  Vec3<F> x, y, z;

  /// Frame whose z is the unit vector n; continuous but for n.z crossing 0 (Duff et al. 2017, JCGT 6(1)).
  static Frame fromZ(Vec3<F> n) {
    const F sign = copySign(F(1.0f), n.z);
    const F a = F(-1.0f) / (sign + n.z);
    const F b = n.x * n.y * a;
    return {{F(1.0f) + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
  }
  Vec3<F> toLocal(Vec3<F> v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
  Vec3<F> toWorld(Vec3<F> v) const { return x * v.x + y * v.y + z * v.z; }
};

}  // namespace steradian
