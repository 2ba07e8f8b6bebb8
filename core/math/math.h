#pragma once
/// Elementary functions over lanes.
///
/// Transcendentals are polynomials of our own evaluation order, the same at every width and on every machine: libm's
/// differ between versions, and pictures must not. Coefficients: S. Moshier, Cephes Mathematical Library (single
/// precision). Errors stated are maxima over the domain given, checked by the tests.
#include <limits>

#include "steradian/core/math/lanes.h"

namespace STERADIAN_API steradian {

inline constexpr float kPi = 3.14159265358979f;
inline constexpr float kTwoPi = 6.28318530717959f;
inline constexpr float kFourPi = 12.5663706143592f;
inline constexpr float kPiOver2 = 1.57079632679490f;
inline constexpr float kPiOver4 = 0.785398163397448f;
inline constexpr float kInvPi = 0.318309886183791f;
inline constexpr float kInvTwoPi = 0.159154943091895f;
inline constexpr float kInvFourPi = 0.0795774715459477f;
inline constexpr float kInfinity = std::numeric_limits<float>::infinity();
/// The largest float below 1: random numbers are in [0, kOneMinusEpsilon].
inline constexpr float kOneMinusEpsilon = 0x1.fffffep-1f;
/// Half the distance from 1 to the next float: the relative error of one rounding.
inline constexpr float kMachineEpsilon = 0x1p-24f;

/// Bound of the relative error after n roundings (Higham 2002, section 3.1).
constexpr float gammaBound(int n) {
  const float ne = static_cast<float>(n) * kMachineEpsilon;
  return ne / (1.0f - ne);
}

template <class F>
F sqr(F x) {
  return x * x;
}
template <class F>
F absolute(F x) {
  return floatOf(bitsOf(x) & UintOf<F>(0x7fffffffu));
}
/// Magnitude of the first with the sign bit of the second.
template <class F>
F copySign(F magnitude, F sign) {
  return floatOf((bitsOf(magnitude) & UintOf<F>(0x7fffffffu)) | (bitsOf(sign) & UintOf<F>(0x80000000u)));
}
template <class F>
F clamp(F x, std::type_identity_t<F> low, std::type_identity_t<F> high) {
  return minimum(maximum(x, low), high);
}
/// Square root that takes rounding below zero as zero.
template <class F>
F safeSqrt(F x) {
  return squareRoot(maximum(x, F(0.0f)));
}
template <class F>
F lerp(F a, std::type_identity_t<F> b, std::type_identity_t<F> t) {
  return a + (b - a) * t;
}
template <class F>
MaskOf<F> isFinite(F x) {
  return absolute(x) <= F(std::numeric_limits<float>::max());
}
/// Largest integer not above x, for |x| < 2^31.
template <class F>
F floorOf(F x) {
  const F truncated = toFloat(toInt(x));
  return truncated - select(truncated > x, F(1.0f), F(0.0f));
}
/// a*b - c*d without catastrophic cancellation, with float products split exactly (Dekker 1971; no FMA needed).
template <class F>
F differenceOfProducts(F a, F b, F c, F d) {
  const auto twoProduct = [](F x, F y, F& error) {
    const F splitter(4097.0f);
    const F cx = splitter * x, cy = splitter * y;
    const F xh = cx - (cx - x), yh = cy - (cy - y);
    const F xl = x - xh, yl = y - yh;
    const F product = x * y;
    error = ((xh * yh - product) + xh * yl + xl * yh) + xl * yl;
    return product;
  };
  F errorAb, errorCd;
  const F ab = twoProduct(a, b, errorAb), cd = twoProduct(c, d, errorCd);
  return (ab - cd) + (errorAb - errorCd);
}

template <class F>
struct SinCos {
  F sin, cos;
};

/// Sine and cosine of x with |x| <= pi/4 (error < 1e-7).
template <class F>
SinCos<F> sinCosReduced(F x) {
  const F z = x * x;
  const F s = ((F(-1.9515295891e-4f) * z + F(8.3321608736e-3f)) * z + F(-1.6666654611e-1f)) * z * x + x;
  const F c = ((F(2.443315711809948e-5f) * z + F(-1.388731625493765e-3f)) * z + F(4.166664568298827e-2f)) * z * z -
              F(0.5f) * z + F(1.0f);
  return {s, c};
}

/// Rotate the reduced pair by `quadrant` right angles.
template <class F>
SinCos<F> rotateQuadrant(SinCos<F> reduced, IntOf<F> quadrant) {
  const UintOf<F> q = toUnsigned(quadrant);
  const MaskOf<F> swap = (q & UintOf<F>(1u)) != UintOf<F>(0u);
  const F s = select(swap, reduced.cos, reduced.sin);
  const F c = select(swap, reduced.sin, reduced.cos);
  const UintOf<F> signS = (q & UintOf<F>(2u)) << 30;
  const UintOf<F> signC = ((q + UintOf<F>(1u)) & UintOf<F>(2u)) << 30;
  return {floatOf(bitsOf(s) ^ signS), floatOf(bitsOf(c) ^ signC)};
}

/// Sine and cosine of 2 pi u for |u| <= 1024: the range reduction is exact (absolute error < 2e-7).
template <class F>
SinCos<F> sinCosTwoPi(F u) {
  const F quarter = F(4.0f) * u;
  const F nearest = floorOf(quarter + F(0.5f));
  return rotateQuadrant(sinCosReduced((quarter - nearest) * F(kPiOver2)), toInt(nearest));
}

/// Sine and cosine of x radians, |x| <= 8192 (absolute error < 2e-7; Cody & Waite 1980 reduction).
template <class F>
SinCos<F> sinCos(F x) {
  const F nearest = floorOf(x * F(0.636619772367581f) + F(0.5f));
  const F r = ((x - nearest * F(1.5703125f)) - nearest * F(4.837512969970703e-4f)) - nearest * F(7.54978995489188e-8f);
  return rotateQuadrant(sinCosReduced(r), toInt(nearest));
}

/// Arc cosine of x, clamped to [-1, 1] (absolute error < 4e-7 rad, relative near 1).
template <class F>
F arcCos(F x) {
  const F a = minimum(absolute(x), F(1.0f));
  const MaskOf<F> outer = a > F(0.5f);
  const F z = select(outer, F(0.5f) * (F(1.0f) - a), a * a);
  const F y = select(outer, squareRoot(z), a);
  const F p =
      ((((F(4.2163199048e-2f) * z + F(2.4181311049e-2f)) * z + F(4.5470025998e-2f)) * z + F(7.4953002686e-2f)) * z +
       F(1.6666752422e-1f)) *
          z * y +
      y;  // arc sine of y
  const F acosOfMagnitude = select(outer, F(2.0f) * p, F(kPiOver2) - p);
  return select(x < F(0.0f), F(kPi) - acosOfMagnitude, acosOfMagnitude);
}

/// Angle of the point (x, y) in (-pi, pi]; 0 at the origin (absolute error < 4e-7 rad).
template <class F>
F arcTan2(F y, F x) {
  const F ax = absolute(x), ay = absolute(y);
  const F large = maximum(ax, ay), small = minimum(ax, ay);
  F t = select(large > F(0.0f), small / large, F(0.0f));  // in [0, 1]
  const MaskOf<F> upper = t > F(0.414213562373095f);      // tan(pi/8)
  t = select(upper, (t - F(1.0f)) / (t + F(1.0f)), t);
  const F z = t * t;
  F angle =
      (((F(8.05374449538e-2f) * z + F(-1.38776856032e-1f)) * z + F(1.99777106478e-1f)) * z + F(-3.33329491539e-1f)) *
          z * t +
      t;
  angle = select(upper, angle + F(kPiOver4), angle);
  angle = select(ay > ax, F(kPiOver2) - angle, angle);
  angle = select(x < F(0.0f), F(kPi) - angle, angle);
  return copySign(angle, y);
}

/// e^x (relative error < 2e-7); 0 below -87.3, +inf above 88.7.
template <class F>
F exponential(F x) {
  const F c = clamp(x, F(-87.3f), F(88.72f));
  const F n = floorOf(c * F(1.44269504088896341f) + F(0.5f));
  const F r = (c - n * F(0.693359375f)) - n * F(-2.12194440e-4f);
  F p = F(1.9875691500e-4f) * r + F(1.3981999507e-3f);
  p = p * r + F(8.3334519073e-3f);
  p = p * r + F(4.1665795894e-2f);
  p = p * r + F(1.6666665459e-1f);
  p = p * r + F(5.0000001201e-1f);
  p = p * (r * r) + r + F(1.0f);
  // 2^n in two factors: n can be 128, which has no float of its own.
  const IntOf<F> whole = toInt(n);
  const UintOf<F> half = toUnsigned(toInt(floorOf(n * F(0.5f))));
  const UintOf<F> rest = toUnsigned(whole) - half;
  const F power = floatOf((half + UintOf<F>(127u)) << 23), powerRest = floatOf((rest + UintOf<F>(127u)) << 23);
  const F result = p * power * powerRest;
  return select(x < F(-87.3f), F(0.0f), select(x > F(88.72f), F(kInfinity), result));
}

/// e^x - 1 without cancellation near 0 (relative error < 4e-7); -1 below -87.3, +inf above 88.7.
template <class F>
F exponentialMinusOne(F x) {
  // The polynomial of exponential() for |x| < ln 2 / 2, before it adds the 1.
  F p = F(1.9875691500e-4f) * x + F(1.3981999507e-3f);
  p = p * x + F(8.3334519073e-3f);
  p = p * x + F(4.1665795894e-2f);
  p = p * x + F(1.6666665459e-1f);
  p = p * x + F(5.0000001201e-1f);
  return select(absolute(x) < F(0.34f), p * (x * x) + x, exponential(x) - F(1.0f));
}

/// Natural logarithm of a positive, normal x (relative error < 2e-7); -inf at 0 and for denormals, NaN below.
template <class F>
F logarithm(F x) {
  const UintOf<F> bits = bitsOf(x);
  // Mantissa in [sqrt 1/2, sqrt 2).
  F e = toFloat(toSigned(bits >> 23)) - F(126.0f);
  F m = floatOf((bits & UintOf<F>(0x007fffffu)) | UintOf<F>(0x3f000000u));
  const MaskOf<F> low = m < F(0.707106781186548f);
  e = select(low, e - F(1.0f), e);
  m = select(low, m + m, m) - F(1.0f);
  const F z = m * m;
  F p = F(7.0376836292e-2f) * m + F(-1.1514610310e-1f);
  p = p * m + F(1.1676998740e-1f);
  p = p * m + F(-1.2420140846e-1f);
  p = p * m + F(1.4249322787e-1f);
  p = p * m + F(-1.6668057665e-1f);
  p = p * m + F(2.0000714765e-1f);
  p = p * m + F(-2.4999993993e-1f);
  p = p * m + F(3.3333331174e-1f);
  F y = p * m * z;
  y = y + F(-2.12194440e-4f) * e - F(0.5f) * z;
  const F result = (m + y) + F(0.693359375f) * e;
  const F special = select(x < F(0.0f), F(std::numeric_limits<float>::quiet_NaN()), F(-kInfinity));
  const F finiteOrInfinite = select(x > F(std::numeric_limits<float>::max()), x, result);
  return select(x < F(std::numeric_limits<float>::min()), special, finiteOrInfinite);
}

/// x^y for x >= 0 (relative error < 1e-5 for |y log x| < 20).
template <class F>
F power(F x, std::type_identity_t<F> y) {
  return select(x > F(0.0f), exponential(y * logarithm(x)), F(0.0f));
}

}  // namespace steradian
