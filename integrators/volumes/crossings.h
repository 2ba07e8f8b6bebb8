#pragma once
/// How rays go through surfaces that do not stop them.
#include "steradian/core/math/ray.h"
#include "steradian/integrators/volumes/volumes.h"

namespace STERADIAN_API steradian {

/// Follows one ray through the surfaces that it reaches. It passes those that are not real to it (interfaces of media,
/// and surfaces hidden inside of a shape with a higher priority) and stops at the first that is real.
class Crossings {
 public:
  /// A new ray begins.
  void restart() { count_ = 0; }
  /// To be called when the ray reaches the valid point `at`. Returns true if it goes on: then `ray` and `interior` are
  /// those behind the surface.
  bool pass(const Volumes& volumes, const SurfacePoint<float>& at, Ray<float>& ray, InteriorStack& interior);

  // When `pass` has returned false:
  float outsideEta() const { return outsideEta_; }     ///< of the surface that stops the ray: see Boundary
  bool isLost() const { return count_ == kMaxCount; }  ///< the ray is given up, having crossed kMaxCount surfaces
  /// Rays that cross this many surfaces without being scattered are given up.
  static constexpr std::uint32_t kMaxCount = 10000;

 private:
  std::uint32_t count_ = 0;
  float outsideEta_ = 1.0f;
  // Of the last surface passed: what the ray was inside of before it, and the error bound of the point.
  InteriorStack before_;
  Vec3f error_{};
};

}  // namespace steradian
