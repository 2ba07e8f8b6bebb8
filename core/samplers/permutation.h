#pragma once
/// Keyed permutations of 0 ... count-1 without a table, after Kensler 2013, "Correlated multi-jittered sampling" (Pixar
/// TM 13-01): a bijection of the next power of two, repeated until the value is in range.
#include <array>
#include <bit>
#include <cstdint>

#include "steradian/core/math/lanes.h"

namespace STERADIAN_API steradian {

/// The image of `index` < count under the permutation that the four random words of `key` choose; count >= 1. Eight
/// rounds of an invertible mixing on as many bits as count - 1 has, less than twice on average: after four rounds, the
/// images of two indices would not yet be independent.
template <class U>
U permute(U index, std::uint32_t count, const std::array<U, 4>& key) {
  const int bits = static_cast<int>(std::bit_width(count - 1u));
  if (bits == 0) return U(0u);
  const U mask((1u << (bits - 1) << 1) - 1u);
  const int shift = (bits + 1) / 2;
  const auto mixed = [&](U x) {
    for (const int part : {0, 16}) {
      for (const U& k : key) {
        // Each step is invertible modulo 2^bits: xor, multiplying by an odd number, adding, xor with what lies above.
        x = ((x ^ (k >> (part + 8))) * ((k >> (part + 3)) | U(1u)) + (k >> part)) & mask;
        x ^= x >> shift;
      }
    }
    return x;
  };
  U result = mixed(index);
  // Follow the cycle until it is back in range: that too is a bijection.
  for (auto outside = result > U(count - 1u); any(outside); outside = result > U(count - 1u)) {
    result = select(outside, mixed(result), result);
  }
  return result;
}

}  // namespace steradian
