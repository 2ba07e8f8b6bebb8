#pragma once
/// Sampling of parallelograms by area and by solid angle, from either side.
#include <concepts>

#include "steradian/accel/shapes/primitives/quad.h"
#include "steradian/accel/shapes/sampling/rectangle_directions.h"
#include "steradian/core/math/frame.h"

namespace STERADIAN_API steradian {

/// Surface, m^2 (one side).
template <class F>
F area(const Quad<F>& quad) {
  return length(cross(quad.u, quad.v));
}

/// Uniform by area; the normal along u x v. A degenerate quad gives no sample.
template <class F>
PositionSample<F> samplePosition(const Quad<F>& quad, Vec2<F> u) {
  const Vec3<F> normal = cross(quad.u, quad.v);
  const F size = length(normal);
  const MaskOf<F> valid = size > F(0.0f);
  return {quad.corner + quad.u * u.x + quad.v * u.y, normal * select(valid, F(1.0f) / size, F(0.0f)),
          select(valid, F(1.0f) / size, F(0.0f))};
}
/// The density of samplePosition, per m^2.
template <class F>
F pdfPosition(const Quad<F>& quad) {
  const F size = area(quad);
  return select(size > F(0.0f), F(1.0f) / size, F(0.0f));
}
/// The unit normal, along u x v; the quad must not be degenerate.
template <class F>
Vec3<F> normalAt(const Quad<F>& quad, Vec3<F>) {
  return normalize(cross(quad.u, quad.v));
}

/// A quad with what its samplers need and what does not depend on the viewer: the frame with x along u and z along the
/// normal, where u = (width, 0) and v = (shear, height).
template <class F>
struct PreparedQuad : Quad<F> {
  Frame<F> axes;
  F width, height, shear;

  explicit PreparedQuad(const Quad<F>& quad)
      : Quad<F>(quad),
        axes(axesOf(quad.u, cross(quad.u, quad.v))),
        width(length(quad.u)),
        height(dot(quad.v, axes.y)),
        shear(dot(quad.v, axes.x)) {}
  /// The same quad in every lane.
  template <std::same_as<float> Scalar>
  requires(widthOf<F> > 1) explicit PreparedQuad(const PreparedQuad<Scalar>& q)
      : Quad<F>{broadcast<F>(q.corner), broadcast<F>(q.u), broadcast<F>(q.v)},
        axes{broadcast<F>(q.axes.x), broadcast<F>(q.axes.y), broadcast<F>(q.axes.z)},
        width(q.width),
        height(q.height),
        shear(q.shear) {}

 private:
  static Frame<F> axesOf(Vec3<F> u, Vec3<F> normal) {
    const F tiny(1e-30f);
    const Vec3<F> x = u * (F(1.0f) / maximum(length(u), tiny)), n = normal * (F(1.0f) / maximum(length(normal), tiny));
    // In a sliver of nearly parallel edges the product is not perpendicular to them.
    const Vec3<F> perpendicular = n - x * dot(n, x);
    const Vec3<F> z = perpendicular * (F(1.0f) / maximum(length(perpendicular), tiny));
    return {x, cross(z, x), z};
  }
};

/// The same quad in every lane (as in_lanes.h does for other shapes).
template <class F>
PreparedQuad<F> inLanes(const PreparedQuad<float>& q) {
  return PreparedQuad<F>(q);
}

namespace detail {

/// The quad as seen from a point.
template <class F>
struct QuadView {
  const PreparedQuad<F>& quad;
  Vec3<F> corner;  ///< in the quad's frame, relative to the viewer
  MaskOf<F> valid;
  RectangleDirections<F> directions;

  QuadView(const PreparedQuad<F>& seen, Vec3<F> from)
      : quad(seen),
        corner(seen.axes.toLocal(seen.corner - from)),
        valid((seen.width > F(0.0f)) & (seen.height > F(0.0f)) & (corner.z != F(0.0f))),
        // Right angles to within 1e-5: wider than the rounding of rotated rectangles, narrow enough to pass for a
        // rectangle.
        directions({corner.x, corner.x + seen.width, corner.y, corner.y + seen.height, absolute(corner.z)},
                   MaskOf<F>(valid & (absolute(seen.shear) <= F(1e-5f) * seen.height))) {}
};

}  // namespace detail

/// A direction from `from` to the quad. Rectangles of more than kUniformRectangleMin sr: uniform in solid angle;
/// smaller ones and those without right angles: uniform by area. A point in the quad's plane gets no sample.
template <class F>
DirectionSample<F> sampleDirection(const PreparedQuad<F>& quad, Vec3<F> from, Vec2<F> u) {
  const detail::QuadView<F> view(quad, from);
  Vec2<F> p = view.directions.sample(u);
  // Sampled by area, the quad may be sheared; in solid angle it is a rectangle.
  p.x = select(view.directions.uniform(), p.x, p.x + quad.shear * u.y);
  const Vec3<F> local{p.x, p.y, view.corner.z};
  const F distance = length(local);
  return sampleIf(view.valid, quad.axes.toWorld(local * (F(1.0f) / distance)), view.directions.pdf(distance), distance);
}

/// The density of sampleDirection: 0 where the line misses the quad.
template <class F>
F pdfDirection(const PreparedQuad<F>& quad, Vec3<F> from, Vec3<F> wi) {
  const ShapeHit<F> hit = intersect(static_cast<const Quad<F>&>(quad), Ray<F>{from, wi});
  if (!any(hit.valid)) return F(0.0f);
  const detail::QuadView<F> view(quad, from);
  return densityIf(hit.valid & view.valid, view.directions.pdf(hit.t));
}

/// Inverse of sampleDirection: the random numbers that give wi; the nearest ones where the line misses the quad.
template <class F>
Vec2<F> invertDirection(const PreparedQuad<F>& quad, Vec3<F> from, Vec3<F> wi) {
  const detail::QuadView<F> view(quad, from);
  const Vec3<F> local = quad.axes.toLocal(wi);
  const F t = view.corner.z / local.z;
  Vec2<F> p{t * local.x, t * local.y};
  // Sampled by area: undo the shear.
  const F skew = quad.shear * ((p.y - view.corner.y) / quad.height);
  p.x = select(view.directions.uniform(), p.x, p.x - skew);
  return view.directions.invert(p);
}

/// The same for a quad that is sampled once.
template <class F>
DirectionSample<F> sampleDirection(const Quad<F>& quad, Vec3<F> from, Vec2<F> u) {
  return sampleDirection(PreparedQuad<F>(quad), from, u);
}
template <class F>
F pdfDirection(const Quad<F>& quad, Vec3<F> from, Vec3<F> wi) {
  return pdfDirection(PreparedQuad<F>(quad), from, wi);
}
template <class F>
Vec2<F> invertDirection(const Quad<F>& quad, Vec3<F> from, Vec3<F> wi) {
  return invertDirection(PreparedQuad<F>(quad), from, wi);
}

}  // namespace steradian
