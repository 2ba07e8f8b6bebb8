#include <algorithm>
#include <cmath>
#include <functional>

#include "steradian/core/math/frame.h"
#include "steradian/tests/materials/models.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using namespace steradian::test;

/// The continuous part as a sampler of directions: samples of a Dirac lobe count as "no sample".
template <class M>
testing::AssertionResult checkModel(const M& model, Vec3f wo, CheckOptions options) {
  const auto sample = [&](float choice, Vec2f u) {
    const auto s = model.sample(wo, {choice, u}, Transport::Radiance);
    return DirectionSample<float>{s.wi, s.pdf == kDirac ? 0.0f : s.pdf};
  };
  return checkDirectionSampler(
      sample, [&](Vec3f wi) { return static_cast<double>(model.eval(wo, wi, Transport::Radiance).pdf); }, options);
}

TEST(ModelsStat, Lambert) {
  EXPECT_TRUE(checkModel(Lambert<float>{kColour}, fromNormal(50.0), {}));
  EXPECT_TRUE(checkModel(Lambert<float>{kColour}, fromNormal(130.0), {}));
}

TEST(ModelsStat, UniformDiffuse) {
  EXPECT_TRUE(checkModel(UniformDiffuse<float>{kColour}, fromNormal(50.0), {}));
  EXPECT_TRUE(checkModel(UniformDiffuse<float>{kColour}, fromNormal(130.0), {}));
}

/// Cells of equal probability about the mirror direction, by the cumulative form of the share within the angle t,
/// 1 - q cos t / f, and by azimuth.
struct FuzzCells {
  static constexpr int rings = 12, sectors = 16;
  Frame<float> axes;
  double fuzz;

  std::size_t cellOf(Vec3f wi) const {
    const Vec3f w = axes.toLocal(wi);
    const double sinSquared = static_cast<double>(w.x * w.x + w.y * w.y);
    const double share = 1.0 - std::sqrt(std::max(fuzz * fuzz - sinSquared, 0.0)) * static_cast<double>(w.z) / fuzz;
    const double turn = std::atan2(static_cast<double>(w.y), static_cast<double>(w.x)) / (2.0 * M_PI) + 0.5;
    const auto index = [](double x, int n) {
      return static_cast<std::size_t>(std::clamp(static_cast<int>(x * n), 0, n - 1));
    };
    return index(share, rings) * sectors + index(turn, sectors);
  }
  /// The direction of a share and a turn, by the inverse: cos^2 t solves c^2 (f^2 - 1 + c^2) = f^2 (1 - share)^2.
  Vec3f direction(double share, double turn) const {
    const double b = 1.0 - fuzz * fuzz, k = fuzz * (1.0 - share);
    const double cosT = std::sqrt(0.5 * (b + std::sqrt(b * b + 4.0 * k * k))),
                 sinT = std::sqrt(std::max(1.0 - cosT * cosT, 0.0));
    const double phi = 2.0 * M_PI * (turn - 0.5);
    return axes.toWorld(
        {static_cast<float>(sinT * std::cos(phi)), static_cast<float>(sinT * std::sin(phi)), static_cast<float>(cosT)});
  }
  /// Probabilities of the cells when what is below the horizon is lost; the last one is the loss.
  std::vector<double> probabilities(float side) const {
    constexpr int fine = 40;
    std::vector<double> p(rings * sectors + 1, 0.0);
    for (int i = 0; i < rings * fine; ++i) {
      for (int j = 0; j < sectors * fine; ++j) {
        const bool kept = direction((i + 0.5) / (rings * fine), (j + 0.5) / (sectors * fine)).z * side > 0.0f;
        p[kept ? static_cast<std::size_t>(i / fine * sectors + j / fine) : rings * sectors] += 1.0;
      }
    }
    for (double& x : p) x /= rings * fine * sectors * fine;
    return p;
  }
};

// Samples by the book's recipe have the density in closed form, and those below the horizon are absorbed.
TEST(ModelsStat, FuzzyMetalAbsorptionIncluded) {
  constexpr std::uint32_t samples = 100000;
  for (const float fuzz : {0.001f, 0.05f, 0.3f, 0.7f, 1.0f}) {
    for (const double degrees : {0.0, 45.0, 80.0, 100.0}) {
      const Vec3f wo = fromNormal(degrees);
      const FuzzyMetal<float> metal{kColour, fuzz};
      const FuzzCells cells{Frame<float>::fromZ(mirrored(wo)), static_cast<double>(fuzz)};
      std::vector<double> expected = cells.probabilities(wo.z), observed(expected.size(), 0.0);
      for (double& e : expected) e *= samples;
      for (std::uint32_t i = 0; i < samples; ++i) {
        const auto s = metal.sample(wo, randomNumbers(i), Transport::Radiance);
        observed[s.pdf > 0.0f ? cells.cellOf(s.wi) : expected.size() - 1] += 1.0;
      }
      EXPECT_GT(chiSquareTest(observed, expected).pValue, suiteLevel())
          << fuzz << ", " << degrees << ": " << observed.back() << " lost, " << expected.back() << " expected";
      if (expected.back() == 0.0) {
        EXPECT_EQ(observed.back(), 0.0);
      }
    }
  }
}

TEST(ModelsStat, Coat) {
  for (const float eta : {1.5f, 0.75f}) {
    for (const double degrees : {0.0, 30.0, 45.0, 75.0, 110.0}) {
      const Vec3f wo = fromNormal(degrees);
      const Coated<float> varnish = coated<float>(kColour, eta);
      if (varnish.diracProbability(wo) == 1.0f) continue;  // total reflection
      CheckOptions options;
      options.noSample = static_cast<double>(varnish.diracProbability(wo));
      options.samples = 200000;
      EXPECT_TRUE(checkModel(varnish, wo, options)) << eta << ", " << degrees;
    }
  }
}

// Furnace: under a white sky a white surface reflects all light, and others never more than their reflectance.
TEST(ModelsStat, FurnaceByQuadrature) {
  // These two do not depend on the azimuth.
  const auto reflected = [](const auto& model, Vec3f wo) {
    constexpr int steps = 20000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const auto cosine = static_cast<float>((i + 0.5) / steps);
      const Vec3f wi{safeSqrt(1.0f - cosine * cosine), 0.0f, copySign(cosine, wo.z)};
      sum += static_cast<double>(model.eval(wo, wi, Transport::Radiance).value.g);
    }
    return sum * 2.0 * M_PI / steps;
  };
  for (const double degrees : {0.0, 30.0, 60.0, 85.0, 140.0}) {
    const Vec3f wo = fromNormal(degrees);
    EXPECT_NEAR(reflected(Lambert<float>{grey(1.0f)}, wo), 1.0, 1e-5);
    EXPECT_NEAR(reflected(Lambert<float>{kColour}, wo), 0.5, 1e-5);
    EXPECT_NEAR(reflected(UniformDiffuse<float>{kColour}, wo), 0.5, 1e-5);
    for (const float eta : {1.3f, 1.5f, 2.5f, 0.75f}) {
      const double mirror = static_cast<double>(fresnelDielectric(std::abs(wo.z), eta));
      EXPECT_NEAR(mirror + reflected(coated<float>(grey(1.0f), eta), wo), 1.0, 1e-4) << eta << ", " << degrees;
      const Coated<float> varnish = coated<float>(kColour, eta);
      EXPECT_NEAR(mirror + reflected(varnish, wo), static_cast<double>(varnish.albedo(wo).g), 1e-4)
          << eta << ", " << degrees;
    }
  }
}

/// Mean and error of the weights, lost samples counting as 0.
template <class M>
RunningMean furnace(const M& model, Vec3f wo, std::uint32_t samples) {
  RunningMean mean;
  for (std::uint32_t i = 0; i < samples; ++i) {
    const auto s = model.sample(wo, randomNumbers(i), Transport::Radiance);
    mean.add(s.pdf > 0.0f ? static_cast<double>(s.weight.g) : 0.0);
  }
  return mean;
}

// The same by sampling: both lobes of the coat with their probabilities.
TEST(ModelsStat, FurnaceBySampling) {
  for (const double degrees : {0.0, 40.0, 80.0, 150.0}) {
    const Vec3f wo = fromNormal(degrees);
    for (const float eta : {1.5f, 0.75f}) {
      const RunningMean white = furnace(coated<float>(grey(1.0f), eta), wo, 100000);
      EXPECT_GT(zTestPValue(white.mean(), white.standardError(), 1.0, 1e-5), suiteLevel()) << degrees;
      const Coated<float> varnish = coated<float>(kColour, eta);
      const RunningMean coloured = furnace(varnish, wo, 100000);
      EXPECT_GT(zTestPValue(coloured.mean(), coloured.standardError(), static_cast<double>(varnish.albedo(wo).g), 1e-5),
                suiteLevel())
          << degrees;
    }
    EXPECT_LE(furnace(FuzzyMetal<float>{grey(1.0f), 0.8f}, wo, 20000).mean(), 1.0 + 1e-6);
  }
}

// A pane of glass with all its inner reflections passes (1 - R) / (1 + R), whichever transport is used: the radiance
// scalings of its two faces cancel.
TEST(ModelsStat, PaneOfGlassPassesTheTextbookShare) {
  const Dielectric<float> glass{1.5f};
  for (const Transport transport : {Transport::Radiance, Transport::Importance}) {
    for (const double degrees : {0.0, 45.0, 75.0}) {
      RunningMean passed;
      for (std::uint32_t path = 0; path < 200000; ++path) {
        // Both faces have their normals outward: the lower face sees the path mirrored.
        Vec3f wo = fromNormal(degrees);
        float weight = 1.0f;
        bool inside = false, through = false;
        for (std::uint32_t bounce = 0; bounce < 64; ++bounce) {
          const auto random = randomWords<std::uint32_t>(path, bounce, 17u, 4u);
          const auto s = glass.sample(wo, {toUnitFloat<float>(random[0]), {0.5f, 0.5f}}, transport);
          weight *= s.weight.r;
          if ((s.lobe & kLobeTransmission) != 0u) {
            if (inside) {
              through = bounce % 2 == 1;
              break;
            }
            inside = true;
          } else if (!inside) {
            break;
          }
          // Arrive at the opposite face from inside.
          wo = {-s.wi.x, -s.wi.y, -std::abs(s.wi.z)};
        }
        passed.add(through ? static_cast<double>(weight) : 0.0);
      }
      const double r = static_cast<double>(fresnelDielectric(fromNormal(degrees).z, 1.5f));
      EXPECT_GT(zTestPValue(passed.mean(), passed.standardError(), (1.0 - r) / (1.0 + r), 1e-5), suiteLevel())
          << degrees;
    }
  }
}

// The checks must be able to fail: two percent.
TEST(ModelsStat, WrongDensitiesAreRejected) {
  const Lambert<float> model{kColour};
  const Vec3f wo = fromNormal(40.0);
  const auto check = [&](const std::function<float(Vec3f)>& factor) {
    const auto pdf = [&](Vec3f wi) { return factor(wi) * model.eval(wo, wi, Transport::Radiance).pdf; };
    return checkDirectionSampler(
        [&](float choice, Vec2f u) {
          const Vec3f wi = model.sample(wo, {choice, u}, Transport::Radiance).wi;
          return DirectionSample<float>{wi, pdf(wi)};
        },
        [&](Vec3f wi) { return static_cast<double>(pdf(wi)); });
  };
  EXPECT_TRUE(check([](Vec3f) { return 1.0f; }));
  EXPECT_FALSE(check([](Vec3f) { return 1.02f; }));
  EXPECT_FALSE(check([](Vec3f wi) { return wi.x > 0.0f ? 1.02f : 0.98f; }));
}

}  // namespace
}  // namespace steradian
