#pragma once
/// Warps: maps from the unit square (or interval) to a domain, with the density of the result.
///
/// Each is a small value with `sample(u)`, `pdf(x)` and `invert(x)`: invert(sample(u)) is u up to rounding. Random
/// numbers are in [0, 1) and may be 0; directions are local, with the axis along (0, 0, 1). Densities of directions are
/// per steradian. Solid angle is measured in 1 - cos(theta) and phi, and 1 - cos(theta) is carried in place of the
/// cosine wherever the cosine is near 1: half the digits of a small angle would be lost in it.
#include "steradian/core/math/vec.h"

namespace STERADIAN_API steradian {

/// An azimuth as a random number: phi / 2 pi in [0, 1).
template <class F>
F invertAzimuth(F x, F y) {
  const F turn = arcTan2(y, x) * F(kInvTwoPi);
  return minimum(select(turn < F(0.0f), turn + F(1.0f), turn), F(kOneMinusEpsilon));
}

/// 1 - cos(theta) of the unit vector w without cancellation: sin^2 / (1 + cos) in the upper half.
template <class F>
F oneMinusCosTheta(Vec3<F> w) {
  return select(w.z > F(0.0f), (w.x * w.x + w.y * w.y) / (F(1.0f) + w.z), F(1.0f) - w.z);
}

/// The unit vector with 1 - cos(theta) = h in [0, 2] and phi = 2 pi turn; sin^2 = h (2 - h).
template <class F>
Vec3<F> directionOf(F h, F turn) {
  const F sinTheta = safeSqrt(h * (F(2.0f) - h));
  const SinCos<F> phi = sinCosTwoPi(turn);
  return {sinTheta * phi.cos, sinTheta * phi.sin, F(1.0f) - h};
}

/// Uniform directions: 1 - cos(theta) = 2 u.x, phi = 2 pi u.y (Archimedes' hat box). pdf = 1 / 4 pi.
template <class F>
struct UniformSphere {
  static Vec3<F> sample(Vec2<F> u) { return directionOf(F(2.0f) * u.x, u.y); }
  static F pdf(Vec3<F>) { return F(kInvFourPi); }
  static Vec2<F> invert(Vec3<F> w) {
    return {minimum(F(0.5f) * oneMinusCosTheta(w), F(kOneMinusEpsilon)), invertAzimuth(w.x, w.y)};
  }
};

/// Uniform directions of the upper hemisphere: cos(theta) = 1 - u.x > 0. pdf = 1 / 2 pi for z >= 0, else 0.
template <class F>
struct UniformHemisphere {
  static Vec3<F> sample(Vec2<F> u) { return directionOf(u.x, u.y); }
  static F pdf(Vec3<F> w) { return select(w.z >= F(0.0f), F(kInvTwoPi), F(0.0f)); }
  static Vec2<F> invert(Vec3<F> w) {
    return {minimum(oneMinusCosTheta(w), F(kOneMinusEpsilon)), invertAzimuth(w.x, w.y)};
  }
};

/// Uniform directions of the cone with 1 - cos(theta) <= `oneMinusCosMax`, in [1e-37, 2]; pdf = 1 / (2 pi
/// oneMinusCosMax). Stable for every angle that floats distinguish from zero (Pharr, Jakob & Humphreys, "Physically
/// Based Rendering", 4th ed., A.5.4, with the complement of the cosine as parameter).
template <class F>
struct UniformCone {
  F oneMinusCosMax;

  Vec3<F> sample(Vec2<F> u) const { return directionOf(u.x * oneMinusCosMax, u.y); }
  /// Directions beyond the rim by up to 1e-6 of oneMinusCosMax count as inside: they are samples, rounded.
  F pdf(Vec3<F> w) const {
    return select(oneMinusCosTheta(w) <= oneMinusCosMax * F(1.0f + 0x1p-20f), pdfInside(), F(0.0f));
  }
  F pdfInside() const { return F(kInvTwoPi) / oneMinusCosMax; }
  Vec2<F> invert(Vec3<F> w) const {
    return {minimum(oneMinusCosTheta(w) / oneMinusCosMax, F(kOneMinusEpsilon)), invertAzimuth(w.x, w.y)};
  }
};

/// Uniform points of the unit disk by the concentric map, which keeps neighbours together (Shirley & Chiu 1997, JGT
/// 2(3)): concentric squares become circles. pdf = 1 / pi per unit of area.
template <class F>
struct UniformDisk {
  /// A point with its signed distance from the centre, from which 1 - |point|^2 = (1 - radius)(1 + radius) keeps its
  /// digits near the rim.
  struct Concentric {
    Vec2<F> point;
    F radius;
  };
  static Vec2<F> sample(Vec2<F> u) { return concentric(u).point; }
  static Concentric concentric(Vec2<F> u) {
    const F a = F(2.0f) * u.x - F(1.0f), b = F(2.0f) * u.y - F(1.0f);
    const MaskOf<F> alongX = absolute(a) > absolute(b);
    const F radius = select(alongX, a, b), other = select(alongX, b, a);
    const F ratio = select(radius == F(0.0f), F(0.0f), other / radius);
    const SinCos<F> phi = sinCosReduced(F(kPiOver4) * ratio);  // from the nearest axis
    return {{radius * select(alongX, phi.cos, phi.sin), radius * select(alongX, phi.sin, phi.cos)}, radius};
  }
  static F pdf(Vec2<F> p) { return select(p.x * p.x + p.y * p.y <= F(1.0f + 0x1p-20f), F(kInvPi), F(0.0f)); }
  static Vec2<F> invert(Vec2<F> p) {
    const MaskOf<F> alongX = absolute(p.x) > absolute(p.y);
    const F major = select(alongX, p.x, p.y), minor = select(alongX, p.y, p.x);
    const F radius = copySign(squareRoot(p.x * p.x + p.y * p.y), major);
    // The angle from the nearest axis, with the sign of minor / major.
    const F angle = arcTan2(select(major < F(0.0f), -minor, minor), absolute(major));
    const F other = radius * angle * F(1.0f / kPiOver4);
    const F a = select(alongX, radius, other), b = select(alongX, other, radius);
    const auto toUnit = [](F x) { return clamp(F(0.5f) * x + F(0.5f), F(0.0f), F(kOneMinusEpsilon)); };
    return {toUnit(a), toUnit(b)};
  }
};

/// The same by polar coordinates: radius = sqrt(u.x), phi = 2 pi u.y ("The Rest of Your Life", 7.3, lifts these points
/// onto the hemisphere). Simpler, but thin sectors meet at the centre: strata keep their area, not their shape.
template <class F>
struct UniformDiskPolar {
  static Vec2<F> sample(Vec2<F> u) {
    const F radius = squareRoot(u.x);
    const SinCos<F> phi = sinCosTwoPi(u.y);
    return {radius * phi.cos, radius * phi.sin};
  }
  static F pdf(Vec2<F> p) { return UniformDisk<F>::pdf(p); }
  static Vec2<F> invert(Vec2<F> p) {
    return {minimum(p.x * p.x + p.y * p.y, F(kOneMinusEpsilon)), invertAzimuth(p.x, p.y)};
  }
};

/// Directions with density cos(theta) / pi: points of the disk, lifted onto the hemisphere (Malley's method). The
/// cosine of a sample is at least 3e-4, so that its pdf is never 0.
template <class F>
struct CosineHemisphere {
  static Vec3<F> sample(Vec2<F> u) {
    const auto disk = UniformDisk<F>::concentric(u);
    const F r = minimum(absolute(disk.radius), F(kOneMinusEpsilon));
    return {disk.point.x, disk.point.y, squareRoot((F(1.0f) - r) * (F(1.0f) + r))};
  }
  static F pdf(Vec3<F> w) { return maximum(w.z, F(0.0f)) * F(kInvPi); }
  static Vec2<F> invert(Vec3<F> w) { return UniformDisk<F>::invert({w.x, w.y}); }
};

/// Uniform points of a triangle (a, b, c): the weights of b and c, each >= 0, their sum < 1 (Heitz 2019, "A
/// low-distortion map between triangle and square"). pdf = 2 per unit of (b, c); divide by twice the area for the
/// density per m^2.
template <class F>
struct UniformTriangle {
  static Vec2<F> sample(Vec2<F> u) {
    const MaskOf<F> upper = u.y > u.x;
    const F half = F(0.5f) * select(upper, u.x, u.y);
    return {select(upper, half, u.x - half), select(upper, u.y - half, half)};
  }
  static F pdf(Vec2<F> p) {
    const MaskOf<F> inside = (p.x >= F(0.0f)) & (p.y >= F(0.0f)) & (p.x + p.y <= F(1.0f));
    return select(inside, F(2.0f), F(0.0f));
  }
  static Vec2<F> invert(Vec2<F> p) {
    const MaskOf<F> upper = p.y > p.x;
    const F sum = minimum(p.x + p.y, F(kOneMinusEpsilon));
    return {select(upper, F(2.0f) * p.x, sum), select(upper, sum, F(2.0f) * p.y)};
  }
};

/// Uniform points u.x a + u.y b of the parallelogram with the edges a and b, which are not parallel; pdf = 1 / area.
/// Its cross products do not cancel, so that slivers keep their inverse.
template <class F>
struct UniformParallelogram {
  Vec2<F> a, b;

  Vec2<F> sample(Vec2<F> u) const { return {a.x * u.x + b.x * u.y, a.y * u.x + b.y * u.y}; }
  /// Points beyond an edge by up to 1e-6 of the other count as inside: they are samples, rounded.
  F pdf(Vec2<F> p) const {
    const Vec2<F> c = coordinates(p);
    const F low(-0x1p-20f), high(1.0f + 0x1p-20f);
    const MaskOf<F> inside = (c.x >= low) & (c.x <= high) & (c.y >= low) & (c.y <= high);
    return select(inside, F(1.0f) / absolute(determinant()), F(0.0f));
  }
  Vec2<F> invert(Vec2<F> p) const {
    const Vec2<F> c = coordinates(p);
    const auto toUnit = [](F x) { return clamp(x, F(0.0f), F(kOneMinusEpsilon)); };
    return {toUnit(c.x), toUnit(c.y)};
  }

 private:
  F determinant() const { return differenceOfProducts(a.x, b.y, a.y, b.x); }
  Vec2<F> coordinates(Vec2<F> p) const {
    const F scale = F(1.0f) / determinant();
    return {differenceOfProducts(p.x, b.y, p.y, b.x) * scale, differenceOfProducts(a.x, p.y, a.y, p.x) * scale};
  }
};

/// Directions with density (n + 1) / 2 pi cos^n(theta) in the upper hemisphere, n >= 0: cos(theta) = (1 - u.x)^(1 / (n
/// + 1)). n = 3 is the exact density for the integral of cos^3 ("The Rest of Your Life", 7.2). Relative error of the
/// pdf below 1e-6 (1 + n): for n up to 1000. Samples lie above the horizon for n up to 1e4.
template <class F>
struct PowerCosineHemisphere {
  F exponent;

  Vec3<F> sample(Vec2<F> u) const {
    // 1 - cos(theta) directly: near the axis the cosine would lose its digits.
    const F h = F(0.0f) - exponentialMinusOne(logarithm(F(1.0f) - u.x) / (exponent + F(1.0f)));
    return directionOf(h, u.y);
  }
  F pdf(Vec3<F> w) const {
    return select(w.z > F(0.0f), (exponent + F(1.0f)) * F(kInvTwoPi) * power(w.z, exponent), F(0.0f));
  }
  Vec2<F> invert(Vec3<F> w) const {
    const F u = F(1.0f) - power(maximum(w.z, F(0.0f)), exponent + F(1.0f));
    return {clamp(u, F(0.0f), F(kOneMinusEpsilon)), invertAzimuth(w.x, w.y)};
  }
};

/// Free flight in a medium of constant extinction `rate` > 0 (per m): t = -ln(1 - u) / rate, at most 16.7 / rate; pdf =
/// rate exp(-rate t) per m. Of u, the 24 bits that random numbers have count.
template <class F>
struct ExponentialFlight {
  F rate;

  F sample(F u) const { return (F(0.0f) - logarithm(F(1.0f) - u)) / rate; }
  F pdf(F t) const { return select(t >= F(0.0f), rate * exponential(-rate * t), F(0.0f)); }
  F invert(F t) const { return clamp(F(1.0f) - exponential(-rate * t), F(0.0f), F(kOneMinusEpsilon)); }
};

}  // namespace steradian
