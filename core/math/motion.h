#pragma once
/// Transforms that change while the shutter is open, at any time of it.
#include "steradian/core/math/transform.h"

namespace STERADIAN_API steradian {

/// Local to world, at time 0 and at time 1: affine, invertible, and both mirrors or neither. Between the two,
/// translation, rotation and stretch are interpolated each for itself.
struct Motion {
  Matrix open, close;
};

/// A Motion, decomposed once: p' = p S(t) R(t) + T(t), with a symmetric stretch S, a rotation R and a translation T
/// (polar decomposition: Shoemake & Duff 1992, "Matrix animation and polar decomposition"). S and T change linearly, R
/// rotates the shorter way at constant speed (Shoemake 1985, "Animating rotation with quaternion curves").
///
/// `at` gives the same bits on every machine. Inverses are taken of the rounded matrix (affineInverse), so that
/// rounding errors are bounded as for static transforms.
class MovingTransform {
 public:
  /// The keys must be as Motion says (validate() checks it).
  explicit MovingTransform(const Motion& motion);

  /// Local to world at `time` in [0, 1]. Where both keys are the same, exactly that.
  Matrix at(float time) const;

  /// World bounds, at all times, of everything inside `local` (local space); rounding of `at` included.
  Bounds3 bounds(const Bounds3& local) const;

  /// No coordinate, in local space and at any time, of a point whose coordinates in the world are at most `magnitude`,
  /// is larger than this.
  float localMagnitude(float magnitude) const;

 private:
  /// The upper triangle of a symmetric matrix.
  struct Symmetric {
    float xx, yy, zz, xy, xz, yz;
  };
  struct Quaternion {
    float w, x, y, z;
  };
  float largestTranslation() const { return maximum(length(translation_), length(translation_ + shift_)); }

  Matrix open_;
  bool still_;
  Vec3f translation_, shift_;      // T at time 0, and what it changes by
  Symmetric stretch_, growth_;     // S likewise
  Quaternion rotation_, towards_;  // R at time 0, and the unit quaternion at a right angle to it on the way
  float angle_;                    // between the quaternions at time 0 and 1: half of what is turned by, radians
  float stretchNorm_, growthNorm_, shrinkNorm_;  // bounds of the norms of S, of its change, and of its inverse
};

/// Whether two affine transforms can be the keys of a motion: both mirrors, or neither.
bool sameHandedness(const Matrix& open, const Matrix& close);

}  // namespace steradian
