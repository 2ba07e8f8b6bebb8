#include "steradian/core/film/filter.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "steradian/core/base/diagnostics.h"
#include "steradian/core/samplers/sobol.h"
#include "steradian/tests/support/lanes_check.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using test::unitNumbers;

constexpr std::array<FilterType, 5> kTypes{FilterType::Box, FilterType::Triangle, FilterType::Gaussian,
                                           FilterType::Mitchell, FilterType::BlackmanHarris};

TEST(Filter, HasNames) {
  for (const FilterType type : kTypes) {
    EXPECT_EQ(filterTypeOf(nameOf(type)), type);
    EXPECT_EQ(filterOf(nameOf(type)).type(), type);
    EXPECT_EQ(filterOf(nameOf(type)).radius(), defaultRadius(type));
    EXPECT_EQ(filterOf(nameOf(type), 3.0f).radius(), 3.0f);
  }
  EXPECT_FALSE(filterTypeOf("sinc"));
  try {
    filterOf("gausian");
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.kind(), ErrorKind::Usage);
    EXPECT_NE(std::string(e.what()).find("did you mean \"gaussian\""), std::string::npos) << e.what();
  }
}

TEST(Filter, RejectsImpossibleRadii) {
  for (const float radius : {0.0f, -1.0f, 65.0f, kInfinity, std::numeric_limits<float>::quiet_NaN()}) {
    EXPECT_THROW(filterOf("box", radius), Error) << radius;
  }
}

TEST(Filter, ValuesAreTheFormulas) {
  // At the centre, half the radius and the rim, where values are known.
  EXPECT_EQ(Filter(FilterType::Box, 2.0f).value(1.9f), 1.0f);
  EXPECT_FLOAT_EQ(Filter(FilterType::Triangle, 2.0f).value(-0.5f), 0.75f);
  EXPECT_NEAR(Filter(FilterType::Gaussian, 1.5f).value(0.5f), std::exp(-0.5) - std::exp(-4.5), 1e-6);
  EXPECT_FLOAT_EQ(Filter(FilterType::Mitchell, 2.0f).value(0.0f), 16.0f);
  EXPECT_NEAR(Filter(FilterType::Mitchell, 2.0f).value(1.0f), 1.0f, 1e-5f);
  EXPECT_LT(Filter(FilterType::Mitchell, 2.0f).value(1.5f), 0.0f);
  EXPECT_FLOAT_EQ(Filter(FilterType::BlackmanHarris, 2.0f).value(0.0f), 1.0f);
  EXPECT_NEAR(Filter(FilterType::BlackmanHarris, 2.0f).value(1.0f), 0.35875 - 0.14128, 1e-6);
  for (const FilterType type : kTypes) {
    const Filter filter(type, 1.25f);
    EXPECT_EQ(filter.value(1.25f), 0.0f);
    EXPECT_EQ(filter.value(0.7f), filter.value(-0.7f));
    // Continuous at the rim, but for the box.
    if (type != FilterType::Box) {
      EXPECT_NEAR(filter.value(1.2499f) / filter.value(0.0f), 0.0, 1e-3) << nameOf(type);
    }
  }
}

using Function = double (*)(double, double);

/// The mean of weight * g(offset), against the same integral of the filter.
void expectMoment(const Filter& filter, Function g, double tolerance) {
  // Sobol' points resolve edges along the axes exactly, such as the sign of Mitchell's filter.
  constexpr std::uint32_t n = 1u << 17;
  double sampled = 0.0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec2f u{toUnitFloat<float>(sobolBitsX(i)), toUnitFloat<float>(sobolBitsY(i))};
    const auto s = filter.sample(Vec2f{u.x + 0.5f / n, u.y + 0.5f / n});
    sampled += static_cast<double>(s.weight) * g(s.offset.x, s.offset.y);
  }
  sampled /= n;
  const double r = filter.radius();
  const auto f = [&](double x, double y) {
    return static_cast<double>(filter.value(static_cast<float>(x))) * filter.value(static_cast<float>(y));
  };
  const test::Rectangle square{-r, r, -r, r};
  const double exact = test::integrate([&](double x, double y) { return f(x, y) * g(x, y); }, square, 1e-5) /
                       test::integrate(f, square, 1e-5);
  EXPECT_NEAR(sampled, exact, tolerance) << nameOf(filter.type());
}

TEST(Filter, SamplesHaveTheMomentsOfTheFilter) {
  for (const FilterType type : kTypes) {
    const Filter filter(type);
    expectMoment(
        filter, [](double, double) { return 1.0; }, 1e-4);
    expectMoment(
        filter, [](double x, double) { return x; }, 1e-4);
    expectMoment(
        filter, [](double x, double) { return x * x; }, 2e-4);
    expectMoment(
        filter, [](double x, double y) { return std::cos(1.3 * x) * std::cos(0.4 * y); }, 1e-4);
    expectMoment(
        filter, [](double x, double y) { return x > 0.3 && y > -0.2 ? 1.0 : 0.0; }, 2e-3);
  }
}

TEST(Filter, SamplesStayWithinTheRadius) {
  for (const FilterType type : kTypes) {
    const Filter filter(type);
    const auto us = unitNumbers(1000), vs = unitNumbers(1000, 1);
    const float magnitude = absolute(filter.sample(Vec2f{0.5f, 0.5f}).weight);
    for (std::size_t i = 0; i < us.size(); ++i) {
      const auto s = filter.sample(Vec2f{us[i], vs[i]});
      EXPECT_LE(std::abs(s.offset.x), filter.radius());
      EXPECT_LE(std::abs(s.offset.y), filter.radius());
      EXPECT_FLOAT_EQ(std::abs(s.weight), magnitude);
      if (type != FilterType::Mitchell) {
        EXPECT_EQ(s.weight, 1.0f);
      } else if (const float f = filter.value(s.offset.x) * filter.value(s.offset.y); f != 0.0f) {
        EXPECT_EQ(s.weight < 0.0f, f < 0.0f);
      }
    }
  }
}

TEST(Filter, LanesAgreeWithScalars) {
  const auto us = unitNumbers(256), vs = unitNumbers(256, 1);
  for (const FilterType type : kTypes) {
    const Filter filter(type);
    EXPECT_TRUE(test::sameInLanes<8>(
        [&](auto u, auto v) {
          const auto s = filter.sample(Vec2{u, v});
          return Vec3{s.offset.x, s.offset.y, s.weight};
        },
        us, vs));
  }
}

}  // namespace
}  // namespace steradian
