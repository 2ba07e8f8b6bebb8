#include "steradian/core/math/math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using test::numbers;
using test::sameInLanes;

constexpr double kTwoPiDouble = 6.28318530717958648;
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr int kCount = 200000;

/// The largest error of f over evenly spaced arguments, both ends included.
template <class Function, class Exact>
double worstError(float low, float high, Function f, Exact exact, bool relative = false) {
  double worst = 0.0;
  for (int i = 0; i <= kCount; ++i) {
    const double t = static_cast<double>(i) / kCount;
    const float x = static_cast<float>(low * (1.0 - t) + high * t);
    const double truth = exact(static_cast<double>(x));
    const double error = std::abs(static_cast<double>(f(x)) - truth);
    worst = std::max(worst, relative && truth != 0.0 ? error / std::abs(truth) : error);
  }
  return worst;
}

TEST(Math, SinCosReduced) {
  EXPECT_LT(
      worstError(
          -kPiOver4, kPiOver4, [](float x) { return sinCosReduced(x).sin; }, [](double x) { return std::sin(x); }),
      1e-7);
  EXPECT_LT(
      worstError(
          -kPiOver4, kPiOver4, [](float x) { return sinCosReduced(x).cos; }, [](double x) { return std::cos(x); }),
      1e-7);
  EXPECT_EQ(sinCosReduced(0.0f).sin, 0.0f);
  EXPECT_EQ(sinCosReduced(0.0f).cos, 1.0f);
}

TEST(Math, SinCosTwoPi) {
  for (const float range : {1.0f, 1024.0f}) {
    EXPECT_LT(worstError(
                  -range, range, [](float u) { return sinCosTwoPi(u).sin; },
                  [](double u) { return std::sin(kTwoPiDouble * u); }),
              2e-7);
    EXPECT_LT(worstError(
                  -range, range, [](float u) { return sinCosTwoPi(u).cos; },
                  [](double u) { return std::cos(kTwoPiDouble * u); }),
              2e-7);
  }
  // The axes are exact.
  for (int quarter = -4; quarter <= 4; ++quarter) {
    const auto s = sinCosTwoPi(0.25f * static_cast<float>(quarter));
    EXPECT_EQ(std::abs(s.sin), quarter % 2 == 0 ? 0.0f : 1.0f) << quarter;
    EXPECT_EQ(std::abs(s.cos), quarter % 2 == 0 ? 1.0f : 0.0f) << quarter;
  }
}

TEST(Math, SinCos) {
  for (const float range : {7.0f, 8192.0f}) {
    EXPECT_LT(worstError(
                  -range, range, [](float x) { return sinCos(x).sin; }, [](double x) { return std::sin(x); }),
              2e-7)
        << range;
    EXPECT_LT(worstError(
                  -range, range, [](float x) { return sinCos(x).cos; }, [](double x) { return std::cos(x); }),
              2e-7)
        << range;
  }
}

TEST(Math, ArcCos) {
  EXPECT_LT(worstError(
                -1.0f, 1.0f, [](float x) { return arcCos(x); }, [](double x) { return std::acos(x); }),
            4e-7);
  // Small angles keep their digits: relative error as x goes to 1.
  for (float x = 1.0f - 0x1p-24f, step = 0x1p-24f; x > 0.5f; step *= 1.5f, x = 1.0f - step) {
    EXPECT_NEAR(arcCos(x) / std::acos(static_cast<double>(x)), 1.0, 4e-7) << x;
  }
  EXPECT_EQ(arcCos(1.0f), 0.0f);
  EXPECT_EQ(arcCos(1.5f), 0.0f);
  EXPECT_EQ(arcCos(-1.5f), kPi);
}

TEST(Math, ArcTan2) {
  for (const float radius : {1e-30f, 1.0f, 1e30f}) {
    const auto worst = worstError(
        -kPi, kPi, [&](float a) { return arcTan2(radius * std::sin(a), radius * std::cos(a)); },
        [&](double a) {
          // The angle of the float vector, not of its argument.
          const float f = static_cast<float>(a);
          return std::atan2(static_cast<double>(radius * std::sin(f)), static_cast<double>(radius * std::cos(f)));
        });
    EXPECT_LT(worst, 4e-7) << radius;
  }
  EXPECT_EQ(arcTan2(0.0f, 0.0f), 0.0f);
  EXPECT_EQ(arcTan2(0.0f, 2.0f), 0.0f);
  EXPECT_EQ(arcTan2(0.0f, -2.0f), kPi);
  EXPECT_EQ(arcTan2(3.0f, 0.0f), kPiOver2);
  EXPECT_EQ(arcTan2(-3.0f, 0.0f), -kPiOver2);
}

TEST(Math, Exponential) {
  EXPECT_LT(worstError(
                -87.3f, 88.7f, [](float x) { return exponential(x); }, [](double x) { return std::exp(x); }, true),
            2e-7);
  EXPECT_EQ(exponential(0.0f), 1.0f);
  EXPECT_EQ(exponential(-88.0f), 0.0f);
  EXPECT_EQ(exponential(-kInfinity), 0.0f);
  EXPECT_EQ(exponential(89.0f), kInfinity);
  EXPECT_EQ(exponential(kInfinity), kInfinity);
}

TEST(Math, ExponentialMinusOneKeepsTheDigitsOfSmallNumbers) {
  const auto f = [](float x) { return exponentialMinusOne(x); };
  const auto exact = [](double x) { return std::expm1(x); };
  for (const float end : {88.7f, 1.0f, 1e-3f, 1e-9f, 1e-30f}) {
    EXPECT_LT(worstError(-end, 0.0f, f, exact, true), 4e-7) << end;
    EXPECT_LT(worstError(0.0f, end, f, exact, true), 4e-7) << end;
  }
  EXPECT_EQ(exponentialMinusOne(0.0f), 0.0f);
  EXPECT_EQ(exponentialMinusOne(-kInfinity), -1.0f);
  EXPECT_EQ(exponentialMinusOne(kInfinity), kInfinity);
}

TEST(Math, Logarithm) {
  const auto log = [](float x) { return logarithm(x); };
  const auto exact = [](double x) { return std::log(x); };
  EXPECT_LT(worstError(1e-6f, 1.0f, log, exact, true), 2e-7);
  EXPECT_LT(worstError(1.0f, 4.0f, log, exact, true), 2e-7);
  EXPECT_LT(worstError(4.0f, 3e38f, log, exact, true), 2e-7);
  for (float x = std::numeric_limits<float>::min(); x < 1e38f; x *= 1.37f) {
    EXPECT_NEAR(logarithm(x) / std::log(static_cast<double>(x)), 1.0, 2e-7) << x;
  }
  EXPECT_EQ(logarithm(1.0f), 0.0f);
  EXPECT_EQ(logarithm(0.0f), -kInfinity);
  EXPECT_EQ(logarithm(kInfinity), kInfinity);
  EXPECT_TRUE(std::isnan(logarithm(-1.0f)));
}

TEST(Math, Power) {
  for (const float y : {0.5f, 2.2f, 5.0f, -1.5f}) {
    EXPECT_LT(worstError(
                  0.05f, 20.0f, [&](float x) { return power(x, y); },
                  [&](double x) { return std::pow(x, static_cast<double>(y)); }, true),
              1e-5)
        << y;
  }
  EXPECT_EQ(power(0.0f, 2.0f), 0.0f);
}

TEST(Math, DifferenceOfProductsDoesNotCancel) {
  // 33962.035 * -30438.8 - 41563.4 * -24871.969 loses most digits when computed plainly.
  const float a = 33962.035f, b = -30438.8f, c = 41563.4f, d = -24871.969f;
  const double exact = static_cast<double>(a) * b - static_cast<double>(c) * d;
  EXPECT_NEAR(differenceOfProducts(a, b, c, d) / exact, 1.0, 3e-7);
  const auto xs = numbers(64, 1.0f, 1.001f), ys = numbers(64, 1.0f, 1.001f, 1);
  for (std::size_t i = 0; i < xs.size(); ++i) {
    const double truth = static_cast<double>(xs[i]) * xs[i] - static_cast<double>(ys[i]) * ys[i];
    EXPECT_NEAR(differenceOfProducts(xs[i], xs[i], ys[i], ys[i]), truth, 2e-7 * std::abs(truth)) << i;
  }
}

TEST(Math, SmallHelpers) {
  EXPECT_EQ(floorOf(2.7f), 2.0f);
  EXPECT_EQ(floorOf(-2.7f), -3.0f);
  EXPECT_EQ(floorOf(-3.0f), -3.0f);
  EXPECT_EQ(absolute(-0.0f), 0.0f);
  EXPECT_EQ(copySign(2.0f, -0.0f), -2.0f);
  EXPECT_EQ(clamp(5.0f, 0.0f, 1.0f), 1.0f);
  EXPECT_EQ(clamp(-5.0f, 0.0f, 1.0f), 0.0f);
  EXPECT_EQ(clamp(kNan, 0.0f, 1.0f), 0.0f);
  EXPECT_EQ(safeSqrt(-1e-9f), 0.0f);
  EXPECT_EQ(lerp(2.0f, 4.0f, 0.25f), 2.5f);
  EXPECT_TRUE(isFinite(-3e38f));
  EXPECT_FALSE(isFinite(kInfinity));
  EXPECT_FALSE(isFinite(-kInfinity));
  EXPECT_FALSE(isFinite(kNan));
  EXPECT_NEAR(gammaBound(3) / 3.0, 0x1p-24, 1e-13);
}

TEST(Math, LanesAgreeWithScalars) {
  const auto angle = numbers(512, -100.0f, 100.0f), unit = numbers(512, -1.1f, 1.1f, 1);
  const auto positive = numbers(512, 0.0f, 50.0f, 2);
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return sinCos(x).sin; }, angle));
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return sinCos(x).cos; }, angle));
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return sinCosTwoPi(x).sin; }, angle));
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return sinCosTwoPi(x).cos; }, angle));
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return arcCos(x); }, unit));
  EXPECT_TRUE(sameInLanes<8>([](auto x, auto y) { return arcTan2(y, x); }, angle, unit));
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return exponential(x); }, angle));
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return exponentialMinusOne(x); }, angle));
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return logarithm(x); }, positive));
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return logarithm(x); }, angle));
  EXPECT_TRUE(sameInLanes<8>([](auto x, auto y) { return power(x, y); }, positive, unit));
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return floorOf(x); }, angle));
  EXPECT_TRUE(sameInLanes<8>([](auto x, auto y) { return copySign(x, y); }, positive, unit));
  EXPECT_TRUE(
      sameInLanes<8>([](auto x, auto y, auto z) { return differenceOfProducts(x, y, y, z); }, angle, unit, positive));
  EXPECT_TRUE(sameInLanes<8>([](auto x, auto y) { return clamp(lerp(x, y, 0.3f), -1.0f, 2.0f); }, angle, unit));
  EXPECT_TRUE(sameInLanes<8>([](auto x) { return safeSqrt(x); }, angle));
  EXPECT_TRUE(sameInLanes<8>([](auto x, auto y) { return isFinite(x / (y - y)); }, angle, unit));
}

}  // namespace
}  // namespace steradian
