#pragma once
/// Samplers: random access to the coordinate (pixel, sample, dimension).
///
/// A dimension is bounce * kPurposeCount + purpose, never a running count, so that lanes at different bounces and
/// estimators with different branches stay aligned. One dimension has up to two coordinates: draw it once, by get1D or
/// by get2D.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>

#include "steradian/core/permutation.h"
#include "steradian/core/rng.h"
#include "steradian/core/sobol.h"

namespace steradian {

/// What a random number is for; one or two coordinates each.
enum class Purpose : std::uint32_t {
  Film,           ///< 2D, bounce 0 only: place in the pixel
  Lens,           ///< 2D, bounce 0 only
  Time,           ///< 1D, bounce 0 only
  BsdfLobe,       ///< 1D
  BsdfDirection,  ///< 2D
  LightSelect,    ///< 1D
  LightPosition,  ///< 2D
  Roulette,       ///< 1D
  Mixture,        ///< 1D: which density of the mixture
  Phase,          ///< 2D: scattering in a medium
  Count
};
inline constexpr std::uint32_t kPurposeCount = static_cast<std::uint32_t>(Purpose::Count);

template <class U>
U dimensionOf(U bounce, Purpose purpose) {
  return bounce * U(kPurposeCount) + U(static_cast<std::uint32_t>(purpose));
}

enum class SamplerType { Independent, Stratified, Sobol };
/// "independent", "stratified", "sobol"; nothing for any other name.
std::optional<SamplerType> samplerTypeOf(std::string_view name);
std::string_view nameOf(SamplerType type);

struct SamplerSettings {
  SamplerType type = SamplerType::Sobol;
  std::uint32_t seed = 0;
  std::uint32_t samplesPerPixel = 1;  ///< Stratified needs the count beforehand; the others are progressive
  std::uint32_t replicates = 1;       ///< R: sample i belongs to the independently scrambled sequence i mod R
};

/// The coordinates of one sample (width 1) or of several at once, each with a pixel and an index of its own.
///
/// Independent: pcg4d of (pixel, sample, dimension, seed).
/// Stratified: jittered, per dimension in its own random order: 1D in `count` strata, 2D in a grid of about sqrt(count)
/// x sqrt(count) cells, where count = samplesPerPixel / replicates; samples beyond the count begin another grid. Sobol:
/// Owen-scrambled copies of the first two Sobol' dimensions (core/sobol.h), an independent one per pixel, dimension and
/// replicate. Any aligned block of 2^m consecutive samples is a (0,m,2)-net in each dimension.
template <class F>
class Sampler {
 public:
  Sampler(const SamplerSettings& settings, UintOf<F> pixel, UintOf<F> sample)
      : settings_(settings), pixel_(pixel), sample_(sample), index_(sample) {
    if (settings.replicates > 1) index_ = divide(sample, settings.replicates, replicate_);
    if (settings.type == SamplerType::Sobol) index_ = reverseBits(index_);
  }

  /// In [0, 1).
  F get1D(UintOf<F> dimension) const {
    switch (settings_.type) {
      case SamplerType::Independent:
        return toUnitFloat<F>(independentWords(dimension)[0]);
      case SamplerType::Stratified:
        return stratified1D(dimension);
      case SamplerType::Sobol:
        break;
    }
    const auto key = sequenceKey(dimension, replicate_);
    return owenSobol1D<F>(index_, key[0], key[1]);
  }

  /// In [0, 1)^2.
  Vec2<F> get2D(UintOf<F> dimension) const {
    switch (settings_.type) {
      case SamplerType::Independent: {
        const auto words = independentWords(dimension);
        return {toUnitFloat<F>(words[0]), toUnitFloat<F>(words[1])};
      }
      case SamplerType::Stratified:
        return stratified2D(dimension);
      case SamplerType::Sobol:
        break;
    }
    const auto key = sequenceKey(dimension, replicate_);
    return owenSobol2D<F>(index_, key[0], key[1], key[2]);
  }

  F get1D(UintOf<F> bounce, Purpose purpose) const { return get1D(dimensionOf(bounce, purpose)); }
  Vec2<F> get2D(UintOf<F> bounce, Purpose purpose) const { return get2D(dimensionOf(bounce, purpose)); }

  const SamplerSettings& settings() const { return settings_; }
  UintOf<F> pixel() const { return pixel_; }
  UintOf<F> sample() const { return sample_; }

 private:
  using Uint = UintOf<F>;
  using Words = std::array<Uint, 4>;

  /// Quotient; the remainder goes to `remainder`. (No machine divides vectors of integers.)
  static Uint divide(Uint dividend, std::uint32_t divisor, Uint& remainder) {
    Uint quotient(0u);
    for (int i = 0; i < widthOf<F>; ++i) {
      setLane(quotient, i, lane(dividend, i) / divisor);
      setLane(remainder, i, lane(dividend, i) % divisor);
    }
    return quotient;
  }

  Words independentWords(Uint dimension) const { return randomWords(pixel_, sample_, dimension, Uint(settings_.seed)); }
  /// What all samples of one sequence share.
  Words sequenceKey(Uint dimension, Uint sequence) const {
    return randomWords(pixel_, dimension, sequence, Uint(settings_.seed ^ 0x50b01u));
  }

  /// The number of the stratum among `strata` >= count, different for the samples of one grid.
  Uint stratum(Uint dimension, std::uint32_t count, std::uint32_t strata) const {
    Uint place(0u);
    const Uint grid = divide(index_, count, place);
    return permute(place, strata, sequenceKey(dimension, replicate_ ^ (mixBits(grid) << 8)));
  }
  /// Samples of one grid; no more than floats can tell apart.
  std::uint32_t strataCount() const {
    const std::uint32_t replicates = settings_.replicates > 1 ? settings_.replicates : 1;
    const std::uint32_t count = settings_.samplesPerPixel / replicates + (settings_.samplesPerPixel % replicates != 0);
    return std::clamp(count, 1u, 1u << 24);
  }
  /// (cell + jitter) / cells; rounding must not reach 1.
  static F jittered(Uint cell, Uint jitter, std::uint32_t cells) {
    const F x = (toFloat(toSigned(cell)) + toUnitFloat<F>(jitter)) / F(static_cast<float>(cells));
    return minimum(x, F(kOneMinusEpsilon));
  }
  F stratified1D(Uint dimension) const {
    const std::uint32_t count = strataCount();
    return jittered(stratum(dimension, count, count), independentWords(dimension)[0], count);
  }
  Vec2<F> stratified2D(Uint dimension) const {
    const std::uint32_t count = strataCount();
    // Columns times rows may exceed the count: then some random cells stay empty, and each sample is uniform still.
    const auto columns = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
    const std::uint32_t rows = (count + columns - 1) / columns;
    Uint column(0u);
    const Uint row = divide(stratum(dimension, count, columns * rows), columns, column);
    const Words jitter = independentWords(dimension);
    return {jittered(column, jitter[0], columns), jittered(row, jitter[1], rows)};
  }

  SamplerSettings settings_;
  Uint pixel_, sample_;
  Uint index_;  ///< in its sequence; bit-reversed for Sobol
  Uint replicate_ = Uint(0u);
};

}  // namespace steradian
