#pragma once
/// A primitive as a sampling target: light, window, glass sphere, box. Width 1.
#include <memory>
#include <variant>

#include "steradian/accel/shapes/primitives/box.h"
#include "steradian/accel/shapes/primitives/disk.h"
#include "steradian/accel/shapes/primitives/sphere.h"
#include "steradian/accel/shapes/primitives/triangle.h"
#include "steradian/accel/shapes/sampling/quad_sampling.h"
#include "steradian/accel/shapes/sampling/transformed_shape.h"

namespace STERADIAN_API steradian {

/// Directions are sampled as the `*_sampling.h` of the shape says: uniform in the solid angle of the visible part where
/// that is worth it, else uniform by area. Both sides of a surface are targets; normalAt tells the caller which side is
/// seen. pdfDirection is the density with which sampleDirection chooses wi: 0 where the line misses. `time`, in [0, 1],
/// is that of the shutter: it matters for shapes that move.
class SampledShape {
 public:
  /// The rare and large alternative is allocated separately, so that it does not enlarge the others.
  using Shape = std::variant<Sphere<float>, PreparedQuad<float>, Disk<float>, Triangle<float>, Box<float>,
                             std::shared_ptr<const TransformedShape>>;

  explicit SampledShape(Shape shape) : shape_(std::move(shape)) {}
  explicit SampledShape(const Quad<float>& quad) : shape_(PreparedQuad<float>(quad)) {}

  /// m^2, both sides together counted once; see TransformedShape for ellipsoids and what moves.
  float area() const;
  /// A point of the surface; pdf per m^2.
  PositionSample<float> samplePosition(Vec2f u, float time = 0.0f) const;
  /// The density of samplePosition, for a point of the surface.
  float pdfPosition(Vec3f position, float time = 0.0f) const;
  /// A direction to the surface, the distance of the point that is seen there; pdf per sr.
  DirectionSample<float> sampleDirection(Vec3f from, Vec2f u, float time = 0.0f) const;
  float pdfDirection(Vec3f from, Vec3f wi, float time = 0.0f) const;
  /// Unit outward normal at a point of the surface. The outer side seen along wi: dot(normal, wi) < 0.
  Vec3f normalAt(Vec3f position, float time = 0.0f) const;

  const Shape& shape() const { return shape_; }

 private:
  Shape shape_;
};

/// The same shape, moved by an affine, invertible map; normals stay outward, also under mirrors. Quads and triangles
/// stay what they are; spheres, disks and boxes too if the map preserves their kind (to 1e-5); otherwise they become a
/// TransformedShape.
SampledShape transformed(const SampledShape& shape, const Matrix& localToWorld);
/// The same shape under a motion. If it moves already, the motions are composed.
SampledShape inMotion(const SampledShape& shape, const MovingTransform& motion);

}  // namespace steradian
