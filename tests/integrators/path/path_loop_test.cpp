#include "steradian/integrators/path/path_loop.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "steradian/tests/integrators/small_scenes.h"

namespace steradian {
namespace {

constexpr ScatterPdf kKinds[]{ScatterPdf::Bsdf, ScatterPdf::Cosine, ScatterPdf::Hemisphere, ScatterPdf::Sphere};
const Vec3f kUp{0.0f, 0.0f, 1.0f};

std::vector<Bsdf> bsdfs() {
  const float internal = static_cast<float>(1.0 - diffuseTransmittance(1.0 / 1.5));
  return {Bsdf(Lambert<float>{grey(0.5f)}, kUp, kUp), Bsdf(Coated<float>{grey(0.5f), 1.5f, internal}, kUp, kUp)};
}

/// The origin of a plane that faces up, seen at an angle.
PathVertex<Bsdf> vertexOn(const Bsdf& bsdf, ScatterPdf kind = ScatterPdf::Bsdf) {
  static const InteriorStack none{};
  const Vec3f wo = normalize(Vec3f{0.9f, 0.0f, 0.3f});
  return {{{}, {}, kUp}, kUp, wo, bsdf, kind, bsdf.diracProbability(wo), true, &none, nullptr};
}

TEST(PathLoop, ScatterDensitiesIntegrateToTheShareOfContinuousLobes) {
  for (const Bsdf& bsdf : bsdfs()) {
    for (const ScatterPdf kind : kKinds) {
      const PathVertex vertex = vertexOn(bsdf, kind);
      double sum = 0.0;
      constexpr int n = 200;
      for (int i = 0; i < n * n; ++i) {
        const int column = i % n, row = i / n;
        const Vec2f u{(static_cast<float>(column) + 0.5f) / n, (static_cast<float>(row) + 0.5f) / n};
        const Vec3f wi = UniformSphere<float>::sample(u);
        const float bsdfPdf = bsdf.eval(vertex.wo, wi, Transport::Radiance).pdf;
        sum += static_cast<double>(scatterDensity(vertex, wi, bsdfPdf)) / (n * n);
      }
      EXPECT_NEAR(sum * 12.566370614, 1.0 - static_cast<double>(vertex.diracProbability), 1e-4);
    }
  }
}

TEST(PathLoop, ScatteredDirectionsHaveTheirDensity) {
  for (const Bsdf& bsdf : bsdfs()) {
    for (const ScatterPdf kind : kKinds) {
      const PathVertex vertex = vertexOn(bsdf, kind);
      for (std::uint32_t i = 0; i < 100; ++i) {
        const auto w = randomWords<std::uint32_t>(i, 1u, 2u, 3u);
        const BsdfRandom<float> random{kOneMinusEpsilon, {toUnitFloat<float>(w[0]), toUnitFloat<float>(w[1])}};
        const BsdfSample<float> s = sampleScatterPdf(vertex, random);
        if (s.pdf == 0.0f) continue;
        const BsdfValue<float> f = bsdf.eval(vertex.wo, s.wi, Transport::Radiance);
        EXPECT_FLOAT_EQ(s.pdf, scatterDensity(vertex, s.wi, f.pdf));
        EXPECT_NEAR(s.weight.g * s.pdf, f.value.g, 1e-5f * f.value.g);
      }
    }
  }
}

/// Returns the given light sample and records the random numbers that it was sampled with.
struct OneLight {
  LightSample<float> light;
  bool shadow = false;
  std::vector<LightRandom<float>> seen{};

  LightSample<float> sampleLight(const LightSet&, const ScatterPoint<float>&, const LightRandom<float>& random) {
    seen.push_back(random);
    return light;
  }
  float targetPdf(const TargetSet&, const ScatterPoint<float>&, Vec3f) const { return kInvFourPi; }
  bool occluded(const Ray<float>&) const { return shadow; }
  void countShadowRay() const {}
  const Volumes& volumes() const {
    static const Volumes none{SceneDescription{}};
    return none;
  }
  Hit<float> intersect(const Ray<float>&) const { return {}; }
  SurfacePoint<float> surfacePoint(const Ray<float>&, const Hit<float>&) const { return {}; }
};

class PathLoopWithPlan : public testing::Test {
 protected:
  PathPlan plan(ScatterPdf kind, std::uint32_t lightSamples) const {
    return {.strategy = Strategy::Mis,
            .scatterPdf = kind,
            .maxDepth = 5,
            .lightSamples = lightSamples,
            .rouletteStart = 8,
            .rouletteStrength = 1.0f,
            .targetWeight = 0.0f,
            .lights = &lights_,
            .diracLights = &lights_,
            .targets = nullptr};
  }

  const LightSet lights_{test::room(), Bounds3{{-1.0f, -1.0f, -1.0f}, {1.0f, 1.0f, 1.0f}}};
  const Sampler<float> sampler_{{}, 3u, 5u};
  const Vec3f wi_ = normalize(Vec3f{0.2f, -0.3f, 0.6f});
};

TEST_F(PathLoopWithPlan, WeightsOfLightSamplesAndOfHitsAddUpToOne) {
  const TargetSet targets(test::room());
  for (const Bsdf& bsdf : bsdfs()) {
    for (const ScatterPdf kind : kKinds) {
      const PathVertex vertex = vertexOn(bsdf, kind);
      const BsdfValue<float> f = bsdf.eval(vertex.wo, wi_, Transport::Radiance);
      for (const auto& [count, targetWeight] : {std::pair{1u, 0.0f}, {3u, 0.0f}, {1u, 0.3f}}) {
        OneLight queries{{grey(2.0f), wi_, 1.0f, 0.1f}};
        PathPlan mis = plan(kind, count);
        mis.targets = &targets;
        mis.targetWeight = targetWeight;
        const Rgb found = sampleDirectLight(mis, queries, vertex, sampler_, 0u);
        const float aimed = targetWeight * (1.0f - vertex.diracProbability) * kInvFourPi;
        const float scattering = aimed + (1.0f - targetWeight) * scatterDensity(vertex, wi_, f.pdf);
        const float hit =
            misWeight(competingDensity(Strategy::Mis, true, scattering), static_cast<float>(count) * queries.light.pdf);
        EXPECT_NEAR(found.g / (2.0f * f.value.g) + hit, 1.0f, 1e-6f) << count;
        queries.shadow = true;
        EXPECT_TRUE(isBlack(sampleDirectLight(mis, queries, vertex, sampler_, 0u)));
      }
    }
  }
}

TEST_F(PathLoopWithPlan, EverySampleHasNumbersOfItsOwn) {
  const std::vector<Bsdf> all = bsdfs();
  OneLight queries{{grey(2.0f), wi_, 1.0f, 0.1f}};
  for (std::uint32_t bounce = 0; bounce < 5; ++bounce) {
    sampleDirectLight(plan(ScatterPdf::Bsdf, 7), queries, vertexOn(all[0]), sampler_, bounce);
  }
  std::set<float> places;
  for (const LightRandom<float>& random : queries.seen) places.insert(random.position.x);
  EXPECT_EQ(queries.seen.size(), 35u);
  EXPECT_EQ(places.size(), 35u);
}

/// Targets all around.
struct TargetsEverywhere {
  DirectionSample<float> sampleTarget(const TargetSet&, const ScatterPoint<float>&, LightRandom<float> random) const {
    return SpherePdf<float>().sample(random.position);
  }
  float targetPdf(const TargetSet&, const ScatterPoint<float>&, Vec3f) const { return kInvFourPi; }
};

// The mean of 1 / pdf over the continuous samples is the solid angle that is scattered into, if they have that density.
TEST_F(PathLoopWithPlan, MixturesHaveTheDensityTheyTell) {
  const TargetSet targets(test::room());
  TargetsEverywhere queries;
  for (const Bsdf& bsdf : bsdfs()) {
    for (const ScatterPdf kind : kKinds) {
      const PathVertex vertex = vertexOn(bsdf, kind);
      PathPlan mixture = plan(kind, 1);
      mixture.targets = &targets;
      mixture.targetWeight = 0.7f;
      double sum = 0.0;
      constexpr std::uint32_t count = 1u << 14;
      for (std::uint32_t i = 0; i < count; ++i) {
        const Sampler<float> sampler({}, 3u, i);
        const BsdfRandom<float> random{sampler.get1D(0u, Purpose::BsdfLobe), sampler.get2D(0u, Purpose::BsdfDirection)};
        const BsdfSample<float> s = sampleMixture(mixture, queries, vertex, random, sampler, 0u);
        if (s.pdf > 0.0f && s.pdf != kDirac) sum += 1.0 / static_cast<double>(s.pdf);
      }
      EXPECT_NEAR(sum / count, 6.283185307, 0.06) << static_cast<int>(kind);
    }
  }
}

TEST(PathLoop, SurvivalIsAsProbableAsThePathIsBright) {
  EXPECT_FLOAT_EQ(survivalProbability(1.0f, {0.1f, 0.25f, 0.2f}, 1.0f), 0.25f);
  EXPECT_FLOAT_EQ(survivalProbability(1.0f, grey(0.25f), 2.25f), 0.5625f);
  EXPECT_FLOAT_EQ(survivalProbability(0.5f, grey(0.25f), 1.0f), 0.625f);
  EXPECT_FLOAT_EQ(survivalProbability(0.0f, grey(0.25f), 1.0f), 1.0f);
  EXPECT_FLOAT_EQ(survivalProbability(1.0f, grey(7.0f), 1.0f), 1.0f);
}

}  // namespace
}  // namespace steradian
