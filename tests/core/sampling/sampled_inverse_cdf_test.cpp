#include "steradian/core/sampling/sampled_inverse_cdf.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "steradian/core/base/diagnostics.h"
#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using Places = std::vector<WeightedPlace>;

/// The book's samples of exp(-x / 2 pi) sin^2 x on [0, 2 pi]: evenly spread ones.
Places placesOfTheBook(int count) {
  Places places;
  for (int i = 0; i < count; ++i) {
    const float x = kTwoPi * (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    places.push_back({x, std::exp(-x / kTwoPi) * std::sin(x) * std::sin(x)});
  }
  return places;
}

TEST(SampledInverseCdf, TheBooksHalfwayPoint) {
  // Exact: 2.0384 by quadrature; the book's run printed 2.016.
  const SampledInverseCdf d(placesOfTheBook(20000), 0.0f, kTwoPi);
  EXPECT_NEAR(d.halfway(), 2.0384f, 2e-4f);
  EXPECT_EQ(d.size(), 256u);
  EXPECT_EQ(d.edge(128), d.halfway());
  EXPECT_EQ(d.sample(0.5f).x, d.halfway());
}

TEST(SampledInverseCdf, ADepthOfOneIsTheBooksTwoPieces) {
  // x / 2 on [0, 2] splits at sqrt 2.
  Places places;
  for (int i = 0; i < 4000; ++i) places.push_back({2.0f * (static_cast<float>(i) + 0.5f) / 4000.0f, 0.0f});
  for (WeightedPlace& p : places) p.weight = p.x;
  const SampledInverseCdf d(places, 0.0f, 2.0f, 1);
  EXPECT_NEAR(d.halfway(), std::sqrt(2.0f), 1e-3f);
  EXPECT_FLOAT_EQ(d.pdf(1.0f), 0.5f / d.halfway());
  EXPECT_FLOAT_EQ(d.pdf(1.9f), 0.5f / (2.0f - d.halfway()));
  EXPECT_EQ(d.pdf(-0.1f), 0.0f);
  EXPECT_EQ(d.pdf(2.1f), 0.0f);
  EXPECT_EQ(d.pdf(std::numeric_limits<float>::quiet_NaN()), 0.0f);
}

TEST(SampledInverseCdf, DrawsOfTheDistributionItselfWeighTheSame) {
  // Draws of x / 2: the quantiles are those of the density.
  Places draws;
  for (const float u : test::unitNumbers(20000)) draws.push_back({2.0f * std::sqrt(u), 1.0f});
  const SampledInverseCdf d(draws, 0.0f, 2.0f, 3);
  for (std::size_t i = 1; i < 8; ++i) {
    EXPECT_NEAR(d.edge(i), 2.0f * std::sqrt(static_cast<float>(i) / 8.0f), 0.03f) << i;
  }
}

TEST(SampledInverseCdf, OrderDoesNotMatterAndEqualPlacesCountTogether) {
  Places places = placesOfTheBook(100), reversed(places.rbegin(), places.rend());
  const SampledInverseCdf a(places, 0.0f, kTwoPi, 5), b(reversed, 0.0f, kTwoPi, 5);
  for (std::size_t i = 0; i <= 32; ++i) EXPECT_EQ(a.edge(i), b.edge(i));
  const SampledInverseCdf twice(Places{{1.0f, 1.0f}, {3.0f, 2.0f}, {1.0f, 1.0f}}, 0.0f, 4.0f, 4);
  const SampledInverseCdf once(Places{{3.0f, 2.0f}, {1.0f, 2.0f}}, 0.0f, 4.0f, 4);
  for (std::size_t i = 0; i <= 16; ++i) EXPECT_EQ(twice.edge(i), once.edge(i));
}

TEST(SampledInverseCdf, EdgeCases) {
  // One place: half of the probability on each side. One bin, or no weight at all: uniform.
  const SampledInverseCdf one(Places{{0.25f, 7.0f}}, 0.0f, 1.0f, 4);
  EXPECT_EQ(one.halfway(), 0.25f);
  EXPECT_FLOAT_EQ(one.pdf(0.1f), 2.0f);
  EXPECT_FLOAT_EQ(one.pdf(0.9f), 0.5f / 0.75f);
  EXPECT_FLOAT_EQ(SampledInverseCdf(Places{{0.25f, 7.0f}}, 0.0f, 4.0f, 0).pdf(3.0f), 0.25f);
  const SampledInverseCdf none(Places{{0.1f, 0.0f}, {0.2f, 0.0f}}, 0.0f, 1.0f, 6);
  for (const float x : {0.01f, 0.15f, 0.9f}) EXPECT_FLOAT_EQ(none.pdf(x), 1.0f);
  // At the ends.
  const SampledInverseCdf ends(Places{{0.0f, 1.0f}, {1.0f, 3.0f}}, 0.0f, 1.0f, 3);
  EXPECT_FLOAT_EQ(ends.pdf(0.5f), 1.0f);
  // All on one float: bins of one step each, of positive width and finite density.
  const SampledInverseCdf spike(Places{{0.5f, 1.0f}, {0.5f, 1.0f}, {0.50000006f, 1e6f}}, 0.0f, 1.0f, 8);
  for (std::size_t i = 0; i < 256; ++i) EXPECT_LT(spike.edge(i), spike.edge(i + 1));
  for (const float u : test::unitNumbers(300)) {
    const auto s = spike.sample(u);
    EXPECT_TRUE(s.x >= 0.0f && s.x <= 1.0f && s.pdf > 0.0f && isFinite(s.pdf)) << u;
  }
  // Pressed against the end of the interval.
  const SampledInverseCdf late(Places{{0.0f, 1e-6f}, {0.99999994f, 1e6f}}, 0.0f, 1.0f, 8);
  for (std::size_t i = 0; i < 256; ++i) EXPECT_LT(late.edge(i), late.edge(i + 1));
}

TEST(SampledInverseCdf, RejectsBadInput) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const Places good{{0.5f, 1.0f}};
  EXPECT_THROW(SampledInverseCdf(Places{}, 0.0f, 1.0f), Error);
  EXPECT_THROW(SampledInverseCdf(Places{{2.0f, 1.0f}}, 0.0f, 1.0f), Error);
  EXPECT_THROW(SampledInverseCdf(Places{{nan, 1.0f}}, 0.0f, 1.0f), Error);
  for (const float weight : {-1.0f, nan, kInfinity}) {
    EXPECT_THROW(SampledInverseCdf(Places{{0.5f, weight}}, 0.0f, 1.0f), Error) << weight;
  }
  EXPECT_THROW(SampledInverseCdf(good, 1.0f, 1.0f), Error);
  EXPECT_THROW(SampledInverseCdf(good, 0.0f, kInfinity), Error);
  EXPECT_THROW(SampledInverseCdf(good, 0.0f, 1.0f, -1), Error);
  EXPECT_THROW(SampledInverseCdf(good, 0.0f, 1.0f, 17), Error);
  EXPECT_THROW(SampledInverseCdf(Places{{1.0f, 1.0f}}, 1.0f, 1.0000002f, 4), Error);
}

}  // namespace
}  // namespace steradian
