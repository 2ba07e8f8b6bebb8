#include "steradian/lights/sky.h"

#include <gtest/gtest.h>

#include "steradian/core/samplers/rng.h"

namespace steradian {
namespace {

TEST(Sky, IsLinearInTheHeightOfTheDirection) {
  Sky sky{};
  sky.add(GradientSky{{1.0f, 1.0f, 1.0f}, {0.5f, 0.7f, 1.0f}});
  EXPECT_FLOAT_EQ(sky.radiance(Vec3f{0, 1, 0}).r, 0.5f);
  EXPECT_FLOAT_EQ(sky.radiance(Vec3f{0, -1, 0}).r, 1.0f);
  EXPECT_FLOAT_EQ(sky.radiance(Vec3f{0.6f, 0, 0.8f}).g, 0.85f);
  EXPECT_NEAR(sky.total().r, 0.75f * kFourPi, 1e-5f);
}

TEST(Sky, EightLanesGiveTheBitsOfOne) {
  using L = Lanes<8>;
  const Sky sky{{0.1f, 0.2f, 0.3f}, {0.9f, 0.5f, 0.4f}};
  for (std::uint32_t i = 0; i < 400; i += 8) {
    Vec3<L> normal;
    Vec2<L> u;
    for (int j = 0; j < 8; ++j) {
      const auto w = randomWords<std::uint32_t>(i + static_cast<std::uint32_t>(j), 1u, 2u, 3u);
      setLane(u, j, {toUnitFloat<float>(w[0]), toUnitFloat<float>(w[1])});
      const Vec3f n = UniformSphere<float>::sample({toUnitFloat<float>(w[2]), toUnitFloat<float>(w[3])});
      setLane(normal, j, j == 3 ? Vec3f{} : n);
    }
    const auto wide = sampleSky(normal, u);
    const auto radiance = sky.radiance(wide.wi);
    for (int j = 0; j < 8; ++j) {
      const auto one = sampleSky(lane(normal, j), lane(u, j));
      ASSERT_EQ(one.pdf, lane(wide.pdf, j));
      ASSERT_EQ(one.pdf, skyPdf(lane(normal, j), one.wi));
      ASSERT_EQ(one.wi.x, lane(wide.wi, j).x);
      ASSERT_EQ(one.wi.y, lane(wide.wi, j).y);
      ASSERT_EQ(one.wi.z, lane(wide.wi, j).z);
      ASSERT_EQ(sky.radiance(one.wi).g, lane(radiance, j).g);
    }
  }
}

}  // namespace
}  // namespace steradian
