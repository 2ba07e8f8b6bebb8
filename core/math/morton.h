#pragma once
/// The Z curve (Morton 1966): numbers for the pixels of a picture in which aligned squares of 2^k x 2^k pixels are
/// aligned blocks of 4^k numbers.
#include <cstdint>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// The lower 16 bits, moved to the even places.
constexpr std::uint32_t spreadBits(std::uint32_t x) {
  x &= 0x0000ffffu;
  x = (x | (x << 8)) & 0x00ff00ffu;
  x = (x | (x << 4)) & 0x0f0f0f0fu;
  x = (x | (x << 2)) & 0x33333333u;
  return (x | (x << 1)) & 0x55555555u;
}

/// The bits in the even places, moved together: the inverse of spreadBits.
constexpr std::uint32_t gatherBits(std::uint32_t x) {
  x &= 0x55555555u;
  x = (x | (x >> 1)) & 0x33333333u;
  x = (x | (x >> 2)) & 0x0f0f0f0fu;
  x = (x | (x >> 4)) & 0x00ff00ffu;
  return (x | (x >> 8)) & 0x0000ffffu;
}

/// The number of pixel (x, y), of which the lower 16 bits count: the bits of x in the even places, those of y in the
/// odd ones.
constexpr std::uint32_t mortonOf(std::uint32_t x, std::uint32_t y) { return spreadBits(x) | (spreadBits(y) << 1); }

}  // namespace steradian
