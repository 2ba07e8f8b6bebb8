#pragma once
/// Sobol's sequence in 256 coordinates (Sobol' 1967) with the direction numbers of Joe & Kuo 2008, so that coordinates
/// of different dimensions are stratified together: the opposite of "padding" (core/samplers/sobol.h). The price: only
/// the first two coordinates are a (0,2)-sequence; the boxes of other pairs hold one point each only on average.
#include <array>
#include <cstdint>

#include "steradian/core/samplers/owen.h"
#include "steradian/core/samplers/rng.h"

namespace STERADIAN_API steradian {

inline constexpr std::uint32_t kSobolCoordinates = 256;

/// Column b of the generator matrix of coordinate c is entry 32 c + b: what bit b of the index adds (modulo 2) to the
/// digits of the coordinate, the most significant digit in bit 0. Computed when the library is compiled.
extern const std::array<std::uint32_t, 32 * kSobolCoordinates> kSobolMatrices;

/// The digits of two successive coordinates of a point, the most significant in bit 0: the reversed binary fractions.
/// `coordinate` (below 255) is the first of the two.
template <class U>
inline std::array<U, 2> sobolDigits(U index, U coordinate) {
  U x(0u), y(0u);
  for (U place = coordinate << 5; any(index != U(0u)); place += U(1u), index = index >> 1) {
    const U added = U(0u) - (index & U(1u));  // all bits, or none
    x ^= gather(kSobolMatrices.data(), place) & added;
    y ^= gather(kSobolMatrices.data(), place + U(32u)) & added;
  }
  return {x, y};
}

/// Owen-scrambled coordinates; the scrambles of different coordinates must be independent random words.
template <class F>
inline Vec2<F> owenSobolFull2D(UintOf<F> index, UintOf<F> coordinate, UintOf<F> seedX, UintOf<F> seedY) {
  const auto digits = sobolDigits(index, coordinate);
  const auto point = reverseBits(owenHash(digits[0], seedX), owenHash(digits[1], seedY));
  return {toUnitFloat<F>(point[0]), toUnitFloat<F>(point[1])};
}

}  // namespace steradian
