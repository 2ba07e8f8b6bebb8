#pragma once
/// A primitive as its cluster keeps it.
#include <variant>

#include "steradian/accel/shapes/primitives/aligned_quad.h"
#include "steradian/accel/shapes/primitives/box.h"
#include "steradian/accel/shapes/primitives/disk.h"
#include "steradian/accel/shapes/primitives/moving_sphere.h"
#include "steradian/accel/shapes/primitives/quad.h"
#include "steradian/accel/shapes/primitives/sphere.h"
#include "steradian/accel/shapes/primitives/triangle.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

using LeafShape = std::variant<Quad<float>, AlignedQuad, UprightBox<float>, Sphere<float>, MovingSphere<float>,
                               Triangle<float>, Disk<float>, TurnedBox>;

/// The primitives of a set, all but custom ones. A set goes through the kernel of aligned quads, upright boxes or
/// moving spheres as a whole or not at all. The set must outlive this.
class LeafShapes {
 public:
  explicit LeafShapes(const ShapeGeometry& set);
  LeafShape operator[](std::size_t i) const;

 private:
  const ShapeGeometry& set_;
  bool special_;
};

}  // namespace steradian
