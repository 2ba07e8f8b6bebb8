#pragma once
/// Rays through surfaces that do not stop them.
#include "steradian/core/math/ray.h"
#include "steradian/integrators/volumes/volumes.h"

namespace STERADIAN_API steradian {

/// What becomes of one ray at the surfaces that it reaches: it passes those that are not real to it (interfaces of
/// media, and surfaces hidden inside of a shape with a higher priority) and stops at the first that is.
class Crossings {
 public:
  /// A new ray begins.
  void restart() { count_ = 0; }
  /// The ray reaches the valid point `at`. True if it goes on: then `ray` and `interior` are those behind the surface.
  bool pass(const Volumes& volumes, const SurfacePoint<float>& at, Ray<float>& ray, InteriorStack& interior);

  /// Once `pass` has returned false:
  float outsideEta() const { return outsideEta_; }     ///< see Boundary: of the surface that stops the ray
  bool isLost() const { return count_ == kMaxCount; }  ///< given up, having crossed that many
  /// A ray that crosses this many surfaces without being scattered is given up.
  static constexpr std::uint32_t kMaxCount = 10000;

 private:
  std::uint32_t count_ = 0;
  float outsideEta_ = 1.0f;
  // At the last surface passed:
  InteriorStack before_;
  Vec3f error_{};
};

}  // namespace steradian
