#include "steradian/tests/materials/models.h"

#include <algorithm>

namespace steradian {
namespace {

using namespace steradian::test;

constexpr Transport kTransports[] = {Transport::Radiance, Transport::Importance};

TEST(Models, SampleIsWhatEvalSays) {
  forEachModel([](const std::string& name, const auto& model, const auto&) {
    for (const Transport transport : kTransports) {
      for (std::uint32_t i = 0; i < 2000; ++i) {
        SCOPED_TRACE(name + ", sample " + std::to_string(i));
        const Vec3f wo = randomDirection(i);
        const BsdfRandom<float> random = randomNumbers(i);
        const auto s = model.sample(wo, random, transport);
        ASSERT_EQ(s.pdf > 0.0f, s.lobe != 0u);
        if (s.pdf == 0.0f) continue;
        ASSERT_NEAR(length(s.wi), 1.0f, 2e-6f);
        ASSERT_EQ(s.pdf == kDirac, random.lobe < model.diracProbability(wo));
        ASSERT_EQ(s.pdf == kDirac, (s.lobe & kLobeDirac) != 0u);
        ASSERT_EQ(s.wi.z * wo.z > 0.0f, (s.lobe & kLobeReflection) != 0u);
        ASSERT_EQ(s.wi.z * wo.z < 0.0f, (s.lobe & kLobeTransmission) != 0u);
        if (s.pdf == kDirac) continue;
        const auto v = model.eval(wo, s.wi, transport);
        ASSERT_FLOAT_EQ(v.pdf, s.pdf);
        ASSERT_NEAR(s.weight.r * s.pdf, v.value.r, 1e-5f * v.value.r);
        ASSERT_NEAR(s.weight.g * s.pdf, v.value.g, 1e-5f * v.value.g);
        ASSERT_NEAR(s.weight.b * s.pdf, v.value.b, 1e-5f * v.value.b);
      }
    }
  });
}

TEST(Models, EightLanesGiveTheBitsOfOne) {
  using L = Lanes<8>;
  forEachModel([](const std::string& name, const auto& one, const auto& eight) {
    for (const Transport transport : kTransports) {
      for (std::uint32_t i = 0; i < 800; i += 8) {
        Vec3<L> wo, wi;
        BsdfRandom<L> random;
        for (int j = 0; j < 8; ++j) {
          const std::uint32_t k = i + static_cast<std::uint32_t>(j);
          setLane(wo, j, randomDirection(k));
          setLane(wi, j, randomDirection(k + 10000));
          setLane(random.lobe, j, randomNumbers(k).lobe);
          setLane(random.direction, j, randomNumbers(k).direction);
        }
        const auto s = eight.sample(wo, random, transport);
        const auto v = eight.eval(wo, wi, transport);
        const auto dirac = eight.diracProbability(wo);
        for (int j = 0; j < 8; ++j) {
          SCOPED_TRACE(name + ", sample " + std::to_string(i) + ", lane " + std::to_string(j));
          const BsdfRandom<float> r{lane(random.lobe, j), lane(random.direction, j)};
          const auto s1 = one.sample(lane(wo, j), r, transport);
          const auto v1 = one.eval(lane(wo, j), lane(wi, j), transport);
          ASSERT_EQ(s1.pdf, lane(s.pdf, j));
          ASSERT_EQ(s1.lobe, lane(s.lobe, j));
          ASSERT_EQ(one.diracProbability(lane(wo, j)), lane(dirac, j));
          ASSERT_EQ(v1.pdf, lane(v.pdf, j));
          ASSERT_EQ(v1.value.r, lane(v.value, j).r);
          ASSERT_EQ(v1.value.b, lane(v.value, j).b);
          if (s1.pdf == 0.0f) continue;
          ASSERT_EQ(s1.eta, lane(s.eta, j));
          ASSERT_EQ(s1.weight.r, lane(s.weight, j).r);
          ASSERT_EQ(s1.weight.g, lane(s.weight, j).g);
          ASSERT_EQ(s1.wi.x, lane(s.wi, j).x);
          ASSERT_EQ(s1.wi.y, lane(s.wi, j).y);
          ASSERT_EQ(s1.wi.z, lane(s.wi, j).z);
        }
      }
    }
  });
}

// Edges: along the normal, in the surface, and the extreme random numbers.
TEST(Models, NeverMakeNonFiniteValues) {
  const float numbers[] = {0.0f, 0x1p-24f, 0.5f, kOneMinusEpsilon};
  const Vec3f directions[] = {{0, 0, 1},     {0, 0, -1},      {1, 0, 0},         {0, -1, 0},
                              {1, 0, 1e-8f}, {1, 0, -1e-30f}, {0.6f, 0.0f, 0.8f}};
  forEachModel([&](const std::string& name, const auto& model, const auto&) {
    SCOPED_TRACE(name);
    for (const Transport transport : kTransports) {
      for (const Vec3f wo : directions) {
        for (const float a : numbers) {
          for (const float b : numbers) {
            for (const float c : numbers) {
              const auto s = model.sample(wo, {a, {b, c}}, transport);
              ASSERT_TRUE(isFinite(s.pdf) || s.pdf == kDirac);
              ASSERT_GE(s.pdf, 0.0f);
              if (s.pdf == 0.0f) continue;
              ASSERT_TRUE(isFinite(s.weight.r + s.weight.g + s.weight.b));
              ASSERT_TRUE(isFinite(lengthSquared(s.wi)));
            }
          }
        }
        for (const Vec3f wi : directions) {
          const auto v = model.eval(wo, wi, transport);
          ASSERT_TRUE(isFinite(v.pdf + v.value.r + v.value.g + v.value.b));
        }
      }
    }
  });
}

// A mirror reflects its reflectance at every angle, and the normal halves the angle between the directions.
TEST(Models, MirrorsReflectTheirShareUnderEveryAngle) {
  const Mirror<float> mirror{kColour};
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Vec3f wo = randomDirection(i);
    const auto s = mirror.sample(wo, randomNumbers(i), Transport::Radiance);
    ASSERT_EQ(s.pdf, kDirac);
    ASSERT_EQ(s.weight.r, kColour.r);
    ASSERT_EQ(s.weight.b, kColour.b);
    ASSERT_NEAR(length(cross(wo + s.wi, Vec3f{0.0f, 0.0f, 1.0f})), 0.0f, 1e-6f);
    ASSERT_EQ(s.wi.z, wo.z);
  }
}

template <class M>
void expectReciprocal(const M& model, Transport there, Transport back) {
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const Vec3f a = randomDirection(i), b = randomDirection(i + 5000);
    const float forward = model.eval(a, b, there).value.r / std::abs(b.z);
    const float backward = model.eval(b, a, back).value.r / std::abs(a.z);
    ASSERT_NEAR(forward, backward, 1e-5f * std::max(forward, backward)) << i;
  }
}

TEST(Models, LambertAndCoatAreReciprocal) {
  for (const Transport transport : kTransports) {
    expectReciprocal(Lambert<float>{kColour}, transport, transport);
    expectReciprocal(coated<float>(kColour, 1.5f), transport, transport);
  }
}

TEST(Models, FuzzyMetalCarriesImportanceByItsAdjoint) {
  for (const float fuzz : {0.3f, 0.9f, 1.0f}) {
    const FuzzyMetal<float> metal{kColour, fuzz};
    expectReciprocal(metal, Transport::Importance, Transport::Radiance);
    // And it is not reciprocal itself: otherwise the adjoint would not be needed.
    const Vec3f a = fromNormal(20.0), b = fromNormal(30.0, 205.0);
    const float there = metal.eval(a, b, Transport::Radiance).value.r / b.z;
    const float back = metal.eval(b, a, Transport::Radiance).value.r / a.z;
    ASSERT_GT(there, 0.0f);
    EXPECT_GT(std::abs(there - back), 0.05f * there);
  }
}

TEST(Models, UniformDiffuseCarriesImportanceByItsAdjoint) {
  const UniformDiffuse<float> surface{kColour};
  expectReciprocal(surface, Transport::Importance, Transport::Radiance);
  const Vec3f steep = fromNormal(20.0), flat = fromNormal(70.0);
  EXPECT_FLOAT_EQ(surface.eval(steep, flat, Transport::Radiance).value.r, kColour.r / (2.0f * kPi));
  EXPECT_FLOAT_EQ(surface.eval(flat, steep, Transport::Radiance).value.r, kColour.r / (2.0f * kPi));
  EXPECT_EQ(surface.eval(steep, -flat, Transport::Radiance).value.r, 0.0f);
}

// Light that crosses an interface and returns the same way is unchanged: directions, Fresnel factors, radiance.
TEST(Models, DielectricIsReciprocal) {
  for (const float eta : {1.5f, 0.75f}) {
    const Dielectric<float> glass{eta};
    for (const double degrees : {0.0, 20.0, 40.0, 48.0, 170.0, 150.0}) {
      const Vec3f wo = fromNormal(degrees);
      if (glass.reflectionProbability(wo) == 1.0f) continue;
      const auto there = glass.sample(wo, {kOneMinusEpsilon, {0.5f, 0.5f}}, Transport::Radiance);
      const auto back = glass.sample(there.wi, {kOneMinusEpsilon, {0.5f, 0.5f}}, Transport::Radiance);
      ASSERT_EQ(there.lobe, kLobeTransmission | kLobeDirac);
      EXPECT_NEAR(length(back.wi - wo), 0.0f, 1e-6f);
      EXPECT_NEAR(glass.reflectionProbability(wo), glass.reflectionProbability(there.wi), 1e-6f);
      EXPECT_NEAR(there.weight.r * back.weight.r, 1.0f, 1e-6f);
      EXPECT_NEAR(there.eta * back.eta, 1.0f, 1e-6f);
      EXPECT_FLOAT_EQ(there.weight.r, 1.0f / (there.eta * there.eta));
      EXPECT_FLOAT_EQ(there.eta, wo.z > 0.0f ? eta : 1.0f / eta);
      const auto importance = glass.sample(wo, {kOneMinusEpsilon, {0.5f, 0.5f}}, Transport::Importance);
      EXPECT_EQ(importance.weight.r, 1.0f);
      // Snell's law, and refraction stays in the plane of incidence.
      EXPECT_NEAR(std::hypot(wo.x, wo.y), there.eta * std::hypot(there.wi.x, there.wi.y), 1e-6f);
      EXPECT_NEAR(wo.x * there.wi.y, wo.y * there.wi.x, 1e-6f);
    }
  }
}

TEST(Models, DielectricReflectsWithFresnelsProbability) {
  const Dielectric<float> glass{1.5f};
  const auto reflects = [&](Vec3f wo, float lobe) {
    return (glass.sample(wo, {lobe, {0.5f, 0.5f}}, Transport::Radiance).lobe & kLobeReflection) != 0u;
  };
  EXPECT_TRUE(reflects({0, 0, 1}, 0.0399f));
  EXPECT_FALSE(reflects({0, 0, 1}, 0.0401f));
  // The critical angle of glass is 41.81 degrees, from within.
  EXPECT_FALSE(reflects(fromNormal(180.0 - 41.7), kOneMinusEpsilon));
  EXPECT_TRUE(reflects(fromNormal(180.0 - 41.9), kOneMinusEpsilon));
  EXPECT_TRUE((SchlickDielectric<float>{1.5f}
                   .sample(fromNormal(180.0 - 41.9), {kOneMinusEpsilon, {0.5f, 0.5f}}, Transport::Radiance)
                   .lobe &
               kLobeReflection) != 0u);
}

TEST(Models, FuzzOneIsTheCosineAboutTheMirrorDirection) {
  const FuzzyMetal<float> metal{grey(1.0f), 1.0f};
  const Vec3f wo = fromNormal(30.0), mirror = mirrored(wo);
  for (std::uint32_t i = 0; i < 500; ++i) {
    Vec3f wi = randomDirection(i);
    wi.z = std::abs(wi.z);
    const float expected = maximum(dot(wi, mirror), 0.0f) * kInvPi;
    EXPECT_NEAR(metal.eval(wo, wi, Transport::Radiance).pdf, expected, 1e-5f);
  }
}

// Rings about the mirror direction hold the share that the cumulative form says, 1 - q cos t / f. With sin t = f sin a
// the integrand is smooth.
TEST(Models, FuzzyMetalsDensityIsTheDerivativeOfItsShares) {
  for (const double fuzz : {0.001, 0.01, 0.1, 0.5, 0.9, 0.99, 1.0}) {
    const FuzzyMetal<float> metal{grey(1.0f), static_cast<float>(fuzz)};
    constexpr int steps = 4000, rings = 10;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double a = (i + 0.5) / steps * M_PI / 2.0;
      const double sinT = fuzz * std::sin(a), cosT = std::sqrt(1.0 - sinT * sinT);
      const Vec3f wi{static_cast<float>(sinT), 0.0f, static_cast<float>(cosT)};
      const double dt = fuzz * std::cos(a) / cosT * (M_PI / 2.0 / steps);
      sum += static_cast<double>(metal.eval({0, 0, 1}, wi, Transport::Radiance).pdf) * 2.0 * M_PI * sinT * dt;
      if ((i + 1) % (steps / rings) != 0) continue;
      const double edge = (i + 1.0) / steps * M_PI / 2.0, s = fuzz * std::sin(edge);
      const double share = 1.0 - std::cos(edge) * std::sqrt(std::max(1.0 - s * s, 0.0));
      // Half of the blurred edge is outside the cone, where this sum has no samples.
      const double blur = i + 1 == steps ? 0.6 * std::sqrt(3e-7 / fuzz) : 0.0;
      EXPECT_NEAR(sum, share, 5e-5 + blur) << fuzz << ", " << edge;
    }
  }
}

TEST(Models, CoatSharesAndAlbedo) {
  const Coated<float> black = coated<float>(grey(0.0f), 1.5f), white = coated<float>(grey(1.0f), 1.5f);
  for (const double degrees : {0.0, 30.0, 60.0, 85.0, 120.0}) {
    const Vec3f wo = fromNormal(degrees);
    EXPECT_EQ(black.diracProbability(wo), 1.0f);
    EXPECT_NEAR(white.diracProbability(wo), fresnelDielectric(std::abs(wo.z), 1.5f), 2e-6f);
    EXPECT_NEAR(white.albedo(wo).g, 1.0f, 2e-6f);
    EXPECT_NEAR(black.albedo(wo).g, fresnelDielectric(std::abs(wo.z), 1.5f), 2e-6f);
  }
}

}  // namespace
}  // namespace steradian
