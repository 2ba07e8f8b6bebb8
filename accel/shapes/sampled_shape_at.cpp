#include "steradian/accel/shapes/sampled_shape_at.h"

#include "steradian/accel/shapes/shape_at.h"
#include "steradian/core/diagnostics.h"

namespace steradian {
namespace {

SampledShape shapeOf(const SphereSet& set, std::size_t i) { return SampledShape(sphereAt(set, i)); }
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

}  // namespace steradian
