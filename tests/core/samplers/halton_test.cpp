#include "steradian/core/samplers/halton.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace steradian {
namespace {

using Word = std::uint32_t;

/// In which of `cells` equal intervals the coordinate lies.
std::size_t cellOf(Word index, Word dimension, Word axis, HaltonKey key, std::uint64_t cells) {
  return static_cast<std::size_t>((haltonBits(index, dimension, axis, key) * cells) >> 32);
}

/// Whether the cells of `count` consecutive points are all different.
bool fillsCells(Word first, std::size_t count, Word dimension, Word axis, HaltonKey key) {
  std::vector<bool> taken(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t cell = cellOf(first + static_cast<Word>(i), dimension, axis, key, count);
    if (taken.at(cell)) return false;
    taken.at(cell) = true;
  }
  return true;
}

HaltonKey keyOf(Word i) { return {mixBits(i + 1u), mixBits(i + 1000u)}; }

TEST(Halton, BasesAreTheFirstPrimes) {
  std::set<Word> bases;
  for (const auto& pair : kHaltonBases) bases.insert(pair.begin(), pair.end());
  EXPECT_EQ(bases.size(), 2 * kPurposeCount);
  EXPECT_EQ(*bases.rbegin(), 71u);
  for (const Word b : bases) {
    for (Word d = 2; d * d <= b; ++d) EXPECT_NE(b % d, 0u) << b;
  }
}

TEST(Halton, AnyConsecutivePointsAreStratifiedInTheBase) {
  for (Word purpose = 0; purpose < kPurposeCount; ++purpose) {
    for (const Word axis : {0u, 1u}) {
      const std::size_t base = kHaltonBases[purpose][axis];
      for (std::size_t count = base; count <= 3000; count *= base) {
        for (const Word first : {0u, 1u, 777u, 4000000000u, 0xffffffffu - 3000u}) {
          EXPECT_TRUE(fillsCells(first, count, purpose, axis, keyOf(first))) << base << ' ' << count << ' ' << first;
        }
      }
    }
  }
}

TEST(Halton, PaddedBlocksAreStratifiedInTheBase) {
  for (Word purpose = 0; purpose < kPurposeCount; ++purpose) {
    for (const Word axis : {0u, 1u}) {
      const Word base = kHaltonBases[purpose][axis];
      for (Word count = base; count <= 3000; count *= base) {
        for (const Word block : {0u, 1u, 5u, 0xffffffffu / count - 1u}) {
          EXPECT_TRUE(fillsCells(block * count, count, 3 * kPurposeCount + purpose, axis, keyOf(block)))
              << base << ' ' << count << ' ' << block;
        }
      }
    }
  }
}

TEST(Halton, TwoBasesAreStratifiedTogether) {
  // Any 2^a 3^b consecutive points: one in each box of 2^-a x 3^-b; so for two coordinates of different purposes.
  struct Axis {
    Word purpose, axis, cells;
  };
  const std::vector<std::pair<Axis, Axis>> pairs{
      {{0, 0, 8}, {0, 1, 9}}, {{0, 0, 2}, {0, 1, 27}}, {{4, 0, 5}, {4, 1, 7}}, {{0, 1, 9}, {4, 0, 25}}};
  for (const auto& [a, b] : pairs) {
    for (const Word first : {0u, 5u, 123456789u}) {
      std::vector<bool> taken(static_cast<std::size_t>(a.cells) * b.cells, false);
      for (Word i = first; i < first + a.cells * b.cells; ++i) {
        const std::size_t box =
            cellOf(i, a.purpose, a.axis, keyOf(1), a.cells) * b.cells + cellOf(i, b.purpose, b.axis, keyOf(2), b.cells);
        EXPECT_FALSE(taken.at(box)) << a.cells << " x " << b.cells;
        taken.at(box) = true;
      }
    }
  }
}

TEST(Halton, ScramblesSendEachPairOfDigitsEverywhere) {
  // Base 5, first digits of indices 0 and 1: the 20 pairs of different digits are equally likely over keys.
  std::vector<int> counts(25, 0);
  constexpr int keys = 20000;
  for (Word k = 0; k < keys; ++k) {
    const Word dimension = static_cast<Word>(Purpose::BsdfDirection);
    ++counts[cellOf(0, dimension, 0, keyOf(k), 5) * 5 + cellOf(1, dimension, 0, keyOf(k), 5)];
  }
  for (std::size_t pair = 0; pair < 25; ++pair) {
    if (pair / 5 == pair % 5) {
      EXPECT_EQ(counts[pair], 0);
    } else {
      EXPECT_NEAR(counts[pair], keys / 20.0, 160);  // five standard deviations
    }
  }
}

TEST(Halton, ScramblesAreNested) {
  // Base 5: the second digit of index 0 and that of index 1 are both 0, but their first digits differ, so they are
  // scrambled independently. In a padded dimension the order of indices 0, 1, ... 4 and that of 5 ... 9 likewise.
  const Word dimension = static_cast<Word>(Purpose::BsdfDirection);
  constexpr int keys = 20000;
  int equal = 0, sameOrder = 0;
  for (Word k = 0; k < keys; ++k) {
    const auto digit = [&](Word index) { return cellOf(index, dimension, 0, keyOf(k), 25) % 5; };
    equal += digit(0) == digit(1) ? 1 : 0;
    const auto padded = [&](Word index) { return cellOf(index, kPurposeCount + dimension, 0, keyOf(k), 5); };
    sameOrder += padded(0) == padded(5) ? 1 : 0;
  }
  EXPECT_NEAR(equal, keys / 5.0, 283);  // five standard deviations
  EXPECT_NEAR(sameOrder, keys / 5.0, 283);
}

TEST(Halton, PaddingUntiesCoordinates) {
  // Coordinates of the same base at two bounces: their first digits are not a function of each other.
  std::set<std::size_t> pairs;
  for (Word i = 0; i < 200; ++i) {
    pairs.insert(cellOf(i, 4, 0, keyOf(1), 5) * 5 + cellOf(i, kPurposeCount + 4, 0, keyOf(2), 5));
  }
  EXPECT_EQ(pairs.size(), 25u);
}

}  // namespace
}  // namespace steradian
