#include "steradian/lights/dirac_lights.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/core/samplers/rng.h"
#include "steradian/core/sampling/warp.h"

namespace steradian {
namespace {

const SpotLight kSpot{{1, 2, 3}, {0, -2, 0}, {5.0f, 4.0f, 3.0f}, 20.0f, 35.0f};

TEST(DiracLights, PointFallsOffWithTheSquare) {
  const PointLight light{{0, 3, 4}, {50.0f, 25.0f, 10.0f}};
  const LightSample<float> s = sampleLight(light, Vec3f{0, 0, 0});
  EXPECT_EQ(s.pdf, kDirac);
  EXPECT_FLOAT_EQ(s.distance, 5.0f);
  EXPECT_FLOAT_EQ(s.weight.r, 2.0f);
  EXPECT_FLOAT_EQ(s.wi.y, 0.6f);
  EXPECT_EQ(sampleLight(light, light.position).pdf, 0.0f);  // no direction there
}

TEST(DiracLights, SpotFallsOffBetweenItsAngles) {
  const PreparedSpot spot(kSpot);
  const auto at = [&](double degrees) {
    const auto t = static_cast<float>(std::tan(degrees * M_PI / 180.0));
    return sampleLight(spot, Vec3f{1.0f + t, 1.0f, 3.0f});
  };
  const auto intensity = [&](double degrees) {
    return at(degrees).weight.r * at(degrees).distance * at(degrees).distance;
  };
  EXPECT_FLOAT_EQ(intensity(0.0), 5.0f);
  EXPECT_FLOAT_EQ(intensity(19.9), 5.0f);
  EXPECT_EQ(at(35.1).pdf, 0.0f);
  EXPECT_EQ(sampleLight(spot, Vec3f{1, 5, 3}).pdf, 0.0f);  // behind
  // Half of the intensity at the middle cosine.
  const double middle = std::acos(0.5 * (std::cos(20.0 * M_PI / 180.0) + std::cos(35.0 * M_PI / 180.0))) * 180.0 / M_PI;
  EXPECT_NEAR(intensity(middle), 2.5f, 1e-4f);
}

TEST(DiracLights, SpotPowerIsTheIntegralOfItsIntensity) {
  for (const float inner : {0.0f, 20.0f, 35.0f}) {
    SpotLight light = kSpot;
    light.innerAngle = inner;
    const PreparedSpot spot(light);
    double sum = 0.0;
    constexpr int steps = 100000;
    for (int i = 0; i < steps; ++i) {
      const double cosine = -1.0 + 2.0 * (i + 0.5) / steps;
      sum += static_cast<double>(spot.falloff(static_cast<float>(cosine))) * 5.0 * 2.0 * M_PI * 2.0 / steps;
    }
    EXPECT_NEAR(static_cast<double>(powerOf(spot).r), sum, 1e-3) << inner;
  }
  // As wide as can be, it is a point light.
  EXPECT_NEAR(powerOf(PreparedSpot({{}, {0, 0, 1}, grey(1.0f), 180.0f, 180.0f})).g, kFourPi, 1e-5f);
  EXPECT_NEAR(powerOf(PointLight{{}, grey(1.0f)}).g, kFourPi, 1e-6f);
}

TEST(DiracLights, DistantIrradiance) {
  const DistantLight light{{0, -1, 0}, {2.0f, 1.0f, 0.5f}};
  const LightSample<float> s = sampleLight(light, Vec3f{7, 8, 9});
  EXPECT_EQ(s.pdf, kDirac);
  EXPECT_EQ(s.distance, kInfinity);
  EXPECT_EQ(s.wi.y, 1.0f);
  EXPECT_EQ(s.weight.r, 2.0f);
  EXPECT_FLOAT_EQ(powerOf(light, 3.0f).r, 2.0f * kPi * 9.0f);
}

template <class Light>
void expectLanesAgree(const Light& light) {
  using L = Lanes<8>;
  for (std::uint32_t i = 0; i < 200; i += 8) {
    Vec3<L> from;
    for (int j = 0; j < 8; ++j) {
      const auto w = randomWords<std::uint32_t>(i + static_cast<std::uint32_t>(j), 1u, 2u, 3u);
      setLane(from, j, Vec3f{toUnitFloat<float>(w[0]), toUnitFloat<float>(w[1]), toUnitFloat<float>(w[2])} * 4.0f);
    }
    setLane(from, 0, Vec3f{1, 2, 3});
    const auto wide = sampleLight(light, from);
    for (int j = 0; j < 8; ++j) {
      const auto one = sampleLight(light, lane(from, j));
      ASSERT_EQ(one.pdf, lane(wide.pdf, j));
      ASSERT_EQ(one.distance, lane(wide.distance, j));
      ASSERT_EQ(one.weight.r, lane(wide.weight, j).r);
      ASSERT_EQ(one.weight.b, lane(wide.weight, j).b);
      ASSERT_EQ(one.wi.x, lane(wide.wi, j).x);
      ASSERT_EQ(one.wi.z, lane(wide.wi, j).z);
    }
  }
}

TEST(DiracLights, EightLanesGiveTheBitsOfOne) {
  expectLanesAgree(PointLight{{1, 2, 3}, {5.0f, 4.0f, 3.0f}});
  expectLanesAgree(PreparedSpot(kSpot));
  expectLanesAgree(DistantLight{{0, -1, 0}, {2.0f, 1.0f, 0.5f}});
}

}  // namespace
}  // namespace steradian
