#include "steradian/core/sampling/direction_pdf.h"

#include <gtest/gtest.h>

#include "steradian/tests/support/proof.h"

namespace steradian {
namespace {

using namespace test;

const Vec3f kAxis = normalize(Vec3f{0.3f, -0.5f, 0.7f}), kOther = normalize(Vec3f{-0.8f, 0.1f, 0.4f});

CheckOptions aboutAxis() {
  CheckOptions options;
  options.grid.axis = kAxis;
  return options;
}

/// A mixture has no inverse: several random numbers give the same direction.
template <class P>
testing::AssertionResult proveMixture(const P& make, std::optional<double> noSample = 0.0) {
  CheckOptions options = aboutAxis();
  options.inverse = false;
  options.lanes = std::is_invocable_v<P, float>;
  options.noSample = noSample;
  return prove(make, options);
}

/// The upper half of a sphere of directions: half of its draws give no sample.
struct HalfPdf {
  DirectionSample<float> sample(Vec2f u) const {
    const Vec3f wi = UniformSphere<float>::sample(u);
    return {wi, pdf(wi)};
  }
  float pdf(Vec3f wi) const { return dot(wi, kAxis) > 0.0f ? kInvFourPi : 0.0f; }
};

TEST(DirectionPdfStatistics, Sphere) { EXPECT_TRUE(prove<SpherePdf>(aboutAxis())); }
TEST(DirectionPdfStatistics, Hemisphere) {
  EXPECT_TRUE(prove([](auto f) { return HemispherePdf(broadcast<decltype(f)>(kAxis)); }, aboutAxis()));
}
TEST(DirectionPdfStatistics, Cosine) {
  for (const Vec3f axis : {kAxis, kOther, Vec3f{0.0f, 0.0f, -1.0f}}) {
    EXPECT_TRUE(prove([axis](auto f) { return CosinePdf(broadcast<decltype(f)>(axis)); }, aboutAxis()));
  }
}

TEST(DirectionPdfStatistics, Mixtures) {
  EXPECT_TRUE(proveMixture([](auto f) {
    using F = decltype(f);
    const CosinePdf<F> a(broadcast<F>(kAxis)), b(broadcast<F>(kOther));
    return MixturePdf(std::array<F, 3>{F(5.0f), F(0.0f), F(1.0f)}, a, b, SpherePdf<F>{});
  }));
  // A mixture as part of a mixture: the random number is used again.
  EXPECT_TRUE(proveMixture([](auto f) {
    using F = decltype(f);
    const CosinePdf<F> a(broadcast<F>(kAxis)), b(broadcast<F>(kOther));
    const MixturePdf inner(std::array<F, 2>{F(1.0f), F(1.0f)}, a, HemispherePdf<F>(broadcast<F>(kOther)));
    return MixturePdf(std::array<F, 2>{F(0.4f), F(0.6f)}, inner, b);
  }));
}

TEST(DirectionPdfStatistics, MixturesWithPartsThatMiss) {
  const MixturePdf mixture(std::array{0.5f, 0.5f}, HalfPdf{}, CosinePdf<float>(kOther));
  EXPECT_TRUE(proveMixture(mixture, 0.25));
  EXPECT_FALSE(proveMixture(mixture, 0.24));
}

TEST(DirectionPdfStatistics, ManyParts) {
  std::vector<CosinePdf<float>> parts;
  std::vector<float> weights;
  for (int i = 0; i < 7; ++i) {
    const float t = static_cast<float>(i) / 7.0f;
    parts.emplace_back(UniformSphere<float>::sample({t, t * t}));
    weights.push_back(t * (1.0f - t));
  }
  EXPECT_TRUE(proveMixture(MixtureSpanPdf{std::span<const float>(weights), std::span<const CosinePdf<float>>(parts)}));
}

}  // namespace
}  // namespace steradian
