#include "steradian/core/sampling/direction_pdf.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using test::unitNumbers;

static_assert(SimpleDirectionPdf<SpherePdf<float>, float>);
static_assert(SimpleDirectionPdf<CosinePdf<Lanes<8>>, Lanes<8>>);
static_assert(ChoosingDirectionPdf<MixturePdf<float, SpherePdf<float>>, float>);
static_assert(DirectionPdf<MixturePdf<float, SpherePdf<float>>, float>);
static_assert(!DirectionPdf<UniformSphere<float>, float>);

const Vec3f kAxis = normalize(Vec3f{0.1f, -0.7f, 0.4f});

/// Never gives a sample, and has an infinite density: weight 0 must keep it out.
struct BrokenPdf {
  DirectionSample<float> sample(Vec2f) const { return {{0.0f, 0.0f, 1.0f}, kInfinity}; }
  float pdf(Vec3f) const { return kInfinity; }
};

TEST(DirectionPdf, ValuesAreTheFormulas) {
  const Vec3f tilted = normalize(kAxis + Frame<float>::fromZ(kAxis).x);
  EXPECT_FLOAT_EQ(SpherePdf<float>{}.pdf(tilted), kInvFourPi);
  EXPECT_FLOAT_EQ(HemispherePdf<float>(kAxis).pdf(tilted), kInvTwoPi);
  EXPECT_EQ(HemispherePdf<float>(kAxis).pdf(-tilted), 0.0f);
  EXPECT_NEAR(CosinePdf<float>(kAxis).pdf(tilted), kInvPi * std::sqrt(0.5f), 1e-6f);
  EXPECT_EQ(CosinePdf<float>(kAxis).pdf(-tilted), 0.0f);
}

TEST(DirectionPdf, ChoiceFollowsTheWeights) {
  const std::array<float, 5> weights{0.0f, 1.0f, 0.0f, 3.0f, 0.0f};
  const auto choose = [&](float u) { return chooseByWeight(u, std::span<const float>(weights), 4.0f); };
  EXPECT_EQ(choose(0.0f).index, 1u);
  EXPECT_EQ(choose(0.2499f).index, 1u);
  EXPECT_EQ(choose(0.25f).index, 3u);
  EXPECT_EQ(choose(kOneMinusEpsilon).index, 3u);
  EXPECT_FLOAT_EQ(choose(0.125f).rest, 0.5f);
  EXPECT_FLOAT_EQ(choose(0.625f).rest, 0.5f);
  EXPECT_LT(choose(kOneMinusEpsilon).rest, 1.0f);
  // A total that rounding made larger than the sum: the last possible index, and a number below 1.
  const auto beyond = chooseByWeight(kOneMinusEpsilon, std::span<const float>(weights), 4.1f);
  EXPECT_EQ(beyond.index, 3u);
  EXPECT_EQ(beyond.rest, kOneMinusEpsilon);
}

TEST(DirectionPdf, MixturesReportTheMarginalDensity) {
  const SpherePdf<float> sphere;
  const CosinePdf<float> cosine(kAxis);
  // Weights of any sum.
  const MixturePdf mixture(std::array{1.0f, 3.0f}, sphere, cosine);
  for (const float u : unitNumbers(100)) {
    for (const float v : unitNumbers(10, 1)) {
      const auto s = mixture.sample(u, {v, u});
      EXPECT_FLOAT_EQ(s.pdf, 0.25f * sphere.pdf(s.wi) + 0.75f * cosine.pdf(s.wi));
      EXPECT_EQ(s.pdf, mixture.pdf(s.wi));
    }
  }
  // The choice decides which part draws.
  EXPECT_EQ(length(mixture.sample(0.1f, {0.3f, 0.6f}).wi - sphere.sample({0.3f, 0.6f}).wi), 0.0f);
  EXPECT_EQ(length(mixture.sample(0.9f, {0.3f, 0.6f}).wi - cosine.sample({0.3f, 0.6f}).wi), 0.0f);
}

TEST(DirectionPdf, MixturesLeaveOutWeightZero) {
  const CosinePdf<float> cosine(kAxis);
  const MixturePdf mixture(std::array{0.0f, 2.0f}, BrokenPdf{}, cosine);
  const auto s = mixture.sample(0.0f, {0.3f, 0.6f});
  EXPECT_EQ(s.pdf, cosine.pdf(s.wi));
  const MixturePdf nothing(std::array{0.0f, 0.0f}, BrokenPdf{}, cosine);
  EXPECT_EQ(nothing.pdf(kAxis), 0.0f);
  EXPECT_EQ(nothing.sample(0.5f, {0.3f, 0.6f}).pdf, 0.0f);
}

TEST(DirectionPdf, SpansAndTuplesAgree) {
  const std::array<CosinePdf<float>, 3> parts{CosinePdf<float>(kAxis), CosinePdf<float>(-kAxis),
                                              CosinePdf<float>(Vec3f{0.0f, 1.0f, 0.0f})};
  const std::array<float, 3> weights{0.2f, 0.5f, 0.3f};
  const MixturePdf tuple(weights, parts[0], parts[1], parts[2]);
  const MixtureSpanPdf span{std::span<const float>(weights), std::span<const CosinePdf<float>>(parts)};
  for (const float u : unitNumbers(200)) {
    const auto a = tuple.sample(u, {u, 0.4f}), b = span.sample(u, {u, 0.4f});
    EXPECT_TRUE(test::sameBits(a.wi, b.wi));
    EXPECT_EQ(a.pdf, b.pdf);
    EXPECT_EQ(a.distance, kInfinity);
  }
}

TEST(DirectionPdf, LanesAgreeWithScalars) {
  const auto us = unitNumbers(256), vs = unitNumbers(256, 1), cs = unitNumbers(256, 2);
  const auto drawn = [](auto u, auto v, auto c) {
    using F = decltype(u);
    const Vec3<F> axis = broadcast<F>(kAxis);
    const MixturePdf inner(std::array<F, 2>{c, F(0.5f)}, SpherePdf<F>{}, HemispherePdf<F>(axis));
    const MixturePdf mixture(std::array<F, 3>{F(1.0f), v, F(0.0f)}, CosinePdf<F>(axis), inner, SpherePdf<F>{});
    const auto s = mixture.sample(c, {u, v});
    return s.wi + Vec3<F>{s.pdf, mixture.pdf(Vec3<F>{v, u, c}), u};
  };
  EXPECT_TRUE(test::sameInLanes<4>(drawn, us, vs, cs));
  EXPECT_TRUE(test::sameInLanes<8>(drawn, us, vs, cs));
}

}  // namespace
}  // namespace steradian
