#pragma once
/// Progressive multi-jittered (0,2) samples (Christensen, Kensler & Kilpatrick 2018, "Progressive multi-jittered sample
/// sequences"): every prefix of 2^m points, and every aligned block of 2^m, is stratified in all boxes of area 2^-m.
/// A finite table of them, which pixels and dimensions share: each takes it in an order of its own and shifted.
#include <array>
#include <cstdint>

#include "steradian/core/samplers/owen.h"
#include "steradian/core/samplers/rng.h"

namespace STERADIAN_API steradian {

/// The table has 2^12 points, and is 32 KiB: the sequence ends there.
inline constexpr int kPmj02Bits = 12;

/// x and y of point i are entries 2 i and 2 i + 1, as 32-bit binary fractions. Made when the library is compiled.
extern const std::array<std::uint32_t, 2 << kPmj02Bits> kPmj02Points;

/// A point of a shuffled, shifted copy of the table. `reversedIndex` is reverseBits of the index, of which the lower
/// kPmj02Bits count; `shuffle`, `shiftX` and `shiftY` are independent random words per copy. The index is shuffled by
/// a nested uniform scramble, which keeps aligned blocks together (xor with a random number would pair the same parts
/// of two dimensions, and is worse than random numbers in pictures); the digital shift of the points keeps the boxes.
template <class F>
inline Vec2<F> pmj02(UintOf<F> reversedIndex, UintOf<F> shuffle, UintOf<F> shiftX, UintOf<F> shiftY) {
  const UintOf<F> index = reverseBits(owenHash(reversedIndex, shuffle)) & UintOf<F>((1u << kPmj02Bits) - 1u);
  const UintOf<F> place = index << 1;
  return {toUnitFloat<F>(gather(kPmj02Points.data(), place) ^ shiftX),
          toUnitFloat<F>(gather(kPmj02Points.data() + 1, place) ^ shiftY)};
}

}  // namespace steradian
