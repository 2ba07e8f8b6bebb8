#include "steradian/core/samplers/sobol.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "steradian/tests/support/lanes_check.h"
#include "steradian/tests/support/nets.h"

namespace steradian {
namespace {

using Word = std::uint32_t;
using test::isNet;

TEST(Owen, ReversesBits) {
  EXPECT_EQ(reverseBits(1u), 0x80000000u);
  EXPECT_EQ(reverseBits(0x12345678u), 0x1e6a2c48u);
  for (Word i = 0; i < 1000; ++i) {
    const Word x = mixBits(i), y = mixBits(~i);
    Word slow = 0;
    for (int bit = 0; bit < 32; ++bit) slow |= ((x >> bit) & 1u) << (31 - bit);
    EXPECT_EQ(reverseBits(x), slow);
    EXPECT_EQ(reverseBits(x, y), (std::array{reverseBits(x), reverseBits(y)}));
  }
}

TEST(Owen, ScramblesAreNested) {
  // Two results agree in exactly as many leading bits as the arguments do.
  for (Word seed : {0u, 1u, 0xdeadbeefu, 0xffffffffu}) {
    for (Word i = 0; i < 500; ++i) {
      const Word x = mixBits(i);
      for (int shared = 0; shared < 32; ++shared) {
        const Word y = x ^ (0x80000000u >> shared) ^ (mixBits(i + 7u) & ((0x80000000u >> shared) - 1u));
        EXPECT_EQ(std::countl_zero(owenScramble(x, seed) ^ owenScramble(y, seed)), shared);
      }
    }
  }
}

TEST(Owen, EachBitIsFlippedForHalfOfTheSeeds) {
  // In every node of the tree, down to level 12: the flip of a bit given those above it is a fair coin over seeds.
  constexpr int trials = 4096;
  for (const Word x : {0u, 0x12345678u, 0xfff00000u}) {
    for (int bit = 0; bit < 12; ++bit) {
      int flips = 0;
      for (Word trial = 0; trial < trials; ++trial) {
        flips += ((owenScramble(x, mixBits(trial ^ 0x5bd1e995u)) ^ x) >> (31 - bit)) & 1u;
      }
      EXPECT_NEAR(flips, trials / 2.0, 5 * 32) << "bit " << bit << " of " << x;  // five standard deviations
    }
  }
}

TEST(Sobol, BeginsLikeThePublishedSequence) {
  // Sobol' in natural (not Gray code) order, the first two dimensions of every published table, in sixteenths.
  constexpr std::array<Word, 8> x{0, 8, 4, 12, 2, 10, 6, 14}, y{0, 8, 12, 4, 10, 2, 6, 14};
  for (Word i = 0; i < 8; ++i) {
    EXPECT_EQ(sobolBitsX(i), x[i] << 28) << i;
    EXPECT_EQ(sobolBitsY(i), y[i] << 28) << i;
  }
}

TEST(Sobol, PascalMatrixIsBinomialsModTwo) {
  for (int column = 0; column < 32; ++column) {
    const Word image = pascalTimes(1u << column);
    for (int row = 0; row < 32; ++row) {
      // Lucas: C(column, row) is odd if row has only digits that column has.
      EXPECT_EQ((image >> row) & 1u, (row & ~column) == 0 ? 1u : 0u) << row << ' ' << column;
    }
  }
}

TEST(Sobol, ScrambledBlocksAreNets) {
  for (Word seed = 0; seed < 4; ++seed) {
    const auto key = randomWords(seed, 1u, 2u, 3u);
    for (int m = 0; m <= 10; ++m) {
      // The first block, one somewhere, and one far out.
      for (const Word block : {0u, 5u, 100003u}) {
        std::vector<Vec2f> points;
        for (Word i = 0; i < (1u << m); ++i) {
          points.push_back(owenSobol2D<float>(reverseBits((block << m) + i), key[0], key[1], key[2]));
        }
        EXPECT_TRUE(isNet(points)) << "m " << m << " block " << block;
      }
    }
  }
}

TEST(Sobol, ShufflesMapBlocksToBlocks) {
  for (const SobolShuffle& shuffle : {kSobolFirst, kSobolSecond, kSobolThird}) {
    for (int b = 0; b < 32; ++b) {
      const Word column = shuffle[static_cast<std::size_t>(b)];
      EXPECT_EQ(std::bit_width(column), b + 1);
      EXPECT_EQ(shuffledTogether(1u << b, shuffle), column);
    }
    EXPECT_EQ(shuffledTogether(0x80402011u, shuffle),
              shuffle[31] ^ shuffle[22] ^ shuffle[13] ^ shuffle[4] ^ shuffle[0]);
  }
  EXPECT_EQ(shuffledTogether(0x12345678u, kSobolFirst), 0x12345678u);
}

int leastT(const SobolShuffle& a, const SobolShuffle& b, int m) {
  std::vector<std::array<float, 4>> points;
  for (Word i = 0; i < (1u << m); ++i) {
    const Vec2f p = owenSobol2D<float>(shuffledTogether(i, a), 1u, 2u);
    const Vec2f q = owenSobol2D<float>(shuffledTogether(i, b), 3u, 4u);
    points.push_back({p.x, p.y, q.x, q.y});
  }
  return test::leastT(points);
}

TEST(Sobol, PairsTogetherAreNetsOfFourCoordinates) {
  for (int m = 0; m <= 11; ++m) {
    EXPECT_LE(leastT(kSobolFirst, kSobolSecond, m), 3) << m;
    EXPECT_LE(leastT(kSobolFirst, kSobolThird, m), 4) << m;
    EXPECT_LE(leastT(kSobolSecond, kSobolThird, m), 5) << m;
  }
  EXPECT_EQ(leastT(kSobolSecond, kSobolSecond, 8), 7);  // a pair and itself: nothing but halves
}

TEST(Sobol, CoordinatesAreScrambledIndependently) {
  // Of one point over random seeds, each digit of y is that of x half of the time.
  constexpr int trials = 4096;
  for (const Word index : {0u, 1u, 77u}) {
    for (int bit = 0; bit < 12; ++bit) {
      int equal = 0;
      for (Word trial = 0; trial < trials; ++trial) {
        const auto seeds = randomWords(trial, index, 4u, 5u);
        const Vec2f p = owenSobol2D<float>(reverseBits(index), 6u, seeds[0], seeds[1]);
        const auto digit = [&](float x) { return static_cast<int>(x * static_cast<float>(2 << bit)) & 1; };
        equal += digit(p.x) == digit(p.y);
      }
      EXPECT_NEAR(equal, trials / 2.0, 5 * 32) << "bit " << bit << " of " << index;  // five standard deviations
    }
  }
}

TEST(Sobol, TheNetTestRejectsOthers) {
  std::vector<Vec2f> points;
  for (Word i = 0; i < 64; ++i) points.push_back(owenSobol2D<float>(reverseBits(i), 1u, 2u, 3u));
  EXPECT_TRUE(isNet(points));
  std::vector<Vec2f> moved = points;
  moved[17].x = moved[17].x < 0.5f ? moved[17].x + 0.5f : moved[17].x - 0.5f;
  EXPECT_FALSE(isNet(moved));
  // The shuffle may not mix blocks.
  std::swap(points[3], points[40]);
  points.resize(32);
  EXPECT_FALSE(isNet(points));
}

TEST(Sobol, LanesAgreeWithScalars) {
  using F = Lanes<8>;
  UintOf<F> index(0u), a(0u), b(0u), c(0u);
  for (int i = 0; i < 8; ++i) {
    const auto words = randomWords(static_cast<Word>(i), 7u, 8u, 9u);
    setLane(index, i, words[3]);
    setLane(a, i, words[0]);
    setLane(b, i, words[1]);
    setLane(c, i, words[2]);
  }
  const auto wide = owenSobol2D<F>(index, a, b, c);
  const auto wide1 = owenSobol1D<F>(index, a, b);
  const auto reversed = reverseBits(index);
  for (int i = 0; i < 8; ++i) {
    EXPECT_TRUE(test::sameBits(lane(wide, i), owenSobol2D<float>(lane(index, i), lane(a, i), lane(b, i), lane(c, i))));
    EXPECT_EQ(lane(wide1, i), owenSobol1D<float>(lane(index, i), lane(a, i), lane(b, i)));
    EXPECT_EQ(lane(reversed, i), reverseBits(lane(index, i)));
    EXPECT_EQ(lane(sobolBitsY(index), i), sobolBitsY(lane(index, i)));
  }
}

}  // namespace
}  // namespace steradian
