#include "steradian/accel/shapes/sampling/box_sampling.h"

#include <algorithm>

#include "steradian/tests/accel/shapes/sampling_stat_check.h"

namespace steradian::test {
namespace {

const Box<float> kBox{{1.0f, 2.0f, 3.0f}, {0.5f, 1.0f, 2.0f}, Frame<float>::fromZ({0.6f, 0.0f, 0.8f})};

Vec3f placeAt(Vec3f units) { return kBox.center + kBox.axes.toWorld(units * kBox.half); }

TEST(BoxSamplingStat, Directions) {
  for (const Vec3f units : {Vec3f{1.1f, 0.2f, -0.3f}, Vec3f{3.0f, -4.0f, 0.1f}, Vec3f{1.2f, 1.1f, 1.1f},
                            Vec3f{-10.0f, 20.0f, -7.0f}, Vec3f{0.3f, -0.4f, 0.9f}}) {
    EXPECT_TRUE(proveTarget<Box>(kBox, placeAt(units))) << units.x << ", " << units.y << ", " << units.z;
  }
}

TEST(BoxSamplingStat, PositionsShareTheFaces) {
  // Cells: six faces, each 4 x 4, in proportion to their area.
  std::vector<double> observed(96, 0.0), expected(96, 0.0);
  const int samples = 200000;
  for (int i = 0; i < samples; ++i) {
    const auto index = static_cast<std::uint32_t>(i);
    const PositionSample<float> p = samplePosition(kBox, {randomFloat(index, 1), randomFloat(index, 2)});
    const Vec3f n = kBox.axes.toLocal(p.normal), at = kBox.axes.toLocal(p.position - kBox.center);
    const std::array<float, 3> units{at.x / kBox.half.x, at.y / kBox.half.y, at.z / kBox.half.z};
    const std::size_t axis = absolute(n.x) > 0.5f ? 0 : absolute(n.y) > 0.5f ? 1 : 2;
    const auto cell = [&](std::size_t k) {
      return static_cast<std::size_t>(std::clamp(static_cast<int>((units[k % 3] + 1.0f) * 2.0f), 0, 3));
    };
    observed[(axis * 2 + (units[axis] > 0.0f ? 1 : 0)) * 16 + cell(axis + 1) * 4 + cell(axis + 2)] += 1.0;
  }
  const std::array<double, 3> shares{8.0 / 14.0, 4.0 / 14.0, 2.0 / 14.0};
  for (std::size_t i = 0; i < 96; ++i) expected[i] = samples * shares[i / 32] / 32.0;
  EXPECT_GT(chiSquareTest(observed, expected).pValue, suiteLevel());
}

TEST(BoxSamplingStat, RejectsFacesOfEqualProbability) {
  // The faces' own densities, but each chosen with probability 1/2: the sum of pdfs is 1 all the same.
  const Vec3f from = placeAt({2.0f, 0.2f, 1.2f});
  CheckOptions options;
  options.grid = gridAbout(kBox, from);
  options.edgeShare = 0.005;
  const detail::BoxView<float> view(kBox, from);
  ASSERT_EQ(view.solidAngles[1], 0.0f);
  EXPECT_FALSE(checkDirectionSampler(
      [&](float choice, Vec2f u) {
        const float share = view.share(0);
        const float x = choice < 0.5f ? u.x * share : share + u.x * (1.0f - share);
        return sampleDirection(kBox, from, {std::min(x, kOneMinusEpsilon), u.y});
      },
      [&](Vec3f wi) { return static_cast<double>(pdfDirection(kBox, from, wi)); }, options));
}

}  // namespace
}  // namespace steradian::test
