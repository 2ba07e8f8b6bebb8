#include "steradian/accel/shapes/sampling/triangle_sampling.h"

#include "steradian/tests/accel/shapes/sampling_stat_check.h"

namespace steradian::test {
namespace {

const Triangle<float> kTriangle{{-1.0f, -1.0f, 1.0f}, {1.0f, -1.0f, 1.5f}, {-1.0f, 2.0f, 1.0f}};

testing::AssertionResult checkOnTriangle(const Triangle<float>& t, Vec3f from) {
  return checkFlatTarget(t, from, 2.0f * area(t), [&](Vec2f p) { return t.a + (t.b - t.a) * p.x + (t.c - t.a) * p.y; });
}

TEST(TriangleSamplingStat, LargeTriangles) {
  const Vec3f middle{-0.4f, 0.2f, 1.15f};
  for (const Vec3f from :
       {Vec3f{0.0f, 0.0f, 0.0f}, middle + Vec3f{0.0f, 0.0f, -0.05f}, kTriangle.b + Vec3f{-0.1f, 0.1f, 0.1f}}) {
    EXPECT_TRUE(proveTarget(kTriangle, from)) << from.x << ", " << from.y << ", " << from.z;
  }
  EXPECT_TRUE(checkOnTriangle(kTriangle, {}));
  EXPECT_TRUE(checkOnTriangle(kTriangle, {0.5f, 3.0f, 0.2f}));
  // Its ends are seen in opposite directions.
  EXPECT_TRUE(checkOnTriangle({{-1.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 1.0f}, {1.0f, 0.02f, 1.0f}}, {0.0f, 0.005f, 0.95f}));
}

TEST(TriangleSamplingStat, SmallTriangles) {
  for (const Vec3f from : {Vec3f{0.0f, 0.0f, 20.0f}, Vec3f{5.0f, 3.0f, -9.0f}}) {
    EXPECT_TRUE(checkOnTriangle(kTriangle, from)) << from.x << ", " << from.y << ", " << from.z;
  }
}

TEST(TriangleSamplingStat, RejectsSwappedWeights) {
  // Without the square root, or Heitz's map, points crowd at a vertex.
  CheckOptions options;
  options.grid = gridAbout(kTriangle, Vec3f{0.0f, 0.0f, 20.0f});
  options.edgeShare = 0.005;
  const Vec3f from{0.0f, 0.0f, 20.0f};
  EXPECT_FALSE(checkDirectionSampler(
      [&](float, Vec2f u) {
        const Vec3f p = kTriangle.a * (1.0f - u.x) + (kTriangle.b * (1.0f - u.y) + kTriangle.c * u.y) * u.x;
        const Vec3f wi = normalize(p - from);
        return DirectionSample<float>{wi, pdfDirection(kTriangle, from, wi)};
      },
      [&](Vec3f wi) { return static_cast<double>(pdfDirection(kTriangle, from, wi)); }, options));
}

}  // namespace
}  // namespace steradian::test
