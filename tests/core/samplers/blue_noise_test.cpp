#include "steradian/core/samplers/blue_noise.h"

#include <gtest/gtest.h>

#include <map>
#include <vector>

#include "steradian/core/math/morton.h"
#include "steradian/core/samplers/sampler.h"
#include "steradian/tests/support/nets.h"

namespace steradian {
namespace {

using Word = std::uint32_t;
using test::isNet;

TEST(BlueNoise, TheLayoutFillsTheIndex) {
  EXPECT_EQ(BlueNoiseLayout::of(1).sampleBits, 0);
  EXPECT_EQ(BlueNoiseLayout::of(64).sampleBits, 6);
  EXPECT_EQ(BlueNoiseLayout::of(65).sampleBits, 7);
  EXPECT_EQ(BlueNoiseLayout::of(64).pixelBits, 16);
  EXPECT_EQ(BlueNoiseLayout::of(1u << 17).pixelBits, 14);
  EXPECT_EQ(BlueNoiseLayout::of(1u << 24).pixelBits, 8);
}

TEST(BlueNoise, PairingsKeepBlocksTogether) {
  for (const Word count : {1u, 4u, 7u}) {
    const BlueNoiseLayout layout{BlueNoiseLayout::of(count).sampleBits, 8};
    std::vector<bool> taken(std::size_t{1} << (layout.sampleBits + 8), false);
    for (Word i = 0; i < taken.size(); ++i) {
      const Word image = shufflePairings(i, layout, 12345u);
      EXPECT_FALSE(taken.at(image));
      taken.at(image) = true;
      for (int level = 0; level <= 4; ++level) {
        const int shift = layout.sampleBits + 2 * level;
        EXPECT_EQ(image >> shift, shufflePairings(i & ~((1u << shift) - 1u), layout, 12345u) >> shift);
      }
      EXPECT_EQ((image ^ i) & ((1u << layout.sampleBits) - 1u), 0u);
    }
  }
}

TEST(BlueNoise, AllOrdersOfQuadrantsAreEquallyLikely) {
  const BlueNoiseLayout layout{0, 2};
  std::map<Word, int> orders;
  constexpr int trials = 24000;
  for (Word k = 0; k < trials; ++k) {
    Word order = 0;
    for (Word quadrant = 0; quadrant < 4; ++quadrant) {
      const Word paired = shufflePairings(quadrant, layout, mixBits(k + 1u));
      order = order * 4 + (owenScramble(paired << 30, mixBits(~k)) >> 30);
    }
    ++orders[order];
  }
  EXPECT_EQ(orders.size(), 24u);
  for (const auto& [order, count] : orders)
    EXPECT_NEAR(count, trials / 24.0, 155) << order;  // five standard deviations
}

TEST(BlueNoise, PixelsAndSquaresOfPixelsAreNets) {
  constexpr Word samples = 16;
  for (const Word dimension : {0u, 4u, 300u}) {
    for (Word side = 1; side <= 8; side *= 2) {
      for (const Word corner : {0u, 8u, 248u, 65528u}) {
        std::vector<Vec2f> points;
        for (Word i = 0; i < samples * side * side; ++i) {
          const Word pixel = i / samples;
          const Word key = mortonOf(corner + pixel % side, corner + pixel / side);
          points.push_back(
              Sampler<float>({SamplerType::BlueNoise, 3u, samples, 1u}, key, i % samples).get2D(dimension));
        }
        EXPECT_TRUE(isNet(points)) << side << " x " << side << " pixels at " << corner;
      }
    }
  }
}

}  // namespace
}  // namespace steradian
