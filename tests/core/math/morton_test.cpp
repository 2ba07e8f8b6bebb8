#include "steradian/core/math/morton.h"

#include <gtest/gtest.h>

namespace steradian {
namespace {

TEST(Morton, NumbersSquaresInZ) {
  EXPECT_EQ(mortonOf(0, 0), 0u);
  EXPECT_EQ(mortonOf(1, 0), 1u);
  EXPECT_EQ(mortonOf(0, 1), 2u);
  EXPECT_EQ(mortonOf(1, 1), 3u);
  EXPECT_EQ(mortonOf(2, 0), 4u);
  EXPECT_EQ(mortonOf(0xffff, 0), 0x55555555u);
  EXPECT_EQ(mortonOf(0, 0xffff), 0xaaaaaaaau);
  EXPECT_EQ(mortonOf(0x12345, 0x23456), mortonOf(0x2345, 0x3456));
}

TEST(Morton, GatheringIsTheInverseOfSpreading) {
  for (const std::uint32_t x : {0u, 1u, 0x1234u, 0xabcdu, 0xffffu}) {
    EXPECT_EQ(gatherBits(spreadBits(x)), x);
    EXPECT_EQ(gatherBits(spreadBits(x) | 0xaaaaaaaau), x);
  }
}

TEST(Morton, AlignedSquaresAreAlignedBlocks) {
  for (std::uint32_t y = 0; y < 64; ++y) {
    for (std::uint32_t x = 0; x < 64; ++x) {
      for (std::uint32_t k = 0; k < 6; ++k) EXPECT_EQ(mortonOf(x, y) >> (2 * k), mortonOf(x >> k, y >> k));
    }
  }
}

}  // namespace
}  // namespace steradian
