#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "steradian/core/samplers/sampler.h"
#include "steradian/tests/support/statistics.h"

namespace steradian {
namespace {

using namespace test;
using Word = std::uint32_t;

constexpr int kGrid = 16;

/// p-value of chi-square for `count` points against the uniform distribution of the square.
template <class Point>
double squarePValue(int count, Point&& point) {
  std::vector<double> counts(kGrid * kGrid, 0.0);
  for (int i = 0; i < count; ++i) {
    const Vec2f p = point(static_cast<Word>(i));
    counts[static_cast<std::size_t>(p.y * kGrid) * kGrid + static_cast<std::size_t>(p.x * kGrid)] += 1.0;
  }
  return chiSquareUniform(counts).pValue;
}

class SamplerStatistics : public testing::TestWithParam<SamplerType> {
 protected:
  static constexpr Word kSamples = 64;
  /// One sample of each of many pixels, so that points are independent.
  static Word sampleOf(Word pixel) { return mixBits(pixel ^ 0x1234567u) % kSamples; }
  Sampler<float> sampler(Word pixel, Word sample, Word seed = 0, Word replicates = 1) const {
    return {{GetParam(), seed, kSamples * replicates, replicates}, pixel, sample};
  }
  static constexpr int kCount = 100000;
};

TEST_P(SamplerStatistics, EachSampleIsUniformOverPixels) {
  for (const Word sample : {0u, 1u, 17u, 63u}) {
    EXPECT_GT(squarePValue(kCount, [&](Word i) { return sampler(i, sample).get2D(4u); }), suiteLevel()) << sample;
    EXPECT_GT(squarePValue(kCount, [&](Word i) { return sampler(7u, sample, i).get2D(4u); }), suiteLevel()) << "seeds";
    EXPECT_GT(squarePValue(kCount, [&](Word i) { return sampler(7u, sample).get2D(i); }), suiteLevel()) << "dimensions";
  }
}

TEST_P(SamplerStatistics, DimensionsAreIndependent) {
  for (const Word other : {1u, 2u, 10u, 1000u}) {
    const auto crossed = [&](Word i) {
      const auto s = sampler(i, sampleOf(i));
      return Vec2f{s.get2D(4u).x, s.get2D(4u + other).x};
    };
    EXPECT_GT(squarePValue(kCount, crossed), suiteLevel()) << other;
    const auto mixed = [&](Word i) {
      const auto s = sampler(i, sampleOf(i));
      return Vec2f{s.get2D(4u).y, s.get1D(4u + other)};
    };
    EXPECT_GT(squarePValue(kCount, mixed), suiteLevel()) << other;
  }
}

TEST_P(SamplerStatistics, PixelsSeedsAndReplicatesAreIndependent) {
  // Blue noise correlates the pixels of a square: there, pixels of two squares are tested.
  const bool tied = GetParam() == SamplerType::BlueNoise;
  EXPECT_GT(squarePValue(kCount,
                         [&](Word i) {
                           const Word a = tied ? i : 2 * i, b = tied ? i + (1u << 24) : 2 * i + 1;
                           return Vec2f{sampler(a, sampleOf(i)).get2D(0u).x, sampler(b, sampleOf(i)).get2D(0u).x};
                         }),
            suiteLevel());
  EXPECT_GT(squarePValue(kCount,
                         [&](Word i) {
                           return Vec2f{sampler(i, sampleOf(i), 0).get2D(0u).x, sampler(i, sampleOf(i), 1).get2D(0u).x};
                         }),
            suiteLevel());
  EXPECT_GT(squarePValue(kCount,
                         [&](Word i) {
                           return Vec2f{sampler(i, 2 * sampleOf(i), 0, 2).get2D(0u).x,
                                        sampler(i, 2 * sampleOf(i) + 1, 0, 2).get2D(0u).x};
                         }),
            suiteLevel());
}

TEST(SamplerRange, StratifiedNumbersAreNotRoundedUpToOne) {
  // In the last of 2^22 strata every eighth number would be; that of pixel 11 is one of them.
  constexpr Word count = 1u << 22;
  float largest = 0.0f;
  for (Word i = 0; i < count; ++i) {
    largest = std::max(largest, Sampler<float>({SamplerType::Stratified, 0u, count, 1u}, 11u, i).get1D(0u));
  }
  EXPECT_EQ(largest, kOneMinusEpsilon);
}

/// Mean and variance over pixels of the `kSamples`-sample estimate of f's integral.
template <class Function>
RunningMean estimates(const SamplerType type, Word samples, Word pixels, Function&& f) {
  RunningMean mean;
  for (Word pixel = 0; pixel < pixels; ++pixel) {
    double sum = 0.0;
    for (Word i = 0; i < samples; ++i) sum += f(Sampler<float>({type, 3u, samples, 1u}, pixel, i));
    mean.add(sum / samples);
  }
  return mean;
}

/// Smooth in the two coordinates of one dimension: where stratification pays. Integral (1 - 1/e)^2.
double smooth(const Sampler<float>& s) {
  const Vec2f p = s.get2D(3u);
  return std::exp(-static_cast<double>(p.x) - p.y);
}
/// A product over four dimensions, which padding treats as independent; integral 1/16.
double product(const Sampler<float>& s) {
  const Vec2f a = s.get2D(3u), b = s.get2D(14u);
  return static_cast<double>(a.x) * a.y * b.x * b.y;
}

TEST_P(SamplerStatistics, EstimatesAreUnbiased) {
  const double exact = std::pow(1.0 - std::exp(-1.0), 2);
  for (const Word samples : {1u, 5u, 16u, 64u}) {
    const RunningMean a = estimates(GetParam(), samples, 4000, smooth),
                      b = estimates(GetParam(), samples, 4000, product);
    EXPECT_GT(zTestPValue(a.mean(), a.standardError(), exact, 1e-6), suiteLevel()) << samples;
    EXPECT_GT(zTestPValue(b.mean(), b.standardError(), 0.0625, 1e-6), suiteLevel()) << samples;
  }
}

INSTANTIATE_TEST_SUITE_P(Types, SamplerStatistics, testing::ValuesIn(kSamplerTypes), [](const auto& type) {
  std::string name(nameOf(type.param));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

TEST(SamplerVariance, StratificationAndNetsPay) {
  const auto variance = [](SamplerType type, Word samples, auto f) {
    return estimates(type, samples, 1000, f).variance();
  };
  for (const Word samples : {64u, 256u}) {
    const double independent = variance(SamplerType::Independent, samples, smooth);
    const double stratified = variance(SamplerType::Stratified, samples, smooth);
    const double sobol = variance(SamplerType::Sobol, samples, smooth);
    // Theory: N^-1, N^-2, N^-3 for smooth integrands.
    EXPECT_LT(stratified, independent / (0.4 * samples)) << samples;
    EXPECT_LT(sobol, stratified / (0.03 * samples)) << samples;
    EXPECT_LT(variance(SamplerType::BlueNoise, samples, smooth), 3.0 * sobol) << samples;
    EXPECT_LT(variance(SamplerType::Pmj02, samples, smooth), 3.0 * sobol) << samples;
    // Padded dimensions never hurt: wrong shuffles make this grow with the number of samples.
    const double plain = variance(SamplerType::Independent, samples, product);
    for (const SamplerType type : kSamplerTypes) {
      if (type == SamplerType::Independent) continue;
      EXPECT_LT(variance(type, samples, product), 0.75 * plain) << samples << ' ' << nameOf(type);
    }
    // Without padding, the gain is joint in all four coordinates.
    EXPECT_LT(variance(SamplerType::SobolFull, samples, product), (samples == 256 ? 0.05 : 0.35) * plain) << samples;
  }
}

}  // namespace
}  // namespace steradian
