#pragma once
/// Counter-based random numbers: a value is a pure function of its key, so any sample of any pixel can be drawn at any
/// time, in any order, on any number of threads, with the same result.
#include <array>

#include "steradian/core/math/vec.h"

namespace STERADIAN_API steradian {

/// A float in [0, 1) from the upper 24 bits.
template <class F>
F toUnitFloat(UintOf<F> bits) {
  return toFloat(toSigned(bits >> 8)) * F(0x1p-24f);
}

/// Mixes 32 bits (Wellons' "lowbias32" constants); a bijection.
template <class U>
constexpr U mixBits(U x) {
  x ^= x >> 16;
  x *= U(0x7feb352du);
  x ^= x >> 15;
  x *= U(0x846ca68bu);
  x ^= x >> 16;
  return x;
}

/// Four random words from a four-word key: pcg4d (Jarzynski & Olano 2020, JCGT 9(3)).
/// (To g++, `inline` on a template is a hint that it follows: without it a Sobol' pair takes half as long again.)
template <class U>
inline std::array<U, 4> randomWords(U x, U y, U z, U w) {
  const U multiplier(1664525u), increment(1013904223u);
  x = x * multiplier + increment;
  y = y * multiplier + increment;
  z = z * multiplier + increment;
  w = w * multiplier + increment;
  const auto round = [&] {
    x += y * w;
    y += z * x;
    z += x * y;
    w += y * z;
  };
  round();
  x ^= x >> 16;
  y ^= y >> 16;
  z ^= z >> 16;
  w ^= w >> 16;
  round();
  return {x, y, z, w};
}

/// An unbounded stream for draws whose number is not known beforehand (tracking, layered walks), keyed like the
/// samplers' dimensions. Width 1.
class RandomStream {
 public:
  RandomStream(std::uint32_t pixel, std::uint32_t sample, std::uint32_t dimension, std::uint32_t seed)
      : pixel_(pixel), sample_(sample), dimension_(mixBits(dimension ^ 0x9e3779b9u) ^ seed) {}

  float next() {
    if (used_ == 4) {
      words_ = randomWords(pixel_, sample_, dimension_, counter_++);
      used_ = 0;
    }
    return toUnitFloat<float>(words_[used_++]);
  }

 private:
  std::uint32_t pixel_, sample_, dimension_;
  std::uint32_t counter_ = 0, used_ = 4;
  std::array<std::uint32_t, 4> words_{};
};

}  // namespace steradian
