#pragma once
/// A shape under an affine map that leaves it no shape of its kind, or under one that changes with time. Width 1.
#include <variant>
#include <vector>

#include "steradian/accel/shapes/primitives/box.h"
#include "steradian/accel/shapes/primitives/disk.h"
#include "steradian/accel/shapes/primitives/sphere.h"
#include "steradian/accel/shapes/primitives/triangle.h"
#include "steradian/accel/shapes/sampling/quad_sampling.h"
#include "steradian/core/math/motion.h"
#include "steradian/core/transport/scattering.h"

namespace STERADIAN_API steradian {

/// An affine map M preserves lines and visibility along them, so directions are sampled in the shape's own space, where
/// the visible side has a solid angle in closed form, and are mapped by its linear part. A cone of directions about w
/// grows by |det M| / |M w|^3, so the density per sr is p |M w|^3 / |det M|; by area, it is the local one over the
/// stretch |det M| |M^-T n|. For a shape that moves, M is that of the given time; for others the time does not matter.
class TransformedShape {
 public:
  using Local = std::variant<Sphere<float>, Disk<float>, Box<float>, PreparedQuad<float>, Triangle<float>>;

  /// `localToWorld` is affine and invertible.
  TransformedShape(const Local& local, const Matrix& localToWorld);
  /// Moved by the first of the motions, then by the next.
  TransformedShape(const Local& local, std::vector<MovingTransform> motions);

  /// Exact, except for ellipsoids: by quadrature, with errors of 1e-4 for axes up to 10 : 1 and 2 % at 1000 : 1. Of a
  /// shape that moves, the area at time 1/2.
  float area() const { return area_; }
  /// Uniform by area of the local shape: not uniform where the stretch varies.
  PositionSample<float> samplePosition(Vec2f u, float time = 0.0f) const;
  float pdfPosition(Vec3f position, float time = 0.0f) const;
  DirectionSample<float> sampleDirection(Vec3f from, Vec2f u, float time = 0.0f) const;
  float pdfDirection(Vec3f from, Vec3f wi, float time = 0.0f) const;
  Vec3f normalAt(Vec3f position, float time = 0.0f) const;

  const Local& local() const { return local_; }
  const Matrix& localToWorld() const { return still_.matrix; }
  /// None: it does not move.
  const std::vector<MovingTransform>& motions() const { return motions_; }

 private:
  struct Place {
    Matrix matrix, inverse;
    float determinant;  ///< |det| of the linear part

    explicit Place(const Matrix& localToWorld);
    float stretch(Vec3f localNormal) const;
  };
  Place placeAt(float time) const;
  float areaIn(const Place& place) const;

  Local local_;
  std::vector<MovingTransform> motions_;
  Place still_;  // at time 1/2, if it moves
  float area_;
};

}  // namespace steradian
