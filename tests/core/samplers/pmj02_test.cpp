#include "steradian/core/samplers/pmj02.h"

#include <gtest/gtest.h>

#include <vector>

#include "steradian/core/samplers/sobol.h"
#include "steradian/tests/support/nets.h"

namespace steradian {
namespace {

using Word = std::uint32_t;
using test::isNet;

std::vector<Vec2f> block(std::size_t first, std::size_t count) {
  std::vector<Vec2f> points;
  for (std::size_t i = first; i < first + count; ++i) {
    points.push_back({toUnitFloat<float>(kPmj02Points[2 * i]), toUnitFloat<float>(kPmj02Points[2 * i + 1])});
  }
  return points;
}

TEST(Pmj02, AllAlignedBlocksOfTheTableAreNets) {
  for (std::size_t count = 1; count <= 1u << kPmj02Bits; count *= 2) {
    for (std::size_t first = 0; first < 1u << kPmj02Bits; first += count) EXPECT_TRUE(isNet(block(first, count)));
  }
}

TEST(Pmj02, ThePointsAreJittered) {
  // Within its box of the finest subdivision each point is at random: Sobol's points, scrambled or not, are not in
  // the middle of anything, but those of a table of 12 digits would be.
  double sum = 0.0, squares = 0.0;
  for (const Word x : kPmj02Points) {
    const double rest = (x & 0xfffffu) * 0x1p-20;
    sum += rest;
    squares += rest * rest;
  }
  EXPECT_NEAR(sum / 8192, 0.5, 5 * 0.289 / 90);
  EXPECT_NEAR(squares / 8192, 1.0 / 3.0, 5 * 0.298 / 90);
}

TEST(Pmj02, CopiesAreNetsOfTheWholeTable) {
  for (const Word seed : {1u, 2u, 0xdeadbeefu}) {
    for (const Word count : {1u, 16u, 512u, 1u << kPmj02Bits}) {
      for (const Word first : {0u, (1u << kPmj02Bits) - count}) {
        std::vector<Vec2f> points;
        for (Word i = first; i < first + count; ++i) {
          points.push_back(pmj02<float>(reverseBits(i), mixBits(seed), mixBits(seed + 1), mixBits(seed + 2)));
        }
        EXPECT_TRUE(isNet(points)) << count;
      }
    }
  }
}

}  // namespace
}  // namespace steradian
