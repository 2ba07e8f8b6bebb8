#pragma once
/// The first two dimensions of Sobol's sequence (Sobol' 1967): a (0,2)-sequence in base 2. Every aligned block of 2^m
/// consecutive points has exactly one point in each of the 2^m boxes of every dyadic subdivision of the square, and
/// Owen scrambling keeps that.
#include "steradian/core/owen.h"
#include "steradian/core/rng.h"

namespace steradian {

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

/// A point of a shuffled, scrambled copy of the sequence ("padding": copies for different dimensions are independent).
/// `reversedIndex` is reverseBits of the index, which the caller computes once for all dimensions; `shuffle`, `seedX`
/// and `seedY` are independent random words per copy. The index is shuffled by a nested uniform scramble, which maps
/// aligned blocks of 2^m points to such blocks: prefixes of 2^m points and their aligned parts remain (0,m,2)-nets.
template <class F>
inline Vec2<F> owenSobol2D(UintOf<F> reversedIndex, UintOf<F> shuffle, UintOf<F> seedX, UintOf<F> seedY) {
  const UintOf<F> index = reverseBits(owenHash(reversedIndex, shuffle));
  // The hash wants reversed fractions: those are the digits themselves.
  const auto point = reverseBits(owenHash(index, seedX), owenHash(pascalTimes(index), seedY));
  return {toUnitFloat<F>(point[0]), toUnitFloat<F>(point[1])};
}

/// The first coordinate alone: a shuffled, scrambled van der Corput sequence.
template <class F>
inline F owenSobol1D(UintOf<F> reversedIndex, UintOf<F> shuffle, UintOf<F> seed) {
  const UintOf<F> index = reverseBits(owenHash(reversedIndex, shuffle));
  return toUnitFloat<F>(reverseBits(owenHash(index, seed)));
}

}  // namespace steradian
