#include "steradian/accel/shapes/sampling/hittable_pdf.h"

#include <array>

#include "steradian/core/base/diagnostics.h"
#include "steradian/tests/accel/shapes/target_check.h"

namespace steradian::test {
namespace {

static_assert(DirectionPdf<HittablePdf, float>);

const SampledShape kNear(Sphere<float>{{0.0f, 0.0f, 2.0f}, 0.5f});
const SampledShape kBehind(Quad<float>{{-1.0f, -1.0f, 4.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}});
const SampledShape kAside(Disk<float>{{3.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, 1.0f});
const SampledShape kEdgeOn(Disk<float>{{3.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, 1.0f});

TEST(HittablePdf, OfOneShapeIsTheShapes) {
  const HittablePdf pdf(kNear, {0.1f, 0.0f, 0.0f});
  const DirectionSample<float> s = pdf.sample(0.7f, {0.2f, 0.4f}),
                               expected = kNear.sampleDirection({0.1f, 0.0f, 0.0f}, {0.2f, 0.4f});
  EXPECT_EQ(s.pdf, expected.pdf);
  EXPECT_EQ(s.wi.x, expected.wi.x);
  EXPECT_EQ(s.distance, expected.distance);
  EXPECT_EQ(pdf.pdf(s.wi), kNear.pdfDirection({0.1f, 0.0f, 0.0f}, s.wi));
}

TEST(HittablePdf, OfAGroupSumsOverAllMembers) {
  const std::array<float, 3> weights{1.0f, 2.0f, 5.0f};
  const TargetGroup group({kNear, kBehind, kAside}, weights);
  const HittablePdf pdf(group, {});
  // The occluded quad contributes where the sphere hides it.
  const Vec3f ahead{0.0f, 0.0f, 1.0f};
  EXPECT_FLOAT_EQ(pdf.pdf(ahead), 0.125f * kNear.pdfDirection({}, ahead) + 0.25f * kBehind.pdfDirection({}, ahead));
  EXPECT_FLOAT_EQ(pdf.pdf({1.0f, 0.0f, 0.0f}), 0.625f * kAside.pdfDirection({}, {1.0f, 0.0f, 0.0f}));
  EXPECT_EQ(pdf.pdf({0.0f, 0.0f, -1.0f}), 0.0f);
  for (const Vec2f u : unitPoints(50)) {
    for (const float choice : {0.0f, 0.3f, kOneMinusEpsilon}) {
      const DirectionSample<float> s = pdf.sample(choice, u);
      EXPECT_EQ(s.pdf, pdf.pdf(s.wi));
      EXPECT_EQ(s.distance, kInfinity);
    }
  }
}

TEST(HittablePdf, ChoosesByWeightAndNeverTheWeightless) {
  const std::array<float, 4> weights{0.0f, 3.0f, 0.0f, 1.0f};
  const TargetGroup group({kNear, kBehind, kNear, kAside}, weights);
  EXPECT_EQ(group.choose(0.0f), 1u);
  EXPECT_EQ(group.choose(0.7499f), 1u);
  EXPECT_EQ(group.choose(0.75f), 3u);
  EXPECT_EQ(group.choose(kOneMinusEpsilon), 3u);
  EXPECT_FLOAT_EQ(group.probability(1), 0.75f);
  EXPECT_EQ(group.probability(2), 0.0f);
  const std::array<float, 2> last{1.0f, 0.0f};
  EXPECT_EQ(TargetGroup({kNear, kAside}, last).choose(kOneMinusEpsilon), 0u);
  EXPECT_FLOAT_EQ(TargetGroup({kNear, kAside}).probability(1), 0.5f);
}

TEST(HittablePdf, NothingToChooseIsNoSample) {
  const std::array<float, 1> none{0.0f};
  for (const TargetGroup& group : {TargetGroup({}), TargetGroup({kNear}, none)}) {
    EXPECT_TRUE(group.empty());
    const HittablePdf pdf(group, {});
    EXPECT_EQ(pdf.sample(0.5f, {0.5f, 0.5f}).pdf, 0.0f);
    EXPECT_EQ(pdf.pdf({0.0f, 0.0f, 1.0f}), 0.0f);
  }
  // A member that is not seen at all keeps its probability: no sample.
  const TargetGroup group({kEdgeOn, kNear});
  EXPECT_EQ(HittablePdf(group, {}).sample(0.2f, {0.5f, 0.5f}).pdf, 0.0f);
  EXPECT_GT(HittablePdf(group, {}).sample(0.7f, {0.5f, 0.5f}).pdf, 0.0f);
}

TEST(HittablePdf, RejectsBadWeights) {
  const std::array<float, 2> negative{1.0f, -1.0f}, infinite{1.0f, kInfinity};
  EXPECT_THROW(TargetGroup({kNear, kAside}, negative), Error);
  EXPECT_THROW(TargetGroup({kNear, kAside}, infinite), Error);
  EXPECT_THROW(TargetGroup({kNear}, negative), Error);
}

TEST(HittablePdf, MixesWithTheBooksDensities) {
  const HittablePdf target(kNear, {});
  const MixturePdf mixture(std::array<float, 2>{0.5f, 0.5f}, target, CosinePdf<float>(Vec3f{0.0f, 0.0f, 1.0f}));
  const Vec3f ahead{0.0f, 0.0f, 1.0f};
  EXPECT_FLOAT_EQ(mixture.pdf(ahead), 0.5f * target.pdf(ahead) + 0.5f * kInvPi);
  const DirectionSample<float> s = mixture.sample(0.2f, {0.3f, 0.4f});
  EXPECT_GT(target.pdf(s.wi), 0.0f);
  EXPECT_FLOAT_EQ(s.pdf, mixture.pdf(s.wi));
}

}  // namespace
}  // namespace steradian::test
