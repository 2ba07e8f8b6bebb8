#include "steradian/core/warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using test::sameInLanes;
using test::unitNumbers;

/// Samples of `warp` are unit vectors, and invert() gives the random numbers back.
template <class Warp>
void expectInverse(const Warp& warp, float tolerance) {
  const auto us = unitNumbers(2000), vs = unitNumbers(2000, 1);
  for (std::size_t i = 0; i < us.size(); ++i) {
    const Vec3f w = warp.sample({us[i], vs[i]});
    EXPECT_NEAR(length(w), 1.0f, 2e-7f);
    EXPECT_GT(warp.pdf(w), 0.0f);
    const Vec2f back = warp.invert(w);
    EXPECT_TRUE(back.x >= 0.0f && back.x < 1.0f && back.y >= 0.0f && back.y < 1.0f);
    EXPECT_NEAR(back.x, us[i], tolerance) << us[i] << ' ' << vs[i];
    // At the pole the azimuth means nothing, near it little; and 0 is 1.
    const float around = std::abs(back.y - vs[i]);
    const float sine = std::hypot(w.x, w.y);
    if (sine > 0.0f) {
      EXPECT_LT(std::min(around, 1.0f - around), tolerance) << us[i] << ' ' << vs[i];
    }
  }
}

TEST(Warp, SphereHemisphereAndConeInvert) {
  expectInverse(UniformSphere<float>{}, 3e-7f);
  expectInverse(UniformHemisphere<float>{}, 3e-7f);
  for (const float h : {2.0f, 1.0f, 0.3f, 1e-3f, 1e-7f, 1e-14f, 1e-36f}) expectInverse(UniformCone<float>{h}, 1e-6f);
}

template <class Warp>
void expectPlaneInverse(const Warp& warp, float tolerance) {
  const auto us = unitNumbers(2000), vs = unitNumbers(2000, 1);
  for (std::size_t i = 0; i < us.size(); ++i) {
    const auto p = warp.sample({us[i], vs[i]});
    EXPECT_GT(warp.pdf(p), 0.0f) << us[i] << ' ' << vs[i];
    const Vec2f back = warp.invert(p);
    EXPECT_TRUE(back.x >= 0.0f && back.x < 1.0f && back.y >= 0.0f && back.y < 1.0f);
    EXPECT_NEAR(back.x, us[i], tolerance) << us[i] << ' ' << vs[i];
    EXPECT_NEAR(back.y, vs[i], tolerance) << us[i] << ' ' << vs[i];
  }
}

TEST(Warp, DiskTriangleAndCosineInvert) {
  expectPlaneInverse(UniformDisk<float>{}, 5e-7f);
  expectPlaneInverse(UniformTriangle<float>{}, 3e-7f);
  expectPlaneInverse(CosineHemisphere<float>{}, 5e-7f);
}

TEST(Warp, PolesAndRims) {
  EXPECT_EQ(UniformSphere<float>::sample({0.0f, 0.3f}).z, 1.0f);
  EXPECT_NEAR(UniformSphere<float>::sample({kOneMinusEpsilon, 0.3f}).z, -1.0f, 2e-7f);
  EXPECT_EQ(UniformHemisphere<float>::sample({0.0f, 0.3f}).z, 1.0f);
  EXPECT_GT(UniformHemisphere<float>::sample({kOneMinusEpsilon, 0.3f}).z, 0.0f);
  EXPECT_EQ(UniformHemisphere<float>::pdf({0.0f, 0.6f, -0.8f}), 0.0f);
  EXPECT_EQ(CosineHemisphere<float>::pdf({0.0f, 0.6f, -0.8f}), 0.0f);
  EXPECT_EQ(CosineHemisphere<float>::sample({0.5f, 0.5f}).z, 1.0f);
  for (const float edge : {0.0f, kOneMinusEpsilon}) {
    const Vec3f w = CosineHemisphere<float>::sample({edge, 0.3f});
    EXPECT_GE(w.z, 3e-4f);
    EXPECT_NEAR(length(w), 1.0f, 2e-7f);
  }
  EXPECT_EQ(UniformDisk<float>::pdf({0.8f, 0.7f}), 0.0f);
  EXPECT_EQ(UniformTriangle<float>::pdf({0.6f, 0.5f}), 0.0f);
  EXPECT_EQ(UniformTriangle<float>::pdf({-0.1f, 0.5f}), 0.0f);
}

TEST(Warp, DiskKeepsTheLengthOfItsPoints) {
  const auto us = unitNumbers(500), vs = unitNumbers(500, 1);
  for (std::size_t i = 0; i < us.size(); ++i) {
    const auto p = UniformDisk<float>::concentric({us[i], vs[i]});
    EXPECT_NEAR(std::hypot(p.point.x, p.point.y), std::abs(p.radius), 2e-7f);
    EXPECT_EQ(std::abs(p.radius), std::max(std::abs(2.0f * us[i] - 1.0f), std::abs(2.0f * vs[i] - 1.0f)));
  }
}

TEST(Warp, ConesAreStableWhenTiny) {
  for (const float angle : {1e-2f, 1e-4f, 1e-6f, 1e-12f}) {
    const double exact = 2.0 * std::pow(std::sin(0.5 * static_cast<double>(angle)), 2);
    const UniformCone<float> cone{static_cast<float>(exact)};
    EXPECT_NEAR(cone.pdfInside() * 2.0 * 3.14159265358979 * exact, 1.0, 1e-6);
    const Vec3f rim = cone.sample({kOneMinusEpsilon, 0.125f});
    EXPECT_NEAR(std::hypot(rim.x, rim.y) / std::sin(static_cast<double>(angle)), 1.0, 1e-6);
    EXPECT_EQ(cone.pdf(normalize(Vec3f{1.01f * angle, 0.0f, 1.0f})), 0.0f);
    EXPECT_GT(cone.pdf(normalize(Vec3f{0.99f * angle, 0.0f, 1.0f})), 0.0f);
    EXPECT_EQ(cone.pdf({0.0f, 0.0f, -1.0f}), 0.0f);
  }
}

TEST(Warp, FlightsInvert) {
  for (const float rate : {1e-6f, 1.0f, 3e4f}) {
    const ExponentialFlight<float> flight{rate};
    for (const float u : unitNumbers(500)) {
      const float t = flight.sample(u);
      EXPECT_TRUE(t >= 0.0f && t <= 16.7f / rate) << u;
      EXPECT_NEAR(flight.invert(t), u, 2e-7f);
      EXPECT_NEAR(flight.pdf(t) / rate, 1.0f - u, 2e-7f);
    }
    EXPECT_EQ(flight.sample(0.0f), 0.0f);
    EXPECT_FALSE(std::signbit(flight.sample(0.0f)));
    EXPECT_EQ(flight.pdf(-1.0f), 0.0f);
  }
}

TEST(Warp, LanesAgreeWithScalars) {
  const auto us = unitNumbers(256), vs = unitNumbers(256, 1), hs = test::numbers(256, 1e-9f, 2.0f, 2);
  const auto direction = [](auto warp) {
    return [warp](auto u, auto v) {
      const auto w = warp(u).sample({u, v});
      const auto back = warp(u).invert(w);
      return w + Vec3{back.x, back.y, warp(u).pdf(w)};
    };
  };
  EXPECT_TRUE(sameInLanes<8>(direction([](auto u) { return UniformSphere<decltype(u)>{}; }), us, vs));
  EXPECT_TRUE(sameInLanes<8>(direction([](auto u) { return UniformHemisphere<decltype(u)>{}; }), us, vs));
  EXPECT_TRUE(sameInLanes<8>(direction([](auto u) { return CosineHemisphere<decltype(u)>{}; }), us, vs));
  EXPECT_TRUE(sameInLanes<8>(
      [](auto u, auto v, auto h) {
        const UniformCone<decltype(u)> cone{h};
        const auto w = cone.sample({u, v});
        const auto back = cone.invert(w);
        return w + Vec3{back.x, back.y, cone.pdf(w)};
      },
      us, vs, hs));
  const auto plane = [](auto warp) {
    return [warp](auto u, auto v) {
      const auto p = warp(u).sample({u, v});
      const auto back = warp(u).invert(p);
      return Vec3{p.x + back.x, p.y + back.y, warp(u).pdf(p)};
    };
  };
  EXPECT_TRUE(sameInLanes<8>(plane([](auto u) { return UniformDisk<decltype(u)>{}; }), us, vs));
  EXPECT_TRUE(sameInLanes<8>(plane([](auto u) { return UniformTriangle<decltype(u)>{}; }), us, vs));
  EXPECT_TRUE(sameInLanes<8>(
      [](auto u, auto rate) {
        const ExponentialFlight<decltype(u)> flight{rate};
        const auto t = flight.sample(u);
        return Vec3{t, flight.pdf(t), flight.invert(t)};
      },
      us, hs));
}

}  // namespace
}  // namespace steradian
