#include "steradian/core/sampling/weighted_reservoir.h"

#include <gtest/gtest.h>

#include <array>

#include "steradian/tests/support/proof.h"

namespace steradian {
namespace {

using namespace test;

constexpr std::array<float, 9> kWeights{0.3f, 0.0f, 2.0f, 1e-3f, 0.7f, 0.0f, 1.1f, 0.4f, 0.0f};

/// One item of a stream of `kWeights`, whose random numbers come from those of the draw; the stream may be cut in two
/// that are merged.
struct Stream {
  std::size_t cut;

  struct Sample {
    std::uint32_t index;
    float probability;
  };
  Sample sample(float choice, Vec2f u) const {
    WeightedReservoir<float, std::uint32_t> first, second;
    const auto number = [&](std::size_t i) {
      return toUnitFloat<float>(
          randomWords(bitsOf(choice), bitsOf(u.x), bitsOf(u.y), static_cast<std::uint32_t>(i))[0]);
    };
    for (std::size_t i = 0; i < kWeights.size(); ++i) {
      (i < cut ? first : second).add(static_cast<std::uint32_t>(i), kWeights[i], number(i));
    }
    first.merge(second, number(99));
    return {first.item(), first.probability()};
  }
  static std::size_t size() { return kWeights.size(); }
  static float probability(std::size_t i) {
    float total = 0.0f;
    for (const float w : kWeights) total += w;
    return kWeights[i] / total;
  }
};

TEST(WeightedReservoirStatistics, ItemsInProportionToTheirWeights) {
  for (const std::size_t cut : {std::size_t{9}, std::size_t{4}, std::size_t{0}}) {
    EXPECT_TRUE(prove(Stream{cut}, {.inverse = false, .lanes = false})) << cut;
  }
}

}  // namespace
}  // namespace steradian
