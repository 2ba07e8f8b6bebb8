#include "steradian/accel/shapes/sampling/sphere_sampling.h"

#include "steradian/tests/accel/shapes/sampling_stat_check.h"

namespace steradian::test {
namespace {

const Sphere<float> kSphere{{1.0f, 2.0f, 3.0f}, 0.5f};

TEST(SphereSamplingStat, Directions) {
  const Vec3f towards = normalize(Vec3f{0.3f, -0.5f, 0.2f});
  for (const float distance : {500.0f, 20.0f, 2.0f, 0.6f, 0.501f}) {
    EXPECT_TRUE(proveTarget(kSphere, kSphere.center + towards * distance)) << distance;
  }
  EXPECT_TRUE(proveTarget(kSphere, kSphere.center + towards * 0.3f));
}

TEST(SphereSamplingStat, DirectionsFromTheSurface) {
  CheckOptions options;
  options.noSample = 0.5;
  EXPECT_TRUE(proveTarget(kSphere, kSphere.center + Vec3f{0.0f, 0.5f, 0.0f}, options));
}

TEST(SphereSamplingStat, Positions) {
  // The normals of positions that are uniform by area are uniform directions.
  EXPECT_TRUE(checkDirectionSampler(
      [](float, Vec2f u) {
        const PositionSample<float> p = samplePosition(kSphere, u);
        return DirectionSample<float>{normalize(p.position - kSphere.center), p.pdf * sqr(kSphere.radius)};
      },
      [](Vec3f) { return static_cast<double>(kInvFourPi); }));
}

TEST(SphereSamplingStat, RejectsAConeTwoPercentOff) {
  const Sphere<float> larger{kSphere.center, kSphere.radius * 1.01f};
  CheckOptions options;
  options.grid = gridAbout(kSphere, Vec3f{});
  EXPECT_FALSE(checkDirectionSampler([](float, Vec2f u) { return sampleDirection(kSphere, {}, u); },
                                     [&](Vec3f wi) { return static_cast<double>(pdfDirection(larger, {}, wi)); },
                                     options));
}

}  // namespace
}  // namespace steradian::test
