#include "steradian/accel/shapes/sampling/sampled_shape_at.h"

#include "steradian/accel/shapes/primitives/shape_at.h"
#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

SampledShape shapeOf(const SphereSet& set, std::size_t i) {
  const MovingSphere<float> sphere = movingSphereAt(set, i);
  SampledShape start(Sphere<float>{sphere.center, sphere.radius});
  if (!(lengthSquared(sphere.move) > 0.0f)) return start;
  Motion motion;
  motion.close.setTranslation(toImath(sphere.move));
  return inMotion(start, MovingTransform(motion));
}
SampledShape shapeOf(const QuadSet& set, std::size_t i) { return SampledShape(quadAt(set, i)); }
SampledShape shapeOf(const BoxSet& set, std::size_t i) { return SampledShape(boxAt(set, i)); }
SampledShape shapeOf(const DiskSet& set, std::size_t i) { return SampledShape(diskAt(set, i)); }
SampledShape shapeOf(const TriangleMesh& mesh, std::size_t i) { return SampledShape(triangleAt(mesh, i)); }
SampledShape shapeOf(const CustomShapeSet&, std::size_t) {
  throw Error(ErrorKind::Scene, "a custom shape can be neither a light nor a sampling target");
}

}  // namespace

SampledShape sampledShapeOf(const ShapeGeometry& geometry, std::size_t primitive) {
  return std::visit([&](const auto& set) { return shapeOf(set, primitive); }, geometry);
}

SampledShape sampledShapeOf(const ShapeDescription& shape, std::size_t primitive,
                            const std::optional<InstancePlacement>& instance) {
  SampledShape placed = sampledShapeOf(shape.geometry, primitive);
  const auto move = [&](const Motion& motion) {
    placed = motion.open == motion.close ? transformed(placed, motion.open) : inMotion(placed, MovingTransform(motion));
  };
  if (shape.motion) move(*shape.motion);
  if (instance) move(instance->motion().value_or(Motion{instance->localToWorld(), instance->localToWorld()}));
  return placed;
}

}  // namespace steradian
