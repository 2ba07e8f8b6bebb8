#include "steradian/core/samplers/pmj02.h"

#include "steradian/core/samplers/sobol.h"

namespace steradian {
namespace {

/// By the recurrence of Helmer, Christensen & Kensler 2021, "Stochastic generation of (t,s) sample sequences" (EGSR):
/// of the points n ... 2n - 1, n = 2^k, point n + a goes, in each coordinate, into the other half of the interval of
/// length 1/n in which point a ^ c lies, at random within it. c is column k of the coordinate's generator matrix,
/// without the diagonal: here those of the (0,2)-sequence of core/samplers/sobol.h, the unit matrix and Pascal's.
constexpr auto makePoints() {
  std::array<std::uint32_t, 2 << kPmj02Bits> points{mixBits(1u), mixBits(2u)};
  for (std::uint32_t n = 1, k = 0; n < 1u << kPmj02Bits; n *= 2, ++k) {
    const std::array<std::uint32_t, 2> c{0u, pascalTimes(n) ^ n};
    const std::uint32_t half = 0x80000000u >> k;
    for (std::uint32_t a = 0; a < n; ++a) {
      for (std::uint32_t axis = 0; axis < 2; ++axis) {
        const std::uint32_t entry = 2 * (n + a) + axis;
        const std::uint32_t neighbour = points[2 * (a ^ c[axis]) + axis];
        points[entry] = ((neighbour ^ half) & ~(half - 1u)) | (mixBits(entry + 1u) & (half - 1u));
      }
    }
  }
  return points;
}

}  // namespace

constinit const std::array<std::uint32_t, 2 << kPmj02Bits> kPmj02Points = makePoints();

}  // namespace steradian
