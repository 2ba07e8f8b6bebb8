#pragma once
/// The primitives of a description as sampling targets.
#include <cstddef>

#include "steradian/accel/shapes/sampled_shape.h"
#include "steradian/core/description.h"

namespace steradian {

/// Primitive `primitive` of a set. Throws Error (Scene) for custom shapes: they cannot be sampled.
SampledShape sampledShapeOf(const ShapeGeometry& geometry, std::size_t primitive);

}  // namespace steradian
