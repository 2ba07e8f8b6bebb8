#pragma once
/// Axis-aligned boxes.
#include "steradian/core/math/vec.h"

namespace STERADIAN_API steradian {

struct Bounds3 {
  Vec3f low{kInfinity, kInfinity, kInfinity}, high{-kInfinity, -kInfinity, -kInfinity};

  bool empty() const { return !(low.x <= high.x && low.y <= high.y && low.z <= high.z); }
  void include(Vec3f p) {
    low = minimum(low, p);
    high = maximum(high, p);
  }
  void include(const Bounds3& b) {
    low = minimum(low, b.low);
    high = maximum(high, b.high);
  }
  Vec3f center() const { return (low + high) * 0.5f; }
  Vec3f extent() const { return high - low; }
  /// The largest |coordinate|: what absolute rounding errors scale with.
  float magnitude() const { return maxComponent(maximum(absolute(low), absolute(high))); }
};

}  // namespace steradian
