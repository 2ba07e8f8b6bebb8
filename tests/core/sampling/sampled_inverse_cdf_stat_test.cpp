#include "steradian/core/sampling/sampled_inverse_cdf.h"

#include <gtest/gtest.h>

#include "steradian/tests/support/proof.h"

namespace steradian {
namespace {

using namespace test;

/// Places of many numbers, a third of them without weight; `kind` 0 is a single one.
std::vector<WeightedPlace> randomPlaces(std::uint32_t kind) {
  const std::uint32_t count = kind == 0 ? 1 : 1 + mixBits(kind) % 500;
  std::vector<WeightedPlace> places;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto words = randomWords(kind, i, 8u, 9u);
    const float w = toUnitFloat<float>(words[1]);
    places.push_back({-1.0f + 3.0f * toUnitFloat<float>(words[0]), words[2] % 3 == 0 ? 0.0f : w * w});
  }
  return places;
}

TEST(SampledInverseCdfStatistics, RandomSamples) {
  for (std::uint32_t kind = 0; kind < 6; ++kind) {
    CheckOptions options;
    options.samples = 100000;
    options.domain = {-1.0, 2.0, 0.0, 1.0};
    options.edgeShare = 1e-3;  // samples on the edge of a bin
    options.inverseTolerance = 1e-5;
    EXPECT_TRUE(prove(SampledInverseCdf(randomPlaces(kind), -1.0f, 2.0f, static_cast<int>(kind)), options)) << kind;
  }
}

TEST(SampledInverseCdfStatistics, ConvergesToTheDensity) {
  // With 2^16 uniform samples of the book's density, 2^8 bins: what is drawn has its cumulative distribution.
  std::vector<WeightedPlace> places;
  const auto density = [](float x) { return exponential(-x * kInvTwoPi) * sqr(sinCos(x).sin); };
  for (std::uint32_t i = 0; i < 65536; ++i) {
    const float x = kTwoPi * toUnitFloat<float>(randomWords(i, 1u, 2u, 3u)[0]);
    places.push_back({x, density(x)});
  }
  const SampledInverseCdf d(places, 0.0f, kTwoPi);
  const auto f = [&](double x) { return static_cast<double>(density(static_cast<float>(x))); };
  const double whole = integrate(f, 0.0, 6.28318530717958648);
  for (std::size_t i = 16; i < 256; i += 16) {
    const double share = integrate(f, 0.0, static_cast<double>(d.edge(i))) / whole;
    EXPECT_NEAR(share, static_cast<double>(i) / 256.0, 0.01) << i;
  }
}

}  // namespace
}  // namespace steradian
