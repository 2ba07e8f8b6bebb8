#include "steradian/core/samplers/halton.h"

#include <utility>

#include "steradian/core/samplers/owen.h"

namespace steradian {
namespace {

/// Mixes 64 bits (Stafford 2011, "Better bit mixing", variant 13); a bijection.
constexpr std::uint64_t mix(std::uint64_t x) {
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9u;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// Digits that tell all indices below 2^32 apart.
constexpr std::uint32_t digitsIn(std::uint64_t base) {
  std::uint32_t digits = 0;
  for (std::uint64_t power = 1; power < std::uint64_t{1} << 32; power *= base) ++digits;
  return digits;
}
constexpr std::uint64_t powerOf(std::uint64_t base, std::uint32_t exponent) {
  return exponent == 0 ? 1 : base * powerOf(base, exponent - 1);
}

/// The image of a digit under the affine map that belongs to a node of the tree: its level, and the digits before.
template <std::uint32_t base>
std::uint64_t scrambled(std::uint64_t digit, std::uint64_t before, std::uint32_t level, std::uint64_t seed) {
  const std::uint64_t random = mix(((before << 5) | level) ^ seed);
  const std::uint64_t factor = 1 + (((random >> 32) * (base - 1)) >> 32);
  const std::uint64_t added = ((random & 0xffffffffu) * base) >> 32;
  return (factor * digit + added) % base;
}

/// Nested scramble of the digits from the highest down: aligned blocks of b^k indices become such blocks.
template <std::uint32_t base>
std::uint64_t shuffledIndex(std::uint64_t index, std::uint64_t seed) {
  std::uint64_t result = 0, power = 1;
  for (std::uint32_t level = 0; level < digitsIn(base); ++level) {
    const std::uint64_t digit = index % base;
    index /= base;
    result += scrambled<base>(digit, index, level, seed) * power;
    power *= base;
  }
  return result;
}

/// Nested scramble of the radical inverse, from the lowest digit of the index up.
template <std::uint32_t base>
std::uint32_t scrambledInverse(std::uint64_t index, std::uint64_t seed) {
  std::uint64_t inverse = 0, before = 0, power = 1;
  for (std::uint32_t level = 0; level < digitsIn(base); ++level) {
    const std::uint64_t digit = index % base;
    index /= base;
    inverse = inverse * base + scrambled<base>(digit, before, level, seed);
    before += digit * power;
    power *= base;
  }
  constexpr double scale = 0x1p32 / static_cast<double>(powerOf(base, digitsIn(base)));
  return static_cast<std::uint32_t>(static_cast<double>(inverse) * scale);
}

template <std::uint32_t base>
std::uint32_t coordinate(std::uint32_t index, bool padded, HaltonKey key) {
  if constexpr (base == 2) {
    // The same by hashing, which needs the fraction reversed: that is the index itself.
    const std::uint32_t place = padded ? owenScramble(index, mixBits(key.second)) : index;
    return reverseBits(owenHash(place, mixBits(key.first)));
  } else {
    const std::uint64_t seed = (std::uint64_t{key.first} << 32) | key.second;
    const std::uint64_t place = padded ? shuffledIndex<base>(index, mix(seed)) : index;
    return scrambledInverse<base>(place, seed);
  }
}

using Coordinate = std::uint32_t (*)(std::uint32_t index, bool padded, HaltonKey key);

/// One function for each base, so that all divisions are by constants.
template <std::size_t... i>
constexpr std::array<Coordinate, sizeof...(i)> coordinates(std::index_sequence<i...>) {
  return {&coordinate<kHaltonBases[i / 2][i % 2]>...};
}
constexpr std::array<Coordinate, 2 * kPurposeCount> kCoordinates =
    coordinates(std::make_index_sequence<2 * kPurposeCount>());

}  // namespace

std::uint32_t haltonBits(std::uint32_t index, std::uint32_t dimension, std::uint32_t axis, HaltonKey key) {
  const std::uint32_t bounce = dimension / kPurposeCount, purpose = dimension % kPurposeCount;
  return kCoordinates[2 * purpose + axis](index, bounce > 0, key);
}

}  // namespace steradian
