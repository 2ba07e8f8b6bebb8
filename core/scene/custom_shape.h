#pragma once
/// Shapes of the user's own: derive, and put into a CustomShapeSet of the description.
#include <optional>

#include "steradian/core/math/bounds.h"
#include "steradian/core/math/ray.h"

namespace STERADIAN_API steradian {

struct CustomHit {
  float t;       ///< ray.tMin < t < ray.tMax
  Vec3f normal;  ///< unit, outward
  Vec2f uv;
};

class CustomShape {
 public:
  virtual ~CustomShape() = default;
  /// Encloses the shape; finite. Called once, when the scene is built.
  virtual Bounds3 bounds() const = 0;
  /// Nearest hit. Called by many threads at once; must not throw.
  virtual std::optional<CustomHit> intersect(const Ray<float>& ray) const = 0;
};

}  // namespace steradian
