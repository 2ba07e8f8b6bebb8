#pragma once
/// Directions towards a rectangle: uniform in solid angle where it is large, by area where it is small.
#include "steradian/accel/shapes/sampling/direction_sample.h"

namespace STERADIAN_API steradian {

/// The rectangle [x0, x1] x [y0, y1] in the plane at distance z >= 0, seen from the origin.
template <class F>
struct SeenRectangle {
  F x0, x1, y0, y1, z;

  F area() const { return (x1 - x0) * (y1 - y0); }
  /// The solid angle is at most this, by the distance of the nearest point. 0 in the plane of the rectangle.
  F solidAngleBound() const {
    const F zero(0.0f);
    const F dx = maximum(maximum(x0, -x1), zero), dy = maximum(maximum(y0, -y1), zero);
    const F nearest = squareRoot(dx * dx + dy * dy + z * z);
    return select(z > zero, minimum(area() / (nearest * nearest) * (z / nearest), F(kTwoPi)), zero);
  }
};

/// Below this solid angle (sr) a rectangle is sampled by area. Measured (Zen 3): a sample takes 180 ns in place of 63,
/// its pdf 88 in place of 35 (width 1; per lane of eight: 33 and 12, 19 and 10). In return, the variance of the
/// unoccluded irradiance falls 16-fold where the receiver is parallel to the rectangle and 1.1- to 2.5-fold where it
/// stands at 45 degrees. The standard deviation by area that is saved so: 130 x 105 from 500 (0.05 sr) 1 to 10 %, less
/// than what shadows and other light leave; 400 x 400 from 500 (0.5 sr) 12 to 28 %; a unit square from 1 (0.1 to 0.8
/// sr) 17 to 46 %.
inline constexpr float kUniformRectangleMin = 0.1f;

namespace detail {

/// Solid angle between the axes and (x, y), with the sign of x y: atan(x y / (z r)), r the distance of (x, y, z).
template <class F>
F cornerAngle(F x, F y, F z) {
  return arcTan2(x * y, z * squareRoot(x * x + y * y + z * z));
}

/// The solid angle by its four corners (absolute error below 2e-6), and a part of it that sampling needs.
template <class F>
struct CornerSum {
  F total;
  F left;  ///< cornerAngle(x0, y1) - cornerAngle(x0, y0)
};
template <class F>
CornerSum<F> sumCorners(const SeenRectangle<F>& r) {
  F left, right;
  if constexpr (widthOf<F> == 1) {
    // The corners side by side: each lane rounds as the scalar would.
    Lanes<4> x(r.x0), y(r.y0);
    x.set(2, r.x1);
    x.set(3, r.x1);
    y.set(1, r.y1);
    y.set(3, r.y1);
    const Lanes<4> angles = cornerAngle(x, y, Lanes<4>(r.z));
    left = angles[1] - angles[0];
    right = angles[3] - angles[2];
  } else {
    left = cornerAngle(r.x0, r.y1, r.z) - cornerAngle(r.x0, r.y0, r.z);
    right = cornerAngle(r.x1, r.y1, r.z) - cornerAngle(r.x1, r.y0, r.z);
  }
  return {maximum(right - left, F(0.0f)), left};
}

/// Solid angle by two triangles, each of which has tan(half its solid angle) = V / D: V is the triple product of the
/// unit vectors to its vertices, D is 1 + the sum of their dot products (van Oosterom & Strackee 1983). V is z times
/// edges over distances and does not cancel, however small or far the rectangle; the half angles are summed as complex
/// numbers.
template <class F>
F solidAngleByTriangles(const SeenRectangle<F>& r) {
  const F z2 = r.z * r.z, one(1.0f);
  const F x00 = r.x0 * r.x0, x11 = r.x1 * r.x1, x01 = r.x0 * r.x1;
  const F y00 = r.y0 * r.y0, y11 = r.y1 * r.y1, y01 = r.y0 * r.y1;
  const auto inverseDistance = [&](F xx, F yy) { return one / maximum(squareRoot(xx + yy + z2), F(1e-30f)); };
  const F i00 = inverseDistance(x00, y00), i10 = inverseDistance(x11, y00);
  const F i11 = inverseDistance(x11, y11), i01 = inverseDistance(x00, y11);
  const F diagonal = (x01 + y01 + z2) * i00 * i11;
  const F d1 = one + diagonal + (x01 + y00 + z2) * i00 * i10 + (x11 + y01 + z2) * i10 * i11;
  const F d2 = one + diagonal + (x00 + y01 + z2) * i00 * i01 + (x01 + y11 + z2) * i01 * i11;
  const F shared = ((r.x1 - r.x0) * i00) * ((r.y1 - r.y0) * i11) * r.z;
  const F v1 = shared * i10, v2 = shared * i01;
  return F(2.0f) * arcTan2(maximum(v1 * d2 + v2 * d1, F(0.0f)), d1 * d2 - v1 * v2);
}

}  // namespace detail

/// Solid angle in sr, in [0, 2 pi]; the error is below 2e-6 sr or 2e-5 of the value, whichever is larger, as far as the
/// numbers of the rectangle are exact; small and far ones keep the relative error.
template <class F>
F solidAngleOf(const SeenRectangle<F>& r) {
  const F bound = r.solidAngleBound();
  const MaskOf<F> large = bound >= F(kUniformRectangleMin);
  F result(0.0f);
  if (any(large)) result = detail::sumCorners(r).total;
  if (all(large)) return result;
  return select(large, result, minimum(detail::solidAngleByTriangles(r), bound));
}

/// The point (x, y) of the rectangle in the direction that is chosen uniformly in its solid angle.
///
/// After Urena, Fajardo & King 2013, "An area-preserving parametrization for spherical rectangles", rewritten for short
/// floats. With A(x, y) = atan(x y / (z r)), the solid angle of the rectangle between the axes and (x, y), the strip
/// left of x has the solid angle B(x) - B(x0), B(x) = A(x, y1) - A(x, y0). So x solves B(x) = c = B(x0) + u.x (B(x1) -
/// B(x0)), by
///   x = z sin c / sqrt(n^2 - (w sin c)^2),  n = h1 - h0 cos c,  h_i = y_i / sqrt(y_i^2 + z^2),  w = z / sqrt(y0^2 +
///   z^2),
/// with n from the half angle, on the side where it does not cancel. In the strip, y / r is uniform.
template <class F>
Vec2<F> sampleSolidAngle(const SeenRectangle<F>& r, const detail::CornerSum<F>& corners, Vec2<F> u) {
  const F z2 = r.z * r.z, one(1.0f), two(2.0f), tiny(1e-30f);
  const F y00 = r.y0 * r.y0, y11 = r.y1 * r.y1;
  const SinCos<F> half = sinCos(F(0.5f) * (corners.left + u.x * corners.total));
  const F ss = half.sin * half.sin, cc = half.cos * half.cos;
  const F sinC = two * half.sin * half.cos;
  const F i0 = one / maximum(squareRoot(y00 + z2), tiny), i1 = one / maximum(squareRoot(y11 + z2), tiny);
  const F h0 = r.y0 * i0, h1 = r.y1 * i1, w = r.z * i0 * sinC;
  const F n = select(ss < cc, (h1 - h0) + two * h0 * ss, (h1 + h0) - two * h0 * cc);
  const F x = clamp(r.z * sinC / squareRoot(maximum((n - w) * (n + w), tiny)), r.x0, r.x1);

  const F dd = x * x + z2;
  const F g0 = r.y0 / maximum(squareRoot(dd + y00), tiny), g1 = r.y1 / maximum(squareRoot(dd + y11), tiny);
  const F g = lerp(g0, g1, u.y);
  const F y = clamp(g * squareRoot(dd / maximum((one - g) * (one + g), tiny)), r.y0, r.y1);
  return {x, y};
}

/// Inverse of sampleSolidAngle: the random numbers that give the point (x, y): the share of the strip left of x, by the
/// corner angles (absolute error below 1e-5 over the solid angle), and the share of y / r.
template <class F>
Vec2<F> invertSolidAngle(const SeenRectangle<F>& r, const detail::CornerSum<F>& corners, Vec2<F> p) {
  const F tiny(1e-30f);
  const F strip = detail::cornerAngle(p.x, r.y1, r.z) - detail::cornerAngle(p.x, r.y0, r.z);
  const F dd = p.x * p.x + r.z * r.z;
  const auto slope = [&](F y) { return y / maximum(squareRoot(dd + y * y), tiny); };
  const F g0 = slope(r.y0), g1 = slope(r.y1);
  return {(strip - corners.left) / corners.total, (slope(p.y) - g0) / maximum(g1 - g0, tiny)};
}

/// How directions towards a rectangle are chosen; a pure function of the rectangle, so that sample and pdf agree.
template <class F>
class RectangleDirections {
 public:
  /// `allowed` false: by area in any case.
  RectangleDirections(const SeenRectangle<F>& r, MaskOf<F> allowed) : rectangle_(r) {
    // A bound that costs one square root: most small rectangles then need no solid angle.
    const MaskOf<F> maybe = allowed & (r.solidAngleBound() >= F(kUniformRectangleMin));
    if (!any(maybe)) return;
    corners_ = detail::sumCorners(r);
    uniform_ = maybe & (corners_.total >= F(kUniformRectangleMin));
  }

  /// Uniform in solid angle, or else by area.
  MaskOf<F> uniform() const { return uniform_; }

  Vec2<F> sample(Vec2<F> u) const {
    const SeenRectangle<F>& r = rectangle_;
    const Vec2<F> byArea{r.x0 + (r.x1 - r.x0) * u.x, r.y0 + (r.y1 - r.y0) * u.y};
    if (!any(uniform_)) return byArea;
    return select(uniform_, sampleSolidAngle(r, corners_, u), byArea);
  }
  /// Inverse of sample(): the random numbers that give the point p.
  Vec2<F> invert(Vec2<F> p) const {
    const SeenRectangle<F>& r = rectangle_;
    const auto toUnit = [](F u) { return clamp(u, F(0.0f), F(kOneMinusEpsilon)); };
    Vec2<F> u{(p.x - r.x0) / (r.x1 - r.x0), (p.y - r.y0) / (r.y1 - r.y0)};
    if (any(uniform_)) u = select(uniform_, invertSolidAngle(r, corners_, p), u);
    return {toUnit(u.x), toUnit(u.y)};
  }
  /// Per sr, for a direction that hits the rectangle at this distance.
  F pdf(F distance) const {
    const F byArea = densityPerSteradian(F(1.0f) / rectangle_.area(), distance, rectangle_.z);
    return select(uniform_, F(1.0f) / corners_.total, byArea);
  }

 private:
  SeenRectangle<F> rectangle_;
  detail::CornerSum<F> corners_{F(0.0f), F(0.0f)};
  MaskOf<F> uniform_{false};
};

}  // namespace steradian
