#include <gtest/gtest.h>

#include "steradian/core/direction_pdf.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using namespace test;

const Vec3f kAxis = normalize(Vec3f{0.3f, -0.5f, 0.7f}), kOther = normalize(Vec3f{-0.8f, 0.1f, 0.4f});

template <class P>
testing::AssertionResult check(const P& p, std::optional<double> noSample = 0.0) {
  CheckOptions options;
  options.grid.axis = kAxis;
  options.noSample = noSample;
  return checkDirectionSampler([&](float choice, Vec2f u) { return sampleDirectionPdf(p, choice, u); },
                               [&](Vec3f w) { return p.pdf(w); }, options);
}

/// The upper half of a sphere of directions: half of its samples are none.
struct HalfPdf {
  DirectionSample<float> sample(Vec2f u) const {
    const Vec3f wi = UniformSphere<float>::sample(u);
    return {wi, pdf(wi)};
  }
  float pdf(Vec3f wi) const { return dot(wi, kAxis) > 0.0f ? kInvFourPi : 0.0f; }
};

TEST(DirectionPdfStatistics, Sphere) { EXPECT_TRUE(check(SpherePdf<float>{})); }
TEST(DirectionPdfStatistics, Hemisphere) { EXPECT_TRUE(check(HemispherePdf<float>(kAxis))); }
TEST(DirectionPdfStatistics, Cosine) {
  EXPECT_TRUE(check(CosinePdf<float>(kAxis)));
  EXPECT_TRUE(check(CosinePdf<float>(kOther)));
}

TEST(DirectionPdfStatistics, Mixtures) {
  const CosinePdf<float> a(kAxis), b(kOther);
  EXPECT_TRUE(check(MixturePdf(std::array{0.3f, 0.7f}, a, b)));
  EXPECT_TRUE(check(MixturePdf(std::array{5.0f, 0.0f, 1.0f}, a, b, SpherePdf<float>{})));
  // A mixture as part of a mixture: the random number is used again.
  const MixturePdf inner(std::array{1.0f, 1.0f}, a, HemispherePdf<float>(kOther));
  EXPECT_TRUE(check(MixturePdf(std::array{0.4f, 0.6f}, inner, b)));
}

TEST(DirectionPdfStatistics, MixturesWithPartsThatMiss) {
  const MixturePdf mixture(std::array{0.5f, 0.5f}, HalfPdf{}, CosinePdf<float>(kOther));
  EXPECT_TRUE(check(mixture, 0.25));
  EXPECT_FALSE(check(mixture, 0.24));
}

TEST(DirectionPdfStatistics, ManyParts) {
  std::vector<CosinePdf<float>> parts;
  std::vector<float> weights;
  for (int i = 0; i < 7; ++i) {
    const float t = static_cast<float>(i) / 7.0f;
    parts.emplace_back(UniformSphere<float>::sample({t, t * t}));
    weights.push_back(t * (1.0f - t));
  }
  EXPECT_TRUE(check(MixtureSpanPdf{std::span<const float>(weights), std::span<const CosinePdf<float>>(parts)}));
}

}  // namespace
}  // namespace steradian
