#pragma once
/// What is between the surfaces of a scene: media, and the closed shapes that they fill.
#include <array>
#include <cstdint>
#include <vector>

#include "steradian/core/scene/description.h"
#include "steradian/materials/medium_set.h"

namespace steradian {

/// The closed shapes that a point of a ray is inside of, in the order in which the ray entered them.
class Bodies {
 public:
  struct Body {
    Id shape, primitive, instance;  ///< primitive: 0 for meshes, whose triangles bound one body together
    Id medium;
    int priority;
    float eta;  ///< refractive index; 1 for bodies without a priority

    bool isSame(const Body& other) const {
      return shape == other.shape && primitive == other.primitive && instance == other.instance;
    }
  };
  /// So many can be told apart; those entered while there are as many are not noticed.
  static constexpr std::uint32_t kMost = 64;

  Bodies() = default;
  Bodies(const Bodies& other) { *this = other; }
  /// Copies those that there are: mostly one or two.
  Bodies& operator=(const Bodies& other) {
    count_ = other.count_;
    for (std::uint32_t i = 0; i < count_; ++i) bodies_[i] = other.bodies_[i];
    return *this;
  }

  void enter(const Body& body);
  void leave(const Body& body);
  bool contains(const Body& body) const { return find(body) < count_; }
  /// The one that counts: of the highest priority the one entered last; null outside of all. `other` is left out.
  const Body* top(const Body* other = nullptr) const;
  bool empty() const { return count_ == 0; }

 private:
  std::uint32_t find(const Body& body) const;

  std::array<Body, kMost> bodies_;  ///< the first count_ are there, others are not even initialised
  std::uint32_t count_ = 0;
};

/// What a surface is to a ray that meets it.
struct Boundary {
  bool isReal = true;       ///< false: the ray passes as if there were nothing
  float outsideEta = 1.0f;  ///< refractive index that a dielectric's own is relative to
};

class Volumes {
 public:
  /// The description must be valid.
  explicit Volumes(const SceneDescription& scene);

  /// Rays go through vacuum from surface to surface, and every surface is real.
  bool empty() const { return !needed_; }
  /// Some surfaces are not real for some rays.
  bool passable() const { return passable_; }

  const MediumSet& media() const { return media_; }
  /// The number of the medium that a ray inside of `bodies` is in; media().none(): in vacuum.
  std::uint32_t mediumIn(const Bodies& bodies) const;
  /// The surface at `at`, which a ray of this direction meets from inside of `bodies`.
  Boundary boundary(const SurfacePoint<float>& at, Vec3f direction, const Bodies& bodies) const;
  /// The ray goes through the surface.
  void cross(const SurfacePoint<float>& at, Vec3f direction, Bodies& bodies) const;
  /// A path that came along -wo leaves the surface along wi: through it, or back.
  void scatter(const SurfacePoint<float>& at, Vec3f wo, Vec3f wi, Bodies& bodies) const {
    if (dot(wi, at.geometricNormal) * dot(wo, at.geometricNormal) < 0.0f) cross(at, wi, bodies);
  }
  /// Whether two points are on the surface of one body.
  bool isSameBody(const SurfacePoint<float>& a, const SurfacePoint<float>& b) const {
    return bodyOf(a).isSame(bodyOf(b));
  }
  /// Shapes that have an interior.
  bool isClosed(Id shape) const { return shape < closed_.size() && closed_[shape].isClosed; }
  /// Shapes that are more than a wall to a ray: those with an interior, and those that may not be real to it.
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
  Bodies::Body bodyOf(const SurfacePoint<float>& at) const;

  MediumSet media_;
  Id outside_;
  std::vector<Closed> closed_;               ///< per shape
  std::vector<std::uint32_t> moreThanWall_;  ///< per shape, and of none
  std::vector<Material> materials_;          ///< per material
  bool needed_ = false, passable_ = false;
};

}  // namespace steradian
