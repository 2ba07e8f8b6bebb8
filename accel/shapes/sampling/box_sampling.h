#pragma once
/// Sampling of boxes by area and by solid angle: of the faces that are seen.
#include <array>

#include "steradian/accel/shapes/primitives/box.h"
#include "steradian/accel/shapes/sampling/rectangle_directions.h"
#include "steradian/core/sampling/direction_pdf.h"

namespace STERADIAN_API steradian {

/// Surface, m^2.
template <class F>
F area(const Box<F>& box) {
  const Vec3<F> h = box.half;
  return F(8.0f) * (h.x * h.y + h.y * h.z + h.z * h.x);
}
/// The density of samplePosition, per m^2.
template <class F>
F pdfPosition(const Box<F>& box) {
  return F(1.0f) / area(box);
}
/// The unit outward normal of the face that a point of the surface lies on.
template <class F>
Vec3<F> normalAt(const Box<F>& box, Vec3<F> position) {
  const Vec3<F> p = box.axes.toLocal(position - box.center);
  const Vec3<F> out = absolute(p) - box.half;
  const F one(1.0f);
  const MaskOf<F> isX = (out.x >= out.y) & (out.x >= out.z), isY = out.y >= out.z;
  return select(isX, box.axes.x * copySign(one, p.x),
                select(isY, box.axes.y * copySign(one, p.y), box.axes.z * copySign(one, p.z)));
}

namespace detail {

/// (x, y, z) with the third component moved to axis k in {0, 1, 2}, the others following in cyclic order.
template <class F>
Vec3<F> toAxis(UintOf<F> k, Vec3<F> v) {
  const MaskOf<F> isX = k == UintOf<F>(0u), isY = k == UintOf<F>(1u);
  return select(isX, Vec3<F>{v.z, v.x, v.y}, select(isY, Vec3<F>{v.y, v.z, v.x}, v));
}
template <class F>
F component(UintOf<F> k, Vec3<F> v) {
  return select(k == UintOf<F>(0u), v.x, select(k == UintOf<F>(1u), v.y, v.z));
}

}  // namespace detail

/// Uniform by area: a pair of faces by its share, then the side, then the point.
template <class F>
PositionSample<F> samplePosition(const Box<F>& box, Vec2<F> u) {
  const Vec3<F> h = box.half;
  const std::array<F, 3> shares{h.y * h.z, h.z * h.x, h.x * h.y};
  const WeightedChoice<F> chosen = chooseByWeight(u.x, std::span<const F>(shares), shares[0] + shares[1] + shares[2]);
  const F two(2.0f), one(1.0f);
  const MaskOf<F> upper = chosen.rest >= F(0.5f);
  const F side = select(upper, one, -one);
  const F s = two * chosen.rest - select(upper, one, F(0.0f));
  const Vec3<F> local = detail::toAxis(chosen.index, Vec3<F>{two * s - one, two * u.y - one, side});
  const Vec3<F> normal = detail::toAxis(chosen.index, Vec3<F>{F(0.0f), F(0.0f), side});
  return {box.center + box.axes.toWorld(local * h), box.axes.toWorld(normal), pdfPosition(box)};
}

namespace detail {

/// The box from the viewer's place in its own axes, mirrored into the first octant: the faces that may be seen are +x,
/// +y and +z.
template <class F>
struct BoxView {
  Vec3<F> viewer, side;  ///< |coordinates|, and their signs
  Vec3<F> half;
  std::array<F, 3> solidAngles;  ///< sr; 0 for a face that is not seen
  F total;                       ///< the same of the whole box
  MaskOf<F> outside;

  BoxView(const Box<F>& box, Vec3<F> from) : half(box.half) {
    const Vec3<F> p = box.axes.toLocal(from - box.center);
    const F one(1.0f);
    viewer = absolute(p);
    side = {copySign(one, p.x), copySign(one, p.y), copySign(one, p.z)};
    const SeenRectangle<F> x = face(UintOf<F>(0u)), y = face(UintOf<F>(1u)), z = face(UintOf<F>(2u));
    if constexpr (widthOf<F> == 1) {
      // The faces side by side: each lane rounds as the scalar would.
      const auto lanes = [](float a, float b, float c) {
        Lanes<4> l(a);
        l.set(1, b);
        l.set(2, c);
        return l;
      };
      const Lanes<4> s =
          seen(SeenRectangle<Lanes<4>>{lanes(x.x0, y.x0, z.x0), lanes(x.x1, y.x1, z.x1), lanes(x.y0, y.y0, z.y0),
                                       lanes(x.y1, y.y1, z.y1), lanes(x.z, y.z, z.z)});
      solidAngles = {s[0], s[1], s[2]};
    } else {
      solidAngles = {seen(x), seen(y), seen(z)};
    }
    total = solidAngles[0] + solidAngles[1] + solidAngles[2];
    outside = maxComponent(viewer - half) > F(0.0f);
  }

  /// The + face of axis k; z <= 0 where it is not seen.
  SeenRectangle<F> face(UintOf<F> k) const {
    const Vec3<F> low = -half - viewer, high = half - viewer;
    const UintOf<F> i = next(k), j = next(i);
    return {component(i, low), component(i, high), component(j, low), component(j, high), -component(k, high)};
  }
  static UintOf<F> next(UintOf<F> k) { return select(k == UintOf<F>(2u), UintOf<F>(0u), k + UintOf<F>(1u)); }

  template <class G>
  static G seen(const SeenRectangle<G>& r) {
    return select(r.z > G(0.0f), solidAngleOf(r), G(0.0f));
  }
  /// The probability of face k.
  F share(UintOf<F> k) const {
    const F mine =
        select(k == UintOf<F>(0u), solidAngles[0], select(k == UintOf<F>(1u), solidAngles[1], solidAngles[2]));
    return select(mine > F(0.0f), mine / total, F(0.0f));
  }
};

}  // namespace detail

/// A direction from `from` to the box. From outside: one of the one to three faces that are seen, with probability in
/// proportion to its solid angle, then as for a rectangle; where all are large, the density is 1 / (solid angle of the
/// box). On the surface or inside: uniform over the directions that hit a face, 1 / 4 pi.
template <class F>
DirectionSample<F> sampleDirection(const Box<F>& box, Vec3<F> from, Vec2<F> u) {
  const detail::BoxView<F> view(box, from);
  const WeightedChoice<F> chosen = chooseByWeight(u.x, std::span<const F>(view.solidAngles), view.total);
  const UintOf<F> k = chosen.index;
  const F share = view.share(k);
  const SeenRectangle<F> face = view.face(k);
  const RectangleDirections<F> directions(face, MaskOf<F>(true));
  const Vec2<F> p = directions.sample({chosen.rest, u.y});
  const Vec3<F> local = detail::toAxis(k, Vec3<F>{p.x, p.y, -face.z}) * view.side;
  const F distance = length(local);
  const Vec3<F> wi = box.axes.toWorld(local * (F(1.0f) / distance));
  const F pdf = share * directions.pdf(distance);
  const MaskOf<F> outside = view.outside;
  const MaskOf<F> seen = outside & (share > F(0.0f));
  if (all(outside)) return sampleIf(seen, wi, pdf, distance);

  const Vec3<F> wiInside = UniformSphere<F>::sample(u);
  const ShapeHit<F> hit = intersect(box, Ray<F>{from, wiInside});
  return sampleIf(seen | ((!outside) & hit.valid), select(outside, wi, wiInside), select(outside, pdf, F(kInvFourPi)),
                  select(outside, distance, hit.t));
}

/// Inverse of sampleDirection: the random numbers that give wi; meaningless where the line misses the box by more than
/// rounding.
template <class F>
Vec2<F> invertDirection(const Box<F>& box, Vec3<F> from, Vec3<F> wi) {
  const ShapeHit<F> hit = intersect(box, Ray<F>{from, wi});
  const detail::BoxView<F> view(box, from);
  // Defined also where rounding makes the ray miss at an edge: the slab that was entered last.
  const UintOf<F> k = toUnsigned(toInt(hit.u)) >> 1;
  // The face that is hit, in the view's octant and with its axis as z.
  const Vec3<F> local = box.axes.toLocal(wi) * view.side;
  const SeenRectangle<F> face = view.face(k);
  const F t = -face.z / detail::component(k, local);
  const UintOf<F> i = detail::BoxView<F>::next(k), j = detail::BoxView<F>::next(i);
  const RectangleDirections<F> directions(face, MaskOf<F>(true));
  const Vec2<F> u = directions.invert({t * detail::component(i, local), t * detail::component(j, local)});
  // Before face k come those of smaller index.
  const F zero(0.0f);
  const F before = select(k == UintOf<F>(0u), zero, view.share(UintOf<F>(0u))) +
                   select(k == UintOf<F>(2u), view.share(UintOf<F>(1u)), zero);
  const Vec2<F> outside{minimum(before + view.share(k) * u.x, F(kOneMinusEpsilon)), u.y};
  return select(view.outside, outside, UniformSphere<F>::invert(wi));
}

/// The density of sampleDirection: 0 where the line misses the box. A line from outside enters by exactly one of the
/// faces seen.
template <class F>
F pdfDirection(const Box<F>& box, Vec3<F> from, Vec3<F> wi) {
  const ShapeHit<F> hit = intersect(box, Ray<F>{from, wi});
  if (!any(hit.valid)) return F(0.0f);
  const detail::BoxView<F> view(box, from);
  const UintOf<F> k = toUnsigned(toInt(hit.u)) >> 1;
  const RectangleDirections<F> directions(view.face(k), MaskOf<F>(true));
  return densityIf(hit.valid, select(view.outside, view.share(k) * directions.pdf(hit.t), F(kInvFourPi)));
}

}  // namespace steradian
