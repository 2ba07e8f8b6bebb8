#pragma once
/// Elementary-interval tests of point sets in base 2 (Niederreiter 1992, chapter 4).
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "steradian/core/vec.h"

namespace steradian::test {

/// Whether 2^m points are a (0,m,2)-net: for every split m = a + b each of the 2^a x 2^b boxes holds exactly one.
inline bool isNet(std::span<const Vec2f> points) {
  const int m = std::countr_zero(points.size());
  for (int a = 0; a <= m; ++a) {
    std::vector<bool> taken(points.size(), false);
    const auto columns = static_cast<float>(1 << a), rows = static_cast<float>(1 << (m - a));
    for (const Vec2f p : points) {
      const auto box =
          static_cast<std::size_t>(p.y * rows) * (std::size_t{1} << a) + static_cast<std::size_t>(p.x * columns);
      if (taken[box]) return false;
      taken[box] = true;
    }
  }
  return true;
}

/// Whether each of the n intervals of length 1/n holds exactly one of the n numbers.
inline bool isStratified(std::span<const float> numbers) {
  std::vector<bool> taken(numbers.size(), false);
  for (const float x : numbers) {
    const auto interval = static_cast<std::size_t>(x * static_cast<float>(numbers.size()));
    if (taken[interval]) return false;
    taken[interval] = true;
  }
  return true;
}

}  // namespace steradian::test
