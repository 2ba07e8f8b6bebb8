#pragma once
/// Light and reflectance per RGB channel of the working space: linear Rec.709 primaries, D65 white.
/// Radiance is in W sr^-1 m^-2 per channel; reflectance and weights have no unit.
#include "steradian/core/math/math.h"

namespace STERADIAN_API steradian {

template <class F>
struct Spectrum {
  F r{}, g{}, b{};

  friend Spectrum operator+(Spectrum a, Spectrum c) { return {a.r + c.r, a.g + c.g, a.b + c.b}; }
  friend Spectrum operator-(Spectrum a, Spectrum c) { return {a.r - c.r, a.g - c.g, a.b - c.b}; }
  friend Spectrum operator*(Spectrum a, Spectrum c) { return {a.r * c.r, a.g * c.g, a.b * c.b}; }
  friend Spectrum operator*(Spectrum a, F s) { return {a.r * s, a.g * s, a.b * s}; }
  friend Spectrum operator*(F s, Spectrum a) { return a * s; }
  friend Spectrum operator/(Spectrum a, F s) { return {a.r / s, a.g / s, a.b / s}; }
  Spectrum& operator+=(Spectrum c) { return *this = *this + c; }
  Spectrum& operator*=(Spectrum c) { return *this = *this * c; }
  Spectrum& operator*=(F s) { return *this = *this * s; }
};

using Rgb = Spectrum<float>;

template <class F>
Spectrum<F> grey(F x) {
  return {x, x, x};
}
template <class F>
Spectrum<F> broadcast(Rgb s) {
  return {F(s.r), F(s.g), F(s.b)};
}
template <class F>
Rgb lane(const Spectrum<F>& s, int i) {
  return {lane(s.r, i), lane(s.g, i), lane(s.b, i)};
}
template <class F>
void setLane(Spectrum<F>& s, int i, Rgb value) {
  setLane(s.r, i, value.r);
  setLane(s.g, i, value.g);
  setLane(s.b, i, value.b);
}
template <class F>
Spectrum<F> select(MaskOf<F> m, const Spectrum<F>& a, const Spectrum<F>& b) {
  return {select(m, a.r, b.r), select(m, a.g, b.g), select(m, a.b, b.b)};
}
/// Relative luminance Y of Rec.709.
template <class F>
F luminance(const Spectrum<F>& s) {
  return F(0.2126f) * s.r + F(0.7152f) * s.g + F(0.0722f) * s.b;
}
template <class F>
F maxChannel(const Spectrum<F>& s) {
  return maximum(maximum(s.r, s.g), s.b);
}
template <class F>
MaskOf<F> isBlack(const Spectrum<F>& s) {
  return maxChannel(s) <= F(0.0f);
}

}  // namespace steradian
