#include "steradian/core/lanes_bits.h"

#include <gtest/gtest.h>

namespace steradian::test {
namespace {

template <int N>
void expectBits(std::uint32_t pattern) {
  Mask<N> mask;
  for (int i = 0; i < N; ++i) mask.set(i, (pattern >> i & 1u) != 0);
  EXPECT_EQ(laneBits(mask), pattern & ((1u << N) - 1u));
}

TEST(LaneBits, AreTheLanesInOrder) {
  for (const std::uint32_t pattern : {0u, 1u, 0x8000u, 0xa5c3u, 0xffffu, 0x0080u}) {
    expectBits<4>(pattern);
    expectBits<8>(pattern);
    expectBits<16>(pattern);
  }
}

}  // namespace
}  // namespace steradian::test
