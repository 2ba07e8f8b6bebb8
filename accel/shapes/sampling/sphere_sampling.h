#pragma once
/// Sampling of spheres by area and by solid angle.
#include "steradian/accel/shapes/primitives/sphere.h"
#include "steradian/accel/shapes/sampling/direction_sample.h"
#include "steradian/core/math/frame.h"
#include "steradian/core/sampling/warp.h"

namespace STERADIAN_API steradian {

/// Surface, m^2.
template <class F>
F area(const Sphere<F>& sphere) {
  return F(kFourPi) * sphere.radius * sphere.radius;
}
/// Uniform by area; pdf per m^2.
template <class F>
PositionSample<F> samplePosition(const Sphere<F>& sphere, Vec2<F> u) {
  const Vec3<F> normal = UniformSphere<F>::sample(u);
  return {sphere.center + normal * sphere.radius, normal, F(1.0f) / area(sphere)};
}
/// The density of samplePosition, per m^2.
template <class F>
F pdfPosition(const Sphere<F>& sphere) {
  return F(1.0f) / area(sphere);
}
/// The unit outward normal at a point of the surface.
template <class F>
Vec3<F> normalAt(const Sphere<F>& sphere, Vec3<F> position) {
  return normalize(position - sphere.center);
}

namespace detail {

/// The cone that a sphere fills, seen from outside.
template <class F>
struct SphereView {
  Vec3<F> toCenter;
  F distance;  ///< of the centre
  MaskOf<F> outside;
  F sinSquaredMax;  ///< of the cone's half angle
  UniformCone<F> cone;

  SphereView(const Sphere<F>& sphere, Vec3<F> from)
      : toCenter(sphere.center - from),
        distance(length(toCenter)),
        outside(distance > sphere.radius),
        sinSquaredMax(sqr(sphere.radius / distance)),
        // 1 - cos without cancellation; cos^2 = (d - r)(d + r) / d^2 keeps its digits close to the surface.
        cone{sinSquaredMax / (F(1.0f) + safeSqrt((distance - sphere.radius) * (distance + sphere.radius)) / distance)} {
  }

  Frame<F> axes() const { return Frame<F>::fromZ(select(outside, toCenter / distance, up())); }
  static Vec3<F> up() { return {F(0.0f), F(0.0f), F(1.0f)}; }
};

}  // namespace detail

/// A direction from `from` to the sphere, with the distance of its near surface. From outside: uniform in the cone that
/// the sphere fills; 1 - cos is accurate from spheres that touch the point down to cones of 1e-18 rad, far narrower
/// than float directions resolve (those are in a cone of 1e-4 rad to 0.1 %). On the surface or inside: uniform over all
/// directions, 1 / 4 pi, which is finite everywhere where area sampling is not. Lanes that are not active may have any
/// sample.
template <class F>
DirectionSample<F> sampleDirection(const Sphere<F>& sphere, Vec3<F> from, Vec2<F> u,
                                   MaskOf<F> active = MaskOf<F>(true)) {
  const detail::SphereView<F> view(sphere, from);
  const F d = view.distance, r = sphere.radius;
  const Vec3<F> local = view.cone.sample(u);
  // The near root as product of the roots over the far one: (d - r)(d + r) does not cancel; the discriminant is not
  // negative in the cone.
  const F halfChord = safeSqrt(r * r - d * d * (local.x * local.x + local.y * local.y));
  const F nearDistance = (d - r) * (d + r) / (d * local.z + halfChord);
  const Vec3<F> wiOutside = view.axes().toWorld(local);
  const MaskOf<F> outside = view.outside;
  if (all(outside | !active)) return sampleIf(outside, wiOutside, view.cone.pdfInside(), nearDistance);

  const Vec3<F> wiInside = UniformSphere<F>::sample(u);
  const ShapeHit<F> hit = intersect(sphere, Ray<F>{from, wiInside});
  return sampleIf(outside | hit.valid, select(outside, wiOutside, wiInside),
                  select(outside, view.cone.pdfInside(), F(kInvFourPi)), select(outside, nearDistance, hit.t));
}

/// The density of sampleDirection: 0 outside of the cone. Undefined in lanes that are not active.
template <class F>
F pdfDirection(const Sphere<F>& sphere, Vec3<F> from, Vec3<F> wi, MaskOf<F> active = MaskOf<F>(true)) {
  const detail::SphereView<F> view(sphere, from);
  const F outside = view.cone.pdf(view.axes().toLocal(wi));
  if (all(view.outside | !active)) return densityIf(view.outside, outside);
  const MaskOf<F> hit = intersect(sphere, Ray<F>{from, wi}).valid;
  return densityIf(view.outside | hit, select(view.outside, outside, F(kInvFourPi)));
}

/// Inverse of sampleDirection: the random numbers that give wi; the nearest ones for a direction that misses.
template <class F>
Vec2<F> invertDirection(const Sphere<F>& sphere, Vec3<F> from, Vec3<F> wi) {
  const detail::SphereView<F> view(sphere, from);
  return select(view.outside, view.cone.invert(view.axes().toLocal(wi)), UniformSphere<F>::invert(wi));
}

}  // namespace steradian
