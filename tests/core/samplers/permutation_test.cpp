#include "steradian/core/samplers/permutation.h"

#include <gtest/gtest.h>

#include <vector>

#include "steradian/core/samplers/rng.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using Word = std::uint32_t;

TEST(Permutation, IsABijection) {
  for (Word count : {1u, 2u, 3u, 4u, 5u, 7u, 16u, 17u, 100u, 255u, 256u, 257u, 1000u}) {
    for (Word seed = 0; seed < 20; ++seed) {
      std::vector<bool> seen(count, false);
      for (Word i = 0; i < count; ++i) {
        const Word image = permute(i, count, randomWords(seed, count, 0u, 0u));
        ASSERT_LT(image, count);
        EXPECT_FALSE(seen[image]) << count;
        seen[image] = true;
      }
    }
  }
}

TEST(Permutation, EveryPairOfImagesIsAsLikely) {
  // Over random keys, all pairs of different numbers are equally likely as images of two indices.
  for (const Word count : {2u, 3u, 4u, 6u, 9u, 16u}) {
    for (const Word other : {1u, count - 1u}) {
      std::vector<double> pairs(count * count, 0.0), expected(count * count, 0.0);
      constexpr Word keys = 40000;
      for (Word k = 0; k < keys; ++k) {
        const auto key = randomWords(k, count, 11u, 5u);
        pairs[permute(0u, count, key) * count + permute(other, count, key)] += 1.0;
      }
      for (Word i = 0; i < count; ++i) {
        for (Word j = 0; j < count; ++j) expected[i * count + j] = i == j ? 0.0 : keys / (count * (count - 1.0));
      }
      EXPECT_GT(test::chiSquareTest(pairs, expected).pValue, test::suiteLevel()) << count << ' ' << other;
    }
  }
}

TEST(Permutation, LanesAgreeWithScalars) {
  using U = UintOf<Lanes<8>>;
  for (const Word count : {1u, 5u, 64u, 1000u}) {
    std::array<U, 4> keys;
    U index(0u);
    for (int i = 0; i < 8; ++i) {
      const auto key = randomWords(static_cast<Word>(i), count, 1u, 1u);
      for (std::size_t k = 0; k < 4; ++k) setLane(keys[k], i, key[k]);
      setLane(index, i, key[3] % count);
    }
    const U images = permute(index, count, keys);
    for (int i = 0; i < 8; ++i) {
      EXPECT_EQ(lane(images, i), permute(lane(index, i), count, randomWords(static_cast<Word>(i), count, 1u, 1u)));
    }
  }
}

}  // namespace
}  // namespace steradian
