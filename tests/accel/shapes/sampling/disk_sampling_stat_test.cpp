#include "steradian/accel/shapes/sampling/disk_sampling.h"

#include "steradian/tests/accel/shapes/sampling_stat_check.h"

namespace steradian::test {
namespace {

const Disk<float> kDisk{{1.0f, 2.0f, 3.0f}, {0.6f, 0.0f, 0.8f}, 0.5f};

TEST(DiskSamplingStat, Directions) {
  const Vec3f aside = kDisk.center + Vec3f{0.8f, 0.0f, -0.6f} * 1.5f;
  EXPECT_TRUE(proveTarget(kDisk, kDisk.center + kDisk.normal * 2.0f));
  EXPECT_TRUE(proveTarget(kDisk, kDisk.center - kDisk.normal * 0.3f));
  EXPECT_TRUE(proveTarget(kDisk, kDisk.center + kDisk.normal * 100.0f));
  EXPECT_TRUE(proveTarget(kDisk, aside + kDisk.normal * 0.3f));
}

TEST(DiskSamplingStat, Positions) {
  const Frame<float> axes = Frame<float>::fromZ(kDisk.normal);
  CheckOptions options;
  options.domain = {-0.5001, 0.5001, -0.5001, 0.5001};
  options.edgeShare = 0.001;
  EXPECT_TRUE(checkPlaneSampler(
      [&](float, Vec2f u) {
        const PositionSample<float> p = samplePosition(kDisk, u);
        const Vec3f local = axes.toLocal(p.position - kDisk.center);
        return PlaneSample{{local.x, local.y}, static_cast<double>(p.pdf)};
      },
      [&](Vec2f p) {
        return p.x * p.x + p.y * p.y <= 0.25f * 1.00001f ? static_cast<double>(pdfPosition(kDisk)) : 0.0;
      },
      options));
}

TEST(DiskSamplingStat, RejectsADensityWithoutItsCosine) {
  const Vec3f from = kDisk.center + Vec3f{0.8f, 0.0f, -0.6f} * 1.5f + kDisk.normal * 1.5f;
  CheckOptions options;
  options.grid = gridAbout(kDisk, from);
  options.edgeShare = 0.005;
  EXPECT_FALSE(checkDirectionSampler(
      [&](float, Vec2f u) {
        DirectionSample<float> s = sampleDirection(kDisk, from, u);
        s.pdf *= absDot(s.wi, kDisk.normal) * 1.414f;
        return s;
      },
      [&](Vec3f wi) { return static_cast<double>(pdfDirection(kDisk, from, wi) * absDot(wi, kDisk.normal) * 1.414f); },
      options));
}

}  // namespace
}  // namespace steradian::test
