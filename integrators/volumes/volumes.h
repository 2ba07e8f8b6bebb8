#pragma once
/// What is between the surfaces of a scene: media, and the closed shapes that they fill.
#include <cstdint>
#include <vector>

#include "steradian/core/scene/description.h"
#include "steradian/integrators/volumes/interior_stack.h"
#include "steradian/materials/medium_set.h"

namespace STERADIAN_API steradian {

/// What a surface is to a ray that reaches it.
struct Boundary {
  bool isReal = true;       ///< false: the ray goes through as if the surface were not there
  float outsideEta = 1.0f;  ///< refractive index on the outer side of a dielectric, which its own is relative to
};

class Volumes {
 public:
  /// The description must be valid.
  explicit Volumes(const SceneDescription& scene);

  /// Whether there is nothing to do: rays go through vacuum from surface to surface, and every surface is real.
  bool empty() const { return !needed_; }
  /// Whether some surfaces are not real to some rays.
  bool passable() const { return passable_; }

  const MediumSet& media() const { return media_; }
  /// The number of the medium that a ray inside of `interior` is in; media().none(): in vacuum.
  std::uint32_t mediumIn(const InteriorStack& interior) const;
  /// What the surface at `at` is to a ray of this direction that comes to it inside of the shapes `interior`.
  Boundary boundary(const SurfacePoint<float>& at, Vec3f direction, const InteriorStack& interior) const;
  /// Brings `interior` up to date for a ray that goes through the surface.
  void cross(const SurfacePoint<float>& at, Vec3f direction, InteriorStack& interior) const;
  /// Brings `interior` up to date for a path that came along -wo and leaves the surface along wi: on its other side, or
  /// on the same.
  void scatter(const SurfacePoint<float>& at, Vec3f wo, Vec3f wi, InteriorStack& interior) const {
    if (dot(wi, at.geometricNormal) * dot(wo, at.geometricNormal) < 0.0f) cross(at, wi, interior);
  }
  /// Whether two points are on the surface of one closed shape.
  bool isSameInterior(const SurfacePoint<float>& a, const SurfacePoint<float>& b) const {
    return entryOf(a).isSame(entryOf(b));
  }
  /// Whether a shape has an interior.
  bool isClosed(Id shape) const { return shape < closed_.size() && closed_[shape].isClosed; }
  /// Whether shapes are more than a wall to a ray: those that have an interior, and those that may not be real to it.
  template <class F>
  MaskOf<F> isMoreThanWall(UintOf<F> shape) const {
    return gather(moreThanWall_.data(), shape) != UintOf<F>(0u);
  }

 private:
  struct Closed {
    bool isClosed = false, byPrimitive = true;
    Interior interior;
  };
  struct Material {
    bool isInterface = false;
    float eta = 1.0f;
  };
  InteriorStack::Entry entryOf(const SurfacePoint<float>& at) const;

  MediumSet media_;
  Id outside_;
  std::vector<Closed> closed_;               ///< per shape
  std::vector<std::uint32_t> moreThanWall_;  ///< per shape; 0 for none, which comes last
  std::vector<Material> materials_;          ///< per material
  bool needed_ = false, passable_ = false;
};

}  // namespace steradian
