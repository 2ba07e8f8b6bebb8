#pragma once
/// The first two dimensions of Sobol's sequence (Sobol' 1967): a (0,2)-sequence in base 2. Every aligned block of 2^m
/// consecutive points has exactly one point in each of the 2^m boxes of every dyadic subdivision of the square, and
/// Owen scrambling keeps that.
#include <array>
#include <cstdint>

#include "steradian/core/samplers/owen.h"
#include "steradian/core/samplers/rng.h"

namespace STERADIAN_API steradian {

/// The digits of the second dimension, least significant first: the upper Pascal matrix mod 2 times the digits of the
/// index. Pascal's triangle mod 2 is the fivefold Kronecker product of [1 1; 0 1] (Lucas), so the product takes five
/// steps and no table.
template <class U>
constexpr U pascalTimes(U index) {
  index ^= (index >> 1) & U(0x55555555u);
  index ^= (index >> 2) & U(0x33333333u);
  index ^= (index >> 4) & U(0x0f0f0f0fu);
  index ^= (index >> 8) & U(0x00ff00ffu);
  return index ^ ((index >> 16) & U(0x0000ffffu));
}

/// The coordinates of a point without scrambling, as 32-bit binary fractions.
template <class U>
U sobolBitsX(U index) {
  return reverseBits(index);
}
template <class U>
U sobolBitsY(U index) {
  return reverseBits(pascalTimes(index));
}

/// The index in a shuffled copy of the sequence that is independent of others: by a nested uniform scramble, which maps
/// aligned blocks of 2^m points to such blocks.
template <class U>
U shuffledAlone(U reversedIndex, U shuffle) {
  return reverseBits(owenHash(reversedIndex, shuffle));
}

/// A shuffle that makes a copy of the sequence which is stratified together with others: the index times an upper
/// triangular matrix mod 2, of which entry b is what bit b of the index adds. It maps aligned blocks of 2^m points to
/// such blocks, so that the copy's pairs are a (0,2)-sequence as well.
using SobolShuffle = std::array<std::uint32_t, 32>;
template <class U>
U shuffledTogether(U index, const SobolShuffle& shuffle) {
  U result(0u);
  for (std::size_t b = 0; b < shuffle.size() && any(index != U(0u)); b += 4, index = index >> 4) {
    for (int i = 0; i < 4; ++i)
      result ^= (U(0u) - ((index >> i) & U(1u))) & U(shuffle[b + static_cast<std::size_t>(i)]);
  }
  return result;
}

/// Three pairs of coordinates that make, two pairs at a time, (t,m,4)-nets of the first 2^m points: up to m = 11 with t
/// at most 3 (first and second), 4 (first and third) and 5. Found column by column: of some 600 at random the one with
/// the least t of all four coordinates, of three, and of two of different pairs; then by the error of renders. (The
/// first four of Joe and Kuo's coordinates have t = 3, but their second pair is no (0,2)-sequence by itself.)
extern const SobolShuffle kSobolFirst, kSobolSecond, kSobolThird;

/// The point of this index, scrambled.
template <class F>
inline Vec2<F> owenSobol2D(UintOf<F> index, UintOf<F> seedX, UintOf<F> seedY) {
  // The hash needs reversed fractions: those are the digits themselves.
  const auto point = reverseBits(owenHash(index, seedX), owenHash(pascalTimes(index), seedY));
  return {toUnitFloat<F>(point[0]), toUnitFloat<F>(point[1])};
}

/// A point of a shuffled, scrambled copy of the sequence ("padding": copies for different dimensions are independent).
/// `reversedIndex` is reverseBits of the index, which the caller computes once for all dimensions; `shuffle`, `seedX`
/// and `seedY` are independent random words per copy. The index is shuffled by a nested uniform scramble, which maps
/// aligned blocks of 2^m points to such blocks: prefixes of 2^m points and their aligned parts remain (0,m,2)-nets.
template <class F>
inline Vec2<F> owenSobol2D(UintOf<F> reversedIndex, UintOf<F> shuffle, UintOf<F> seedX, UintOf<F> seedY) {
  return owenSobol2D<F>(shuffledAlone(reversedIndex, shuffle), seedX, seedY);
}

/// The first coordinate alone: a shuffled, scrambled van der Corput sequence.
template <class F>
inline F owenSobol1D(UintOf<F> reversedIndex, UintOf<F> shuffle, UintOf<F> seed) {
  return toUnitFloat<F>(reverseBits(owenHash(shuffledAlone(reversedIndex, shuffle), seed)));
}

}  // namespace steradian
