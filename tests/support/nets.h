#pragma once
/// Elementary-interval tests of point sets in base 2 (Niederreiter 1992, chapter 4).
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "steradian/core/math/vec.h"

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

/// The least t for which these 2^m points of [0, 1)^4 are a (t,m,4)-net: every box of each subdivision into 2^(m-t)
/// equal ones by halving sides holds 2^t of them.
inline int leastT(const std::vector<std::array<float, 4>>& points) {
  const int m = std::countr_zero(points.size());
  const auto isEven = [&](const std::array<int, 4>& halvings, int t) {
    std::vector<int> boxes(points.size() >> t, 0);
    for (const auto& p : points) {
      std::size_t box = 0;
      for (std::size_t d = 0; d < 4; ++d)
        box = (box << halvings[d]) + static_cast<std::size_t>(p[d] * static_cast<float>(1 << halvings[d]));
      ++boxes[box];
    }
    return std::all_of(boxes.begin(), boxes.end(), [&](int n) { return n == 1 << t; });
  };
  const auto isNet = [&](int t) {
    const int all = m - t;
    for (int a = 0; a <= all; ++a) {
      for (int b = 0; a + b <= all; ++b) {
        for (int c = 0; a + b + c <= all; ++c) {
          if (!isEven({a, b, c, all - a - b - c}, t)) return false;
        }
      }
    }
    return true;
  };
  int t = 0;
  while (!isNet(t)) ++t;
  return t;
}

}  // namespace steradian::test
