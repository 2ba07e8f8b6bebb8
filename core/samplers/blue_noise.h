#pragma once
/// Errors of neighbouring pixels that cancel: one Sobol' sequence for all pixels of a square, which visits them in a
/// random Z order (Ahmed & Wonka 2020, "Screen-space blue-noise diffusion of Monte Carlo sampling error via
/// hierarchical ordering of pixels", ACM TOG 39(6)). Each pixel has an aligned block of points, four pixels of an
/// aligned square have one four times as long, and so on: the means over them are as good as points of one pixel, so
/// what error is left is of high spatial frequency, which the eye and every filter average away. The samples per pixel
/// must be known beforehand.
#include <algorithm>
#include <bit>
#include <cstdint>

#include "steradian/core/samplers/sobol.h"

namespace STERADIAN_API steradian {

/// How the bits of the sequence's index are divided: the lower ones number the sample in its pixel, the upper ones the
/// pixel in its square.
struct BlueNoiseLayout {
  int sampleBits = 0;
  int pixelBits = 0;  ///< even; the square has 2^(pixelBits / 2) pixels in a row

  /// `count`: samples of a pixel, 1 ... 2^24. Squares of 256 x 256 pixels, or smaller if samples leave fewer bits.
  static constexpr BlueNoiseLayout of(std::uint32_t count) {
    const int sampleBits = static_cast<int>(std::bit_width(count - 1u));
    return {sampleBits, std::min(16, (32 - sampleBits) / 2 * 2)};
  }
};

/// Renumbers the four quadrants of every square, from the largest down to 2 x 2 pixels, at random and in each square
/// anew: on average no direction is preferred. Together with a nested scramble of the binary digits, which swaps the
/// two halves and the parts of each half, all 24 orders are equally likely: here only one of the three pairings of
/// quadrants is chosen, by multiplication in the field of four elements.
template <class U>
U shufflePairings(U index, const BlueNoiseLayout& layout, U seed) {
  for (int level = layout.pixelBits / 2 - 1; level >= 0; --level) {
    const int shift = layout.sampleBits + 2 * level;
    const U upper = index >> shift;  // this quadrant and those around it
    const U quadrant = upper & U(3u);
    const U hash = mixBits((((upper >> 2) << 4) | U(static_cast<std::uint32_t>(level))) ^ seed);
    const U pairing = ((hash >> 16) * U(3u)) >> 16;  // 0, 1, 2
    const U once = (((quadrant << 1) ^ quadrant) & U(2u)) | (quadrant >> 1);
    const U twice = ((quadrant << 1) & U(2u)) | (((quadrant >> 1) ^ quadrant) & U(1u));
    const U turned = select(pairing == U(1u), once, select(pairing == U(2u), twice, quadrant));
    index ^= (turned ^ quadrant) << shift;
  }
  return index;
}

/// The index of a sample in the sequence of its square, before shuffling. `pixel` is its Morton number
/// (core/math/morton.h); of `sample` the lower bits count.
template <class U>
U blueNoiseIndex(U pixel, U sample, const BlueNoiseLayout& layout) {
  const U inSquare = pixel & U((1u << layout.pixelBits) - 1u);
  const U inPixel = sample & U((1u << layout.sampleBits) - 1u);
  return (inSquare << layout.sampleBits) | inPixel;
}
/// The Morton number of the square; it belongs to the key of its points.
template <class U>
U blueNoiseSquare(U pixel, const BlueNoiseLayout& layout) {
  return pixel >> layout.pixelBits;
}

/// `key`: independent random words per square, dimension and round of samples.
template <class F>
Vec2<F> blueNoise2D(UintOf<F> index, const BlueNoiseLayout& layout, const std::array<UintOf<F>, 4>& key) {
  return owenSobol2D<F>(reverseBits(shufflePairings(index, layout, key[3])), key[0], key[1], key[2]);
}
template <class F>
F blueNoise1D(UintOf<F> index, const BlueNoiseLayout& layout, const std::array<UintOf<F>, 4>& key) {
  return owenSobol1D<F>(reverseBits(shufflePairings(index, layout, key[3])), key[0], key[1]);
}

}  // namespace steradian
