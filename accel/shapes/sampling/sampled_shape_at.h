#pragma once
/// The primitives of a description as sampling targets.
#include <cstddef>
#include <optional>

#include "steradian/accel/shapes/sampling/sampled_shape.h"
#include "steradian/core/scene/placements.h"

namespace STERADIAN_API steradian {

/// Primitive `primitive` of a set. Throws Error (Scene) for custom shapes: they cannot be sampled.
SampledShape sampledShapeOf(const ShapeGeometry& geometry, std::size_t primitive);

/// Primitive `primitive` of a shape where it is placed: under the shape's own motion, and then that of the instance.
SampledShape sampledShapeOf(const ShapeDescription& shape, std::size_t primitive,
                            const std::optional<InstancePlacement>& instance = std::nullopt);

}  // namespace steradian
