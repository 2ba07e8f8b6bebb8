#pragma once
/// Parallelogram and its leaf kernel.
#include "steradian/accel/shapes/primitives/shape_hit.h"

namespace STERADIAN_API steradian {

/// The points corner + s u + t v with s, t in [0, 1]; the normal is along u x v ("The Next Week", 6).
template <class F>
struct Quad {
  Vec3<F> corner, u, v;
};

/// How far, in fractions of an edge, a quad reaches beyond its edges: more than the rounding error of the parameters,
/// so that no ray slips between quads that share an edge.
inline constexpr float kQuadRim = 0x1p-20f;

/// Hit with u, v along the edges, edges included; they may leave [0, 1] by kQuadRim. Both sides are hit.
/// After Moeller & Trumbore 1997, "Fast, minimum storage ray/triangle intersection".
template <class F>
ShapeHit<F> intersect(const Quad<F>& quad, const Ray<F>& ray) {
  const Vec3<F> p = cross(ray.direction, quad.v);
  const F scale = F(1.0f) / dot(quad.u, p);  // infinite for parallel rays, which makes u infinite or NaN: no hit
  const Vec3<F> s = ray.origin - quad.corner;
  const Vec3<F> q = cross(s, quad.u);
  const F u = dot(s, p) * scale;
  const F v = dot(ray.direction, q) * scale;
  const F t = dot(quad.v, q) * scale;
  const F low(-kQuadRim), high(1.0f + kQuadRim);
  const MaskOf<F> inside = (u >= low) & (u <= high) & (v >= low) & (v <= high);
  const MaskOf<F> valid = inside & (t > ray.tMin) & (t < ray.tMax);
  return {valid, t, u, v};
}

}  // namespace steradian
