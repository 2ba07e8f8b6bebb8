#pragma once
/// A sphere, disk or box under an affine map that leaves it no sphere, disk or box. Width 1.
#include <variant>

#include "steradian/accel/shapes/box.h"
#include "steradian/accel/shapes/disk.h"
#include "steradian/accel/shapes/sphere.h"
#include "steradian/core/scattering.h"
#include "steradian/core/transform.h"

namespace steradian {

/// An affine map M keeps lines and what is seen along them, so directions are sampled in the shape's own space, where
/// the visible side has a solid angle in closed form, and are mapped by its linear part. A cone of directions about w
/// grows by |det M| / |M w|^3, so the density per sr is p |M w|^3 / |det M|; by area, it is the local one over the
/// stretch |det M| |M^-T n|.
class TransformedShape {
 public:
  using Local = std::variant<Sphere<float>, Disk<float>, Box<float>>;

  /// `localToWorld` is affine and invertible.
  TransformedShape(const Local& local, const Matrix& localToWorld);

  /// Exact for disks and boxes; for ellipsoids by quadrature (1e-4 for axes up to 10 : 1, 2 % at 1000 : 1).
  float area() const { return area_; }
  /// Uniform by area of the local shape: not uniform where the stretch varies.
  PositionSample<float> samplePosition(Vec2f u) const;
  float pdfPosition(Vec3f position) const;
  DirectionSample<float> sampleDirection(Vec3f from, Vec2f u) const;
  float pdfDirection(Vec3f from, Vec3f wi) const;
  Vec3f normalAt(Vec3f position) const;

  const Local& local() const { return local_; }
  const Matrix& localToWorld() const { return matrix_; }

 private:
  float stretch(Vec3f localNormal) const;

  Local local_;
  Matrix matrix_, inverse_;
  float determinant_;  ///< |det| of the linear part
  float area_;
};

}  // namespace steradian
