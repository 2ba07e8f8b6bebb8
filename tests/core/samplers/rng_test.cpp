#include "steradian/core/samplers/rng.h"

#include <gtest/gtest.h>

#include <bit>
#include <set>

namespace steradian {
namespace {

using Word = std::uint32_t;

TEST(Rng, UnitFloatsAreBelowOne) {
  EXPECT_EQ(toUnitFloat<float>(0u), 0.0f);
  EXPECT_EQ(toUnitFloat<float>(0xffffffffu), kOneMinusEpsilon);
  EXPECT_EQ(toUnitFloat<float>(0x80000000u), 0.5f);
}

TEST(Rng, WordsArePublishedPcg4d) {
  // By hand from the definition in the paper, for the key (0, 0, 0, 0): every word becomes the increment c, then
  // x = c + c^2, y = c + c x, z = c + x y, w = c + y z, each folded by its upper half, and once more.
  const Word c = 1013904223u;
  Word x = c + c * c, y = c + c * x, z = c + x * y, w = c + y * z;
  for (Word* v : {&x, &y, &z, &w}) *v ^= *v >> 16;
  x += y * w;
  y += z * x;
  z += x * y;
  w += y * z;
  EXPECT_EQ(randomWords(0u, 0u, 0u, 0u), (std::array<Word, 4>{x, y, z, w}));
}

TEST(Rng, EveryKeyBitReachesEveryWord) {
  // Each output bit flips for about half of the keys when one input bit does.
  for (int bit = 0; bit < 128; ++bit) {
    std::array<int, 4> flips{};
    for (Word trial = 0; trial < 64; ++trial) {
      std::array<Word, 4> key = randomWords(trial, 1u, 2u, 3u);
      const auto before = randomWords(key[0], key[1], key[2], key[3]);
      key[static_cast<std::size_t>(bit / 32)] ^= 1u << (bit % 32);
      const auto after = randomWords(key[0], key[1], key[2], key[3]);
      for (std::size_t i = 0; i < 4; ++i) flips[i] += std::popcount((before[i] ^ after[i]) >> 8);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      // 64 x 24 bits; the standard deviation is 20, and the highest key bits only move the highest bits.
      EXPECT_GT(flips[i], 64) << "bit " << bit << " word " << i;
      EXPECT_LT(flips[i], 64 * 24 - 64);
    }
  }
}

TEST(Rng, LanesAgreeWithScalars) {
  using U = UintOf<Lanes<8>>;
  U a(0u), b(0u);
  for (int i = 0; i < 8; ++i) {
    setLane(a, i, static_cast<Word>(i * 77));
    setLane(b, i, 0xfffffff0u + static_cast<Word>(i));
  }
  const auto words = randomWords(a, b, U(5u), a);
  const auto mixed = mixBits(b);
  const auto unit = toUnitFloat<Lanes<8>>(words[0]);
  for (int i = 0; i < 8; ++i) {
    const auto scalar = randomWords(lane(a, i), lane(b, i), 5u, lane(a, i));
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(lane(words[k], i), scalar[k]);
    EXPECT_EQ(lane(mixed, i), mixBits(lane(b, i)));
    EXPECT_EQ(lane(unit, i), toUnitFloat<float>(scalar[0]));
  }
}

TEST(Rng, MixBitsHasNoCollisions) {
  std::set<Word> seen;
  for (Word i = 0; i < 20000; ++i) seen.insert(mixBits(i * 0x10001u));
  EXPECT_EQ(seen.size(), 20000u);
}

TEST(Rng, StreamsAreReproducibleAndDiffer) {
  RandomStream a(1, 2, 3, 4), same(1, 2, 3, 4);
  std::array<RandomStream, 4> others{RandomStream(2, 2, 3, 4), RandomStream(1, 3, 3, 4), RandomStream(1, 2, 4, 4),
                                     RandomStream(1, 2, 3, 5)};
  std::array<int, 4> equal{};
  std::set<float> seen;
  double sum = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const float x = a.next();
    seen.insert(x);
    EXPECT_EQ(x, same.next());
    EXPECT_TRUE(x >= 0.0f && x < 1.0f);
    sum += x;
    for (std::size_t k = 0; k < 4; ++k) equal[k] += others[k].next() == x;
  }
  EXPECT_GE(seen.size(), 998u) << "of 2^24 numbers";
  EXPECT_NEAR(sum / 1000.0, 0.5, 0.04);
  for (const int count : equal) EXPECT_LE(count, 1);
}

}  // namespace
}  // namespace steradian
