/// The spectrum of the error over a picture of pixels that all estimate the same integral.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "steradian/core/math/morton.h"
#include "steradian/core/samplers/sampler.h"

namespace steradian {
namespace {

using Word = std::uint32_t;
constexpr Word kSide = 64;
constexpr double kPiD = 3.14159265358979323846;

/// Of two points, drawn in two dimensions; 0 on average.
double smooth(Vec2f u, Vec2f) { return static_cast<double>(u.x) * u.y - 0.25; }
double edge(Vec2f u, Vec2f) { return u.x + 0.3f * u.y < 0.45f ? 0.7 : -0.3; }
double bounce(Vec2f u, Vec2f v) { return static_cast<double>(u.x) + v.y - 1.0; }

using Integrand = double (*)(Vec2f, Vec2f);

std::vector<double> errors(SamplerType type, Word seed, Word samples, Integrand f) {
  std::vector<double> picture;
  for (Word y = 0; y < kSide; ++y) {
    for (Word x = 0; x < kSide; ++x) {
      double sum = 0.0;
      for (Word i = 0; i < samples; ++i) {
        const Sampler<float> sampler({type, seed, samples, 1u}, mortonOf(x, y), i);
        sum += f(sampler.get2D(0u), sampler.get2D(4u));
      }
      picture.push_back(sum / samples);
    }
  }
  return picture;
}

/// Mean of |Fourier coefficient|^2 / pixels over the frequencies of at most 1/8 cycle per pixel in each direction, the
/// mean included. White noise: the variance of a pixel.
double lowFrequencyPower(const std::vector<double>& picture) {
  constexpr int maxFrequency = kSide / 8;
  double power = 0.0;
  int count = 0;
  for (int v = -maxFrequency; v <= maxFrequency; ++v) {
    for (int u = 0; u <= maxFrequency; ++u) {
      std::complex<double> sum = 0.0;
      for (Word y = 0; y < kSide; ++y) {
        for (Word x = 0; x < kSide; ++x) {
          const double phase = -2.0 * kPiD * (u * static_cast<double>(x) + v * static_cast<double>(y)) / kSide;
          sum += picture[y * kSide + x] * std::polar(1.0, phase);
        }
      }
      power += std::norm(sum) / (kSide * kSide);
      ++count;
    }
  }
  return power / count;
}

double variance(const std::vector<double>& picture) {
  double sum = 0.0;
  for (const double e : picture) sum += e * e;
  return sum / static_cast<double>(picture.size());
}

TEST(BlueNoiseSpectrum, TheErrorIsOfHighFrequency) {
  for (const Integrand f : {smooth, edge, bounce}) {
    for (const Word samples : {1u, 4u}) {
      const double blue = lowFrequencyPower(errors(SamplerType::BlueNoise, 7u, samples, f));
      const auto picture = errors(SamplerType::Sobol, 7u, samples, f);
      const double white = lowFrequencyPower(picture);
      EXPECT_LT(blue, 0.35 * white) << samples;
      EXPECT_NEAR(white, variance(picture), 0.5 * variance(picture)) << "the test of the test: Sobol's error is white";
    }
  }
}

TEST(BlueNoiseSpectrum, TheErrorIsMovedAndNotRemoved) {
  // A pixel by itself is as noisy as with Sobol. Over many seeds: the pixels of one share the scramble's upper levels.
  for (const Integrand f : {smooth, edge, bounce}) {
    for (const Word samples : {1u, 4u}) {
      constexpr Word seeds = 40;
      double blue = 0.0, white = 0.0;
      for (Word seed = 0; seed < seeds; ++seed) {
        blue += variance(errors(SamplerType::BlueNoise, seed, samples, f));
        white += variance(errors(SamplerType::Sobol, seed, samples, f));
      }
      EXPECT_NEAR(blue, white, 0.2 * white) << samples;
    }
  }
}

}  // namespace
}  // namespace steradian
