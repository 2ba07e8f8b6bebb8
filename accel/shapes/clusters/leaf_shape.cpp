#include "steradian/accel/shapes/clusters/leaf_shape.h"

#include "steradian/accel/shapes/primitives/shape_at.h"

namespace steradian {

LeafShapes::LeafShapes(const ShapeGeometry& set) : set_(set) {
  const auto* quads = std::get_if<QuadSet>(&set);
  const auto* boxes = std::get_if<BoxSet>(&set);
  const auto* balls = std::get_if<SphereSet>(&set);
  special_ = (quads && areAligned(*quads)) || (boxes && areUpright(*boxes)) || (balls && areMoving(*balls));
}

LeafShape LeafShapes::operator[](std::size_t i) const {
  struct Visitor {
    std::size_t i;
    bool special;
    LeafShape operator()(const SphereSet& set) const {
      return special ? LeafShape(movingSphereAt(set, i)) : LeafShape(sphereAt(set, i));
    }
    LeafShape operator()(const QuadSet& set) const {
      return special ? LeafShape(*AlignedQuad::of(quadAt(set, i))) : LeafShape(quadAt(set, i));
    }
    LeafShape operator()(const BoxSet& set) const {
      return special ? LeafShape(uprightBoxAt(set, i)) : LeafShape(turnedBoxAt(set, i));
    }
    LeafShape operator()(const DiskSet& set) const { return diskAt(set, i); }
    LeafShape operator()(const TriangleMesh& mesh) const { return triangleAt(mesh, i); }
    LeafShape operator()(const CustomShapeSet&) const { return {}; }
  };
  return std::visit(Visitor{i, special_}, set_);
}

}  // namespace steradian
