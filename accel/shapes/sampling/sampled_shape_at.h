#pragma once
/// The primitives of a description as sampling targets.
#include <cstddef>

#include "steradian/accel/shapes/sampling/sampled_shape.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

/// Primitive `primitive` of a set. Throws Error (Scene) for custom shapes: they cannot be sampled.
SampledShape sampledShapeOf(const ShapeGeometry& geometry, std::size_t primitive);

/// Where a primitive of a scene is: under its own motion and that of its set, and as copy `copy` of `instances` if it
/// belongs to a group.
SampledShape sampledShapeOf(const ShapeDescription& shape, std::size_t primitive,
                            const InstanceSet* instances = nullptr, std::size_t copy = 0);

}  // namespace steradian
