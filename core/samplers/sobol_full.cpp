#include "steradian/core/samplers/sobol_full.h"

#include "steradian/core/samplers/sobol_directions.h"

namespace steradian {
namespace {

constexpr auto makeMatrices() {
  std::array<std::uint32_t, 32 * kSobolCoordinates> matrices{};
  // The first coordinate is van der Corput's: the unit matrix.
  for (std::size_t b = 0; b < 32; ++b) matrices[b] = 1u << b;
  for (std::size_t c = 1; c < kSobolCoordinates; ++c) {
    const std::array<std::uint32_t, 32> columns = directionNumbers(kSobolDirections[c - 1]);
    for (std::size_t b = 0; b < 32; ++b) matrices[32 * c + b] = reverseBits(columns[b]);
  }
  return matrices;
}

}  // namespace

constinit const std::array<std::uint32_t, 32 * kSobolCoordinates> kSobolMatrices = makeMatrices();

}  // namespace steradian
