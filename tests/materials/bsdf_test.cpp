#include "steradian/materials/bsdf.h"

#include <cmath>

#include "steradian/tests/materials/models.h"

namespace steradian {
namespace {

using namespace steradian::test;

const Vec3f kNormal = normalize(Vec3f{0.3f, -0.7f, 0.5f});

/// The models as Bsdfs of a surface whose two normals are the same.
template <class Visitor>
void forEachBsdf(Visitor&& visit) {
  forEachModel([&](const std::string& name, const auto& model, const auto&) {
    visit(name, Bsdf(Bsdf::Model(model), kNormal, kNormal), model);
  });
}

TEST(Bsdf, IsTheModelInAnotherFrame) {
  const Frame<float> frame = Frame<float>::fromZ(kNormal);
  forEachBsdf([&](const std::string& name, const Bsdf& bsdf, const auto& model) {
    SCOPED_TRACE(name);
    for (std::uint32_t i = 0; i < 500; ++i) {
      const Vec3f wo = randomDirection(i), localWo = frame.toLocal(wo);
      if (std::abs(localWo.z) < 1e-3f) continue;
      const auto there = bsdf.sample(wo, randomNumbers(i), Transport::Radiance);
      const auto here = model.sample(localWo, randomNumbers(i), Transport::Radiance);
      ASSERT_EQ(there.pdf, here.pdf);
      ASSERT_EQ(there.lobe, here.lobe);
      ASSERT_EQ(bsdf.diracProbability(wo), model.diracProbability(localWo));
      ASSERT_EQ(bsdf.albedo(wo).g, model.albedo(localWo).g);
      if (here.pdf == 0.0f) continue;
      ASSERT_EQ(there.weight.r, here.weight.r);
      ASSERT_NEAR(length(frame.toLocal(there.wi) - here.wi), 0.0f, 1e-6f);
      ASSERT_NEAR(length(there.wi), 1.0f, 2e-7f);
      const Vec3f wi = randomDirection(i + 900);
      const auto v = bsdf.eval(wo, wi, Transport::Radiance);
      const auto m = model.eval(localWo, frame.toLocal(wi), Transport::Radiance);
      ASSERT_EQ(v.pdf, m.pdf);
      ASSERT_EQ(v.value.g, m.value.g);
    }
  });
}

TEST(Bsdf, LightSamplesSufficeForBoundedContinuousLobes) {
  const auto samples = [](const Bsdf::Model& model) {
    return Bsdf(model, kNormal, kNormal).suitsLightSampling(kNormal);
  };
  EXPECT_TRUE(samples(Lambert<float>{kColour}));
  EXPECT_TRUE(samples(UniformDiffuse<float>{kColour}));
  EXPECT_TRUE(samples(coated<float>(kColour, 1.5f)));
  EXPECT_TRUE(samples(FuzzyMetal<float>{kColour, 1.0f}));
  EXPECT_FALSE(samples(FuzzyMetal<float>{kColour, 0.9f}));
  EXPECT_FALSE(samples(Mirror<float>{kColour}));
  EXPECT_FALSE(samples(Dielectric<float>{1.5f}));
  EXPECT_FALSE(samples(Absorber<float>{}));
  EXPECT_FALSE(samples(coated<float>(grey(0.0f), 1.5f)));
}

// Where shading and geometric normal disagree about the side of wi, neither eval nor sample lets light through.
TEST(Bsdf, InterpolatedNormalsDoNotLeakLight) {
  const Vec3f geometric{0, 0, 1}, shading = fromNormal(40.0, 0.0);
  const Bsdf lambert(Lambert<float>{grey(1.0f)}, geometric, shading);
  const Vec3f wo = fromNormal(10.0, 0.0);
  const Vec3f below = fromNormal(100.0, 0.0);  // under the surface, over the shading horizon
  EXPECT_EQ(lambert.eval(wo, below, Transport::Radiance).pdf, 0.0f);
  EXPECT_EQ(lambert.eval(wo, below, Transport::Radiance).value.r, 0.0f);
  EXPECT_GT(lambert.eval(wo, fromNormal(80.0, 0.0), Transport::Radiance).value.r, 0.0f);
  int lost = 0;
  for (std::uint32_t i = 0; i < 2000; ++i) {
    const auto s = lambert.sample(wo, randomNumbers(i), Transport::Radiance);
    if (s.pdf == 0.0f) {
      ++lost;
      EXPECT_EQ(s.lobe, 0u);
    } else {
      EXPECT_GT(s.wi.z, 0.0f);
    }
  }
  // The lune between the two horizons holds (1 - cos 40) / 2 = 11.7 % of the cosine-weighted directions.
  EXPECT_NEAR(lost / 2000.0, 0.117, 0.03);
}

// With one f for both transports, value / |cos wi| must differ by the ratio of the cosines with both normals.
TEST(Bsdf, ImportanceUsesTheAdjointOfShadingNormals) {
  const Vec3f geometric{0, 0, 1}, shading = fromNormal(30.0, 70.0);
  const Bsdf varnish(coated<float>(kColour, 1.5f), geometric, shading);
  for (std::uint32_t i = 0; i < 300; ++i) {
    Vec3f a = randomDirection(i), b = randomDirection(i + 400);
    a.z = std::abs(a.z), b.z = std::abs(b.z);
    // The adjoint: light from b to a as a path from the camera at a sees it, and as a path from the light at b sees it,
    // per unit of geometric cosine.
    const float radiance = varnish.eval(a, b, Transport::Radiance).value.r / b.z;
    const float importance = varnish.eval(b, a, Transport::Importance).value.r / a.z;
    ASSERT_NEAR(radiance, importance, 1e-5f * radiance + 1e-9f);
    const auto s = varnish.sample(b, {kOneMinusEpsilon, {0.3f, 0.6f}}, Transport::Importance);
    if (s.pdf == 0.0f || s.pdf == kDirac) continue;
    const auto v = varnish.eval(b, s.wi, Transport::Importance);
    ASSERT_NEAR(s.weight.r * s.pdf, v.value.r, 1e-4f * v.value.r);
  }
}

}  // namespace
}  // namespace steradian
