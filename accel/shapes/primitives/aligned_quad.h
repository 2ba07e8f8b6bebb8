#pragma once
/// Rectangle with edges along the axes, such as the walls of a room, and its leaf kernel. Many rays against one
/// rectangle take a third of the instructions of the general quad; one ray against many takes about as many as there.
#include <array>
#include <optional>

#include "steradian/accel/shapes/primitives/quad.h"

namespace STERADIAN_API steradian {

/// A Quad of which u and v have one component each that is not 0, along different axes. (Their reciprocals are finite.)
struct AlignedQuad {
  std::array<int, 3> axis;           ///< of u, of v, of the normal: 0, 1, 2 for x, y, z
  std::array<float, 3> corner;       ///< along these three
  std::array<float, 2> edge;         ///< signed lengths of u and v
  std::array<float, 2> inverseEdge;  ///< 1 / edge

  /// Empty if the quad is not of this form.
  static std::optional<AlignedQuad> of(const Quad<float>& quad);
  Quad<float> quad() const;
};

/// 1 / d of a direction's component, and 1e20 where d is 0: products with it are never NaN, and a plane parallel to the
/// ray, more than some 1e-17 scene units away, is hit beyond any scene.
template <class F>
F reciprocalOfComponent(F d) {
  return F(1.0f) / (d + F(1e-20f));
}

/// The kernel: the distance to the plane first, then the point in the plane (Shirley, "The Next Week", 6.2), by
/// components along the quad's three axes. `inverseEdge` is 1 / edge, `inverse` the reciprocal of the ray's direction
/// along the normal. u, v and the edges as in Quad's kernel; t in multiples of the direction.
template <class F>
ShapeHit<F> crossAlignedQuad(const std::array<F, 3>& corner, const std::array<F, 2>& inverseEdge,
                             const std::array<F, 3>& origin, const std::array<F, 2>& direction, F inverse, F tMin,
                             F tMax) {
  const F t = (corner[2] - origin[2]) * inverse;
  const F u = ((origin[0] - corner[0]) + t * direction[0]) * inverseEdge[0];
  const F v = ((origin[1] - corner[1]) + t * direction[1]) * inverseEdge[1];
  const F lowest = minimum(u, v), highest = maximum(u, v);
  const MaskOf<F> inside = (lowest >= F(-kQuadRim)) & (highest <= F(1.0f + kQuadRim));
  const MaskOf<F> valid = inside & (t > tMin) & (t < tMax);
  return {valid, t, u, v};
}

/// Rays with their components by number, and reciprocals that all aligned quads share.
template <class F>
struct RayByAxis {
  std::array<F, 3> origin, direction, inverse;

  explicit RayByAxis(const Ray<F>& ray)
      : origin{ray.origin.x, ray.origin.y, ray.origin.z},
        direction{ray.direction.x, ray.direction.y, ray.direction.z},
        inverse{reciprocalOfComponent(ray.direction.x), reciprocalOfComponent(ray.direction.y),
                reciprocalOfComponent(ray.direction.z)} {}
};

/// One quad, and any number of rays.
template <class F>
ShapeHit<F> intersect(const AlignedQuad& quad, const RayByAxis<F>& ray, F tMin, F tMax) {
  const auto [u, v, n] = quad.axis;
  const auto along = [](const std::array<F, 3>& components, int axis) {
    return components[static_cast<std::size_t>(axis)];
  };
  return crossAlignedQuad<F>({F(quad.corner[0]), F(quad.corner[1]), F(quad.corner[2])},
                             {F(quad.inverseEdge[0]), F(quad.inverseEdge[1])},
                             {along(ray.origin, u), along(ray.origin, v), along(ray.origin, n)},
                             {along(ray.direction, u), along(ray.direction, v)}, along(ray.inverse, n), tMin, tMax);
}
inline ShapeHit<float> intersect(const AlignedQuad& quad, const Ray<float>& ray) {
  return intersect(quad, RayByAxis<float>(ray), ray.tMin, ray.tMax);
}

}  // namespace steradian
