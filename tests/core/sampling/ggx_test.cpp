#include "steradian/core/sampling/ggx.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/tests/support/lanes_check.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using test::unitNumbers;

const Ggx<float> kEven{0.5f, 0.5f}, kUneven{0.3f, 0.8f};
const Vec3f kUp{0.0f, 0.0f, 1.0f};

TEST(Ggx, DensityIsTheFormula) {
  // At the pole 1 / (pi a^2); at 45 degrees 1 / (pi a^2 (1/2 / a^2 + 1/2)^2).
  EXPECT_FLOAT_EQ(kEven.density(kUp), 4.0f * kInvPi);
  const Vec3f slanted = normalize(Vec3f{1.0f, 0.0f, 1.0f});
  EXPECT_NEAR(kEven.density(slanted), 4.0f * kInvPi / 6.25f, 1e-6f);
  EXPECT_NEAR(kUneven.density(slanted), kInvPi / (0.24f * sqr(0.5f / 0.09f + 0.5f)), 1e-6f);
  EXPECT_EQ(kEven.density(-kUp), 0.0f);
  EXPECT_EQ(kEven.density({1.0f, 0.0f, 0.0f}), 0.0f);
}

TEST(Ggx, NormalsCoverTheSurfaceOnce) {
  for (const Ggx<float>& ggx : {kEven, kUneven, Ggx<float>{0.05f, 0.05f}}) {
    test::SphereGrid grid;
    grid.focus = ggx.alphaX < 0.1f ? 0.2 : grid.focus;
    const auto projected = [&](Vec3f m) { return static_cast<double>(ggx.density(m) * maximum(m.z, 0.0f)); };
    EXPECT_NEAR(test::integrateSphere(projected, grid), 1.0, 1e-4);
  }
}

TEST(Ggx, MaskingIsSmiths) {
  // lambda = (sqrt(1 + a^2 tan^2) - 1) / 2.
  for (const float slope : {0.1f, 1.0f, 10.0f, 1e3f}) {
    const Vec3f w = normalize(Vec3f{slope, 0.0f, 1.0f}), v = normalize(Vec3f{0.0f, 0.3f, 1.0f});
    const auto lambda = [](double alpha, double tangent) {
      return 0.5 * (std::sqrt(1.0 + sqr(alpha * tangent)) - 1.0);
    };
    const double a = lambda(0.3, static_cast<double>(slope)), b = lambda(0.8, 0.3);
    EXPECT_NEAR(kUneven.masking(w) * (1.0 + a), 1.0, 1e-5) << slope;
    EXPECT_NEAR(kUneven.maskingShadowing(w, v) * (1.0 + a + b), 1.0, 1e-5) << slope;
    EXPECT_EQ(kUneven.maskingShadowing(w, v), kUneven.maskingShadowing(v, w));
  }
  EXPECT_EQ(kUneven.masking(kUp), 1.0f);
  EXPECT_EQ(kUneven.maskingShadowing(kUp, kUp), 1.0f);
}

// The facets that are seen have the projected area of the surface: the defining property of masking.
TEST(Ggx, VisibleFacetsHaveTheAreaOfTheSurface) {
  for (const Vec3f wo : {kUp, normalize(Vec3f{1.0f, 2.0f, 1.0f}), normalize(Vec3f{-1.0f, 0.3f, 0.05f})}) {
    const auto seen = [&](Vec3f m) {
      return static_cast<double>(kUneven.masking(wo) * maximum(dot(wo, m), 0.0f) * kUneven.density(m));
    };
    EXPECT_NEAR(test::integrateSphere(seen) / static_cast<double>(wo.z), 1.0, 1e-3) << wo.z;
  }
}

TEST(Ggx, FromTheNormalAllNormalsAreVisible) {
  const GgxVisibleNormals<float> normals{kUneven, kUp};
  for (const float x : {-0.9f, -0.2f, 0.0f, 0.4f}) {
    const Vec3f m = normalize(Vec3f{x, 0.3f, 0.8f});
    EXPECT_NEAR(normals.pdf(m), kUneven.density(m) * m.z, 1e-6f);
  }
}

TEST(Ggx, ReflectionsHaveTheJacobian) {
  const Vec3f wo = normalize(Vec3f{1.0f, -0.4f, 0.7f});
  const GgxVisibleNormals<float> normals{kUneven, wo};
  const GgxReflection<float> reflection{normals};
  for (const float u : unitNumbers(100)) {
    const Vec3f m = normals.sample({u, 0.6f}), wi = reflection.sample({u, 0.6f});
    EXPECT_LT(length(normalize(wo + wi) - m), 1e-5f);
    EXPECT_NEAR(reflection.pdf(wi) * 4.0f * dot(wo, m) / normals.pdf(m), 1.0f, 1e-4f);
  }
  EXPECT_EQ(reflection.pdf(-wo), 0.0f);
  EXPECT_EQ(reflection.pdf(-kUp), 0.0f);
}

TEST(Ggx, SoundAtTheEdges) {
  const auto us = unitNumbers(300), vs = unitNumbers(300, 1);
  for (const float alpha : {1e-4f, 1e-2f, 1.0f, 10.0f}) {
    for (const float z : {0.0f, 1e-30f, 1e-7f, 1e-3f, 0.5f, 1.0f}) {
      const Vec3f wo{0.6f * safeSqrt(1.0f - z * z), -0.8f * safeSqrt(1.0f - z * z), z};
      const GgxVisibleNormals<float> normals{{alpha, 0.5f * alpha}, wo};
      for (std::size_t i = 0; i < us.size(); ++i) {
        const Vec3f m = normals.sample({us[i], vs[i]});
        EXPECT_NEAR(length(m), 1.0f, 3e-7f);
        EXPECT_GT(m.z, 0.0f);
        EXPECT_GE(dot(wo, m), -1e-6f);
        EXPECT_TRUE(isFinite(normals.pdf(m)));
        const Vec2f back = normals.invert(m);
        EXPECT_TRUE(back.x >= 0.0f && back.x < 1.0f && back.y >= 0.0f && back.y < 1.0f);
      }
    }
  }
}

}  // namespace
}  // namespace steradian
