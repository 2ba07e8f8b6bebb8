#include "steradian/accel/shapes/sampling/hittable_pdf.h"

#include <array>

#include "steradian/tests/accel/shapes/sampling_stat_check.h"

namespace steradian::test {
namespace {

Matrix shear() {
  return {2.0f, 0.3f, 0.0f, 0.0f, -0.4f, 0.7f, 0.2f, 0.0f, 0.1f, 0.0f, 1.5f, 0.0f, 1.0f, -2.0f, 0.5f, 1.0f};
}
const SampledShape kSphere(Sphere<float>{{0.0f, 0.0f, 2.0f}, 0.5f});
const SampledShape kDisk(Disk<float>{{0.0f, 0.0f, 2.0f}, {0.6f, 0.0f, 0.8f}, 0.7f});
const SampledShape kBox(Box<float>{{0.0f, 0.0f, 2.0f}, {0.5f, 0.8f, 0.3f}, Frame<float>::fromZ({0.6f, 0.0f, 0.8f})});
const SampledShape kBehind(Quad<float>{{-1.0f, -1.0f, 4.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}});
const SampledShape kAside(Triangle<float>{{3.0f, 0.0f, 0.0f}, {3.0f, 1.0f, 0.0f}, {3.0f, 0.0f, 2.0f}});

testing::AssertionResult check(const HittablePdf& target, CheckOptions options) {
  options.edgeShare = 0.005;
  options.inverse = options.lanes = false;
  return prove(target, options);
}

TEST(HittablePdfStat, TransformedShapes) {
  for (const SampledShape& local : {kSphere, kDisk, kBox}) {
    const SampledShape world = transformed(local, shear());
    for (const Vec3f from : {Vec3f{}, Vec3f{1.2f, -2.0f, 3.3f}}) {
      CheckOptions options;
      options.grid.axis = normalize(Vec3f{1.2f, -2.0f, 3.5f} - from);
      EXPECT_TRUE(check(HittablePdf(world, from), options));
    }
  }
}

TEST(HittablePdfStat, ShapesInMotion) {
  Motion motion{Matrix(), shear()};
  motion.open.setTranslation(Imath::V3f(0.5f, 0.0f, 1.0f));
  const float time = 0.6f;
  CheckOptions options;
  options.grid.axis = normalize(transformPoint(MovingTransform(motion).at(time), Vec3f{0.0f, 0.0f, 2.0f}));
  options.quadratureTolerance = 1e-8;
  for (const SampledShape& local : {kSphere, kBox, kBehind}) {
    EXPECT_TRUE(check(HittablePdf(inMotion(local, MovingTransform(motion)), {}, time), options));
  }
}

TEST(HittablePdfStat, GroupsWithOverlapAndOcclusion) {
  const std::array<float, 4> weights{1.0f, 2.0f, 0.5f, 1.5f};
  const TargetGroup group({kSphere, kBehind, kBox, kAside}, weights);
  EXPECT_TRUE(check(HittablePdf(group, {}), {}));
}

TEST(HittablePdfStat, AGroupThatOnlyCountsTheFirstHitIsRejected) {
  const TargetGroup group({kSphere, kBehind});
  const HittablePdf target(group, {});
  const auto firstOnly = [&](Vec3f wi) {
    const float near = kSphere.pdfDirection({}, wi);
    return 0.5 * static_cast<double>(near > 0.0f ? near : kBehind.pdfDirection({}, wi));
  };
  CheckOptions options;
  options.edgeShare = 0.005;
  EXPECT_FALSE(checkDirectionSampler(
      [&](float choice, Vec2f u) {
        DirectionSample<float> s = target.sample(choice, u);
        s.pdf = static_cast<float>(firstOnly(s.wi));
        return s;
      },
      firstOnly, options));
}

}  // namespace
}  // namespace steradian::test
