#include "steradian/accel/shapes/sampling/quad_sampling.h"

#include "steradian/tests/accel/shapes/sampling_stat_check.h"

namespace steradian::test {
namespace {

const Quad<float> kRectangle{{-1.0f, -1.0f, 1.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 3.0f, 0.0f}};
const Quad<float> kSkew{{-1.0f, -1.0f, 1.0f}, {2.0f, 0.5f, 0.0f}, {0.3f, 3.0f, 0.2f}};
const Quad<float> kSliver{{-1.0f, -1.0f, 1.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 0.002f, 0.0f}};

testing::AssertionResult checkOnQuad(const Quad<float>& quad, Vec3f from) {
  return checkFlatTarget(quad, from, area(quad), [&](Vec2f p) { return quad.corner + quad.u * p.x + quad.v * p.y; });
}

TEST(QuadSamplingStat, LargeRectangles) {
  for (const Vec3f from : {Vec3f{0.0f, 0.0f, 0.0f}, Vec3f{-0.9f, -0.9f, 1.01f}, Vec3f{0.3f, 0.5f, 1.0001f}}) {
    EXPECT_TRUE(proveTarget(kRectangle, from)) << from.x << ", " << from.y << ", " << from.z;
  }
  for (const Vec3f from :
       {Vec3f{0.0f, 0.0f, 0.0f}, Vec3f{3.0f, 0.5f, 0.3f}, Vec3f{0.3f, 0.5f, 1.3f}, Vec3f{-1.5f, 0.5f, 1.05f}}) {
    EXPECT_TRUE(checkOnQuad(kRectangle, from)) << from.x << ", " << from.y << ", " << from.z;
  }
}

TEST(QuadSamplingStat, SmallRectangles) {
  EXPECT_TRUE(proveTarget(kRectangle, {0.0f, 0.0f, 20.0f}));
  for (const Vec3f from : {Vec3f{0.0f, 0.0f, 20.0f}, Vec3f{5.0f, 3.0f, -9.0f}, Vec3f{4.0f, 0.5f, 1.1f}}) {
    EXPECT_TRUE(checkOnQuad(kRectangle, from)) << from.x << ", " << from.y << ", " << from.z;
  }
}

TEST(QuadSamplingStat, SkewQuads) {
  EXPECT_TRUE(proveTarget(kSkew, {}));
  for (const Vec3f from : {Vec3f{0.0f, 0.0f, 0.0f}, Vec3f{2.0f, 1.0f, 3.0f}}) EXPECT_TRUE(checkOnQuad(kSkew, from));
}

TEST(QuadSamplingStat, Slivers) {
  // Seen from a distance as small as its width, it fills a wedge.
  EXPECT_TRUE(proveTarget(kSliver, {0.3f, -0.999f, 0.999f}));
  EXPECT_TRUE(checkOnQuad(kSliver, {0.3f, -0.7f, 0.5f}));
  EXPECT_TRUE(checkOnQuad(kSliver, {0.3f, -0.7f, 0.99f}));
}

TEST(QuadSamplingStat, RejectsADensityTwoPercentOff) {
  CheckOptions options;
  options.grid = gridAbout(kRectangle, {});
  options.edgeShare = 0.005;
  const auto draw = [&](float, Vec2f u) { return sampleDirection(kRectangle, {}, u); };
  const auto drawWrong = [&](float, Vec2f u) {
    DirectionSample<float> s = sampleDirection(kRectangle, {}, u);
    s.pdf *= 1.02f;
    return s;
  };
  const auto density = [&](Vec3f wi) { return static_cast<double>(pdfDirection(kRectangle, {}, wi)); };
  EXPECT_TRUE(checkDirectionSampler(draw, density, options));
  EXPECT_FALSE(checkDirectionSampler(
      drawWrong, [&](Vec3f wi) { return 1.02 * density(wi); }, options));
  EXPECT_FALSE(checkDirectionSampler(drawWrong, density, options));
}

TEST(QuadSamplingStat, RejectsAWarpedSampler) {
  // By area where the density is uniform in solid angle; and one edge never reached.
  CheckOptions options;
  options.grid = gridAbout(kRectangle, {});
  options.edgeShare = 0.005;
  const auto density = [&](Vec3f wi) { return static_cast<double>(pdfDirection(kRectangle, {}, wi)); };
  EXPECT_FALSE(checkDirectionSampler(
      [&](float, Vec2f u) {
        const Vec3f wi = normalize(samplePosition(kRectangle, u).position);
        return DirectionSample<float>{wi, pdfDirection(kRectangle, {}, wi)};
      },
      density, options));
  EXPECT_FALSE(checkDirectionSampler(
      [&](float, Vec2f u) {
        return sampleDirection(kRectangle, {}, {u.x * 0.98f, u.y});
      },
      density, options));
}

}  // namespace
}  // namespace steradian::test
