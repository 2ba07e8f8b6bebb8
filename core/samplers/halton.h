#pragma once
/// Halton's sequence (Halton 1960): the digits of the index in a prime base, mirrored at the point; another prime for
/// each coordinate. Any b^k consecutive points, wherever they begin, are stratified in the b^k intervals of a
/// coordinate of base b. Scrambled digit by digit after Owen 1995, with the affine maps a d + c modulo b of Matousek
/// 1998 in place of all permutations: they map each pair of different digits to all such pairs equally often, and the
/// variance depends on no more than that.
///
/// A base far above the number of samples gains nothing, so each purpose has two bases, the smallest for those that
/// matter most, and every bounce uses the same ones. Later bounces are padded: the index is shuffled in the base of the
/// coordinate, so that coordinates of different bounces, and those of a later bounce among themselves, are independent.
/// At bounce 0 all coordinates are stratified together.
#include <array>
#include <cstdint>

#include "steradian/core/samplers/rng.h"
#include "steradian/core/samplers/sample_dimension.h"

namespace STERADIAN_API steradian {

/// The bases of the two coordinates of each purpose, in its order.
inline constexpr std::array<std::array<std::uint32_t, 2>, kPurposeCount> kHaltonBases{{
    {2, 3},    // Film
    {23, 29},  // Lens
    {31, 59},  // Time
    {19, 53},  // BsdfLobe
    {5, 7},    // BsdfDirection
    {17, 47},  // LightSelect
    {11, 13},  // LightPosition
    {37, 61},  // Roulette
    {41, 67},  // TargetSelect
    {43, 71},  // FreeFlight
}};

/// Which sequence a coordinate belongs to: two random words per pixel, dimension and replicate.
struct HaltonKey {
  std::uint32_t first = 0, second = 0;
};

/// Coordinate `axis` (0 or 1) of the dimension (core/samplers/sample_dimension.h), as a binary fraction rounded down to
/// 32 bits.
std::uint32_t haltonBits(std::uint32_t index, std::uint32_t dimension, std::uint32_t axis, HaltonKey key);

/// The same, of each lane by itself: no machine divides vectors of integers.
template <class F>
F halton(UintOf<F> index, UintOf<F> dimension, std::uint32_t axis, UintOf<F> first, UintOf<F> second) {
  UintOf<F> bits(0u);
  for (int i = 0; i < widthOf<F>; ++i) {
    setLane(bits, i, haltonBits(lane(index, i), lane(dimension, i), axis, {lane(first, i), lane(second, i)}));
  }
  return toUnitFloat<F>(bits);
}

}  // namespace steradian
