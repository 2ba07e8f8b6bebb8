#pragma once
/// Owen scrambling by hashing: nested uniform scrambling in base 2 without a tree (Laine & Karras 2011; Burley 2020,
/// "Practical hash-based Owen scrambling", JCGT 9(4)).
#include <array>
#include <cstdint>
#include <type_traits>

#include "steradian/core/math/lanes.h"

namespace STERADIAN_API steradian {

/// Two at once: at width 1 they share the swaps of a 64-bit word.
template <class U>
std::array<U, 2> reverseBits(U a, U b) {
  if constexpr (std::is_same_v<U, std::uint32_t>) {
    std::uint64_t x = __builtin_bswap64(a | (std::uint64_t{b} << 32));
    x = ((x >> 4) & 0x0f0f0f0f0f0f0f0full) | ((x & 0x0f0f0f0f0f0f0f0full) << 4);
    x = ((x >> 2) & 0x3333333333333333ull) | ((x & 0x3333333333333333ull) << 2);
    x = ((x >> 1) & 0x5555555555555555ull) | ((x & 0x5555555555555555ull) << 1);
    return {static_cast<std::uint32_t>(x >> 32), static_cast<std::uint32_t>(x)};
  } else {
    return {reverseBits(a), reverseBits(b)};
  }
}

/// A bijection in which each bit is flipped by a hash of `seed` and the bits below it: multiplication by even numbers
/// and addition carry upwards only. Of bit-reversed numbers it is a nested uniform scramble. The constants are those of
/// Vegdahl 2021, "Building a better LK hash" (psychopath.io), which repair the bias of the original ones.
template <class U>
U owenHash(U reversed, U seed) {
  reversed ^= reversed * U(0x3d20adeau);
  reversed += seed;
  reversed *= (seed >> 16) | U(1u);
  reversed ^= reversed * U(0x05526c56u);
  reversed ^= reversed * U(0x53a22864u);
  return reversed;
}

/// Nested uniform scramble of x as a binary fraction: whether two results agree in their first k bits depends only on
/// whether the arguments do. Of an index: every aligned block of 2^k consecutive indices becomes another such block.
template <class U>
U owenScramble(U x, U seed) {
  return reverseBits(owenHash(reverseBits(x), seed));
}

}  // namespace steradian
