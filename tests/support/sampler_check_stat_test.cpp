/// Tests of the tests: the checks accept what is right and reject what is wrong by little.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "steradian/core/sampling/direction_pdf.h"
#include "steradian/tests/support/statistics.h"

namespace steradian::test {
namespace {

const Vec3f kAxis = normalize(Vec3f{0.2f, 0.9f, -0.4f});

class DirectionCheck : public testing::Test {
 protected:
  DirectionCheck() { options_.grid.axis = kAxis; }

  CosinePdf<float> cosine_{kAxis};
  CheckOptions options_;

  DirectionSample<float> draw(Vec2f u) const { return cosine_.sample(u); }
  double density(Vec3f wi) const { return cosine_.pdf(wi); }
};

TEST_F(DirectionCheck, AcceptsTheRightDensity) {
  EXPECT_TRUE(
      checkDirectionSampler([&](float, Vec2f u) { return draw(u); }, [&](Vec3f w) { return density(w); }, options_));
}

TEST_F(DirectionCheck, RejectsADensityTwoPercentTooLarge) {
  const auto sample = [&](float, Vec2f u) {
    auto s = draw(u);
    s.pdf *= 1.02f;
    return s;
  };
  EXPECT_FALSE(checkDirectionSampler(
      sample, [&](Vec3f w) { return 1.02 * density(w); }, options_));
}

TEST_F(DirectionCheck, RejectsADensityOfTheSameIntegralThatIsTwoPercentOff) {
  // 2 % from one side to the other, so that only chi-square can tell.
  const Vec3f side = Frame<float>::fromZ(kAxis).x;
  const auto wrong = [&](Vec3f w) { return density(w) * (1.0 + 0.02 * (dot(w, side) > 0.0f ? 1.0 : -1.0)); };
  const auto sample = [&](float, Vec2f u) {
    auto s = draw(u);
    s.pdf = static_cast<float>(wrong(s.wi));
    return s;
  };
  const auto result = checkDirectionSampler(sample, wrong, options_);
  EXPECT_FALSE(result);
  EXPECT_NE(std::string(result.message()).find("chi-square"), std::string::npos) << result.message();
}

TEST_F(DirectionCheck, RejectsAShiftedWarp) {
  const auto sample = [&](float, Vec2f u) {
    auto s = draw({u.x + 0.02f * u.x * (1.0f - u.x), u.y});
    return s;
  };
  EXPECT_FALSE(checkDirectionSampler(
      sample, [&](Vec3f w) { return density(w); }, options_));
}

TEST_F(DirectionCheck, RejectsAPdfThatDiffersFromTheSamples) {
  const auto sample = [&](float, Vec2f u) {
    auto s = draw(u);
    if (u.x > 0.999f) s.pdf *= 1.01f;
    return s;
  };
  EXPECT_FALSE(checkDirectionSampler(
      sample, [&](Vec3f w) { return density(w); }, options_));
}

TEST_F(DirectionCheck, RejectsSamplesOutsideOfTheSupport) {
  const auto sample = [&](float choice, Vec2f u) {
    auto s = draw(u);
    if (choice > 0.9999f && choice < 0.99999f) s.wi = -s.wi;
    return s;
  };
  EXPECT_FALSE(checkDirectionSampler(
      sample, [&](Vec3f w) { return density(w); }, options_));
  // Also where differences are allowed: a cell that nothing should reach.
  options_.edgeShare = 0.01;
  EXPECT_FALSE(checkDirectionSampler(
      sample, [&](Vec3f w) { return density(w); }, options_));
}

TEST_F(DirectionCheck, CountsMissingSamples) {
  // One in fifty is lost, which the density does not account for.
  const auto lossy = [&](float choice, Vec2f u) { return choice < 0.02f ? DirectionSample<float>{} : draw(u); };
  EXPECT_FALSE(checkDirectionSampler(
      lossy, [&](Vec3f w) { return density(w); }, options_));
  // The correct version: density and probability of no sample agree.
  const auto honest = [&](float choice, Vec2f u) {
    auto s = lossy(choice, u);
    s.pdf *= 0.98f;
    return s;
  };
  const auto less = [&](Vec3f w) { return 0.98 * density(w); };
  EXPECT_FALSE(checkDirectionSampler(honest, less, options_));
  options_.noSample = 0.02;
  EXPECT_TRUE(checkDirectionSampler(honest, less, options_));
  options_.noSample = std::nullopt;
  EXPECT_TRUE(checkDirectionSampler(honest, less, options_));
}

TEST_F(DirectionCheck, RejectsWhatIsNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto right = [&](Vec3f w) { return density(w); };
  const auto corner = [](Vec2f u) { return u.x == 0.0f && u.y == 0.0f; };
  const auto badDirection = [&](float, Vec2f u) {
    auto s = draw(u);
    if (corner(u)) s.wi.x = nan;
    return s;
  };
  const auto badPdf = [&](float, Vec2f u) {
    auto s = draw(u);
    if (corner(u)) s.pdf = nan;
    return s;
  };
  const auto dirac = [&](float, Vec2f u) {
    auto s = draw(u);
    if (corner(u)) s.pdf = kDirac;
    return s;
  };
  EXPECT_FALSE(checkDirectionSampler(badDirection, right, options_));
  EXPECT_FALSE(checkDirectionSampler(badPdf, right, options_));
  EXPECT_FALSE(checkDirectionSampler(dirac, right, options_));
  EXPECT_FALSE(
      checkDirectionSampler([&](float, Vec2f u) { return draw(u); }, [&](Vec3f) -> double { return nan; }, options_));
}

TEST(PlaneCheck, AcceptsTheTentAndRejectsItsNeighbours) {
  // Density 2 x on the unit square: x = sqrt(u).
  const auto sample = [](double exponent) {
    return [exponent](float, Vec2f u) {
      const double x = std::pow(1.0 - u.x, exponent);
      return PlaneSample{{static_cast<float>(x), u.y}, 2.0 * x};
    };
  };
  const auto pdf = [](Vec2f p) { return 2.0 * p.x; };
  EXPECT_TRUE(checkPlaneSampler(sample(0.5), pdf));
  EXPECT_FALSE(checkPlaneSampler(sample(0.51), pdf));
  EXPECT_FALSE(checkPlaneSampler([&](float c, Vec2f u) { return sample(0.5)(c, {u.x, u.y * 0.99f}); }, pdf));
  CheckOptions half;
  half.domain = {0.0, 0.5, 0.0, 1.0};
  EXPECT_FALSE(checkPlaneSampler(sample(0.5), pdf, half));
}

}  // namespace
}  // namespace steradian::test
