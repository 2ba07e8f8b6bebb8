#pragma once
/// One primitive of a description's set, and its bounds.
#include "steradian/accel/shapes/primitives/aligned_quad.h"
#include "steradian/accel/shapes/primitives/box.h"
#include "steradian/accel/shapes/primitives/disk.h"
#include "steradian/accel/shapes/primitives/moving_sphere.h"
#include "steradian/accel/shapes/primitives/quad.h"
#include "steradian/accel/shapes/primitives/sphere.h"
#include "steradian/accel/shapes/primitives/triangle.h"
#include "steradian/core/math/bounds.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

Sphere<float> sphereAt(const SphereSet& set, std::size_t i);  ///< at time 0
MovingSphere<float> movingSphereAt(const SphereSet& set, std::size_t i);
/// Whether any sphere of the set moves: then all of them use the kernel of moving spheres.
bool areMoving(const SphereSet& set);
Quad<float> quadAt(const QuadSet& set, std::size_t i);
Disk<float> diskAt(const DiskSet& set, std::size_t i);
Triangle<float> triangleAt(const TriangleMesh& mesh, std::size_t i);
TurnedBox turnedBoxAt(const BoxSet& set, std::size_t i);  ///< its quaternion is normalised once more

/// Whether the i-th box is rotated about y alone or not at all. Such boxes use UprightBox everywhere, so that every
/// query computes the same axes.
bool isUpright(const BoxSet& set, std::size_t i);
bool areUpright(const BoxSet& set);                                ///< all of them
UprightBox<float> uprightBoxAt(const BoxSet& set, std::size_t i);  ///< needs isUpright
/// Whether all quads are AlignedQuads. Only such sets use that kernel, so that every query computes the same.
bool areAligned(const QuadSet& set);
/// With the axes that the queries use.
Box<float> boxOf(const UprightBox<float>& box);
Box<float> boxOf(const TurnedBox& box);
Box<float> boxAt(const BoxSet& set, std::size_t i);

Bounds3 boundsOf(const Sphere<float>& sphere);
Bounds3 boundsOf(const MovingSphere<float>& sphere);  ///< at all times
Bounds3 boundsOf(const Quad<float>& quad);
Bounds3 boundsOf(const AlignedQuad& quad);
Bounds3 boundsOf(const Disk<float>& disk);
Bounds3 boundsOf(const Triangle<float>& triangle);
Bounds3 boundsOf(const Box<float>& box);
Bounds3 boundsOf(const UprightBox<float>& box);
Bounds3 boundsOf(const TurnedBox& box);

/// Bounds of one primitive of any kind.
Bounds3 boundsOf(const ShapeGeometry& geometry, std::size_t i);

}  // namespace steradian
