#include "steradian/core/samplers/sobol.h"

#include <algorithm>
#include <initializer_list>

namespace steradian {
namespace {

/// The unit matrix, but for these columns.
constexpr SobolShuffle shuffle(std::initializer_list<std::uint32_t> columns) {
  SobolShuffle result{};
  for (std::size_t b = 0; b < result.size(); ++b) result[b] = std::uint32_t{1} << b;
  std::copy(columns.begin(), columns.end(), result.begin());
  return result;
}

}  // namespace

constinit const SobolShuffle kSobolFirst = shuffle({});
constinit const SobolShuffle kSobolSecond = shuffle({0x1, 0x3, 0x4, 0xd, 0x1b, 0x32, 0x57, 0xf1, 0x15e, 0x249, 0x72d,
                                                     0x9f2, 0x178c, 0x35b7, 0x4dc4, 0x803d, 0x1695c, 0x269af});
constinit const SobolShuffle kSobolThird = shuffle({0x1, 0x2, 0x5, 0xa, 0x10, 0x21, 0x74, 0x92, 0x1bd, 0x2b0, 0x7e2,
                                                    0xfd0, 0x129c, 0x293d, 0x529a, 0xef19, 0x1aae7, 0x2d4e6});

}  // namespace steradian
