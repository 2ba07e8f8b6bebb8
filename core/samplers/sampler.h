#pragma once
/// Samplers: random access to the coordinate (pixel, sample, dimension).
///
/// A dimension is bounce * kPurposeCount + purpose, never a running count, so that lanes at different bounces and
/// estimators with different branches stay aligned. One dimension has up to two coordinates: draw it once, by get1D or
/// by get2D.
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "steradian/core/samplers/blue_noise.h"
#include "steradian/core/samplers/halton.h"
#include "steradian/core/samplers/pmj02.h"
#include "steradian/core/samplers/rng.h"
#include "steradian/core/samplers/sample_dimension.h"
#include "steradian/core/samplers/sobol.h"
#include "steradian/core/samplers/sobol_full.h"
#include "steradian/core/samplers/stratified.h"

namespace STERADIAN_API steradian {

/// See Sampler for what they are.
enum class SamplerType { Independent, Stratified, Halton, Sobol, SobolFull, BlueNoise, Pmj02 };
inline constexpr std::array kSamplerTypes{SamplerType::Independent, SamplerType::Stratified, SamplerType::Halton,
                                          SamplerType::Sobol,       SamplerType::SobolFull,  SamplerType::BlueNoise,
                                          SamplerType::Pmj02};
/// "independent", "stratified", "halton", "sobol", "sobol-full", "blue-noise", "pmj02"; nothing for any other name.
std::optional<SamplerType> samplerTypeOf(std::string_view name);
std::string_view nameOf(SamplerType type);

/// Whether the points depend on the number of samples: Stratified and BlueNoise. All others are progressive: the first
/// samples of a longer render are those of a shorter one.
constexpr bool needsSampleCount(SamplerType type) {
  return type == SamplerType::Stratified || type == SamplerType::BlueNoise;
}

struct SamplerSettings {
  SamplerType type = SamplerType::Sobol;
  std::uint32_t seed = 0;
  std::uint32_t samplesPerPixel = 1;  ///< counts only if needsSampleCount(type)
  std::uint32_t replicates = 1;       ///< R: sample i belongs to the independently scrambled sequence i mod R
};

/// The coordinates of one sample (width 1) or of several at once, each with a pixel and an index of its own. A pixel is
/// known by its Morton number (core/math/morton.h); for all but BlueNoise any other will do.
///
/// Independent: pcg4d of (pixel, sample, dimension, seed).
/// Stratified (core/samplers/stratified.h): jittered, per dimension in its own random order: 1D in `count` strata, 2D
/// in a grid of about sqrt(count) x sqrt(count) cells, where count = samplesPerPixel / replicates; samples beyond the
/// count begin another grid. Halton (core/samplers/halton.h): scrambled, an independent scramble per pixel, dimension
/// and replicate; stratified over all dimensions of bounce 0 together, padded beyond. Sobol: Owen-scrambled copies of
/// the first two Sobol' dimensions (core/samplers/sobol.h), an independent one per pixel, dimension and replicate, but
/// for the places on the film and the lens and the first direction, which are stratified together. Any aligned block of
/// 2^m consecutive samples is a (0,m,2)-net in each dimension. SobolFull (core/samplers/sobol_full.h): Owen-scrambled,
/// coordinates 2 d and 2 d + 1 for dimension d, so that the first 128 dimensions (12 bounces) are stratified together;
/// those beyond begin again with another order of the samples. Any aligned block of 2^m samples is stratified in each
/// coordinate, and in dimension 0 it is a (0,m,2)-net. BlueNoise (core/samplers/blue_noise.h): as Sobol, but one copy
/// per dimension and replicate for a square of pixels. Each pixel's `count` samples, rounded up to a power of two, are
/// a (0,m,2)-net; samples beyond begin another copy. Pmj02 (core/samplers/pmj02.h): shuffled and shifted copies of 4096
/// progressive multi-jittered (0,2) samples, one per pixel, dimension and replicate, with the same nets as Sobol; every
/// 4096 samples begin another copy.
template <class F>
class Sampler {
 public:
  Sampler(const SamplerSettings& settings, UintOf<F> pixel, UintOf<F> sample)
      : settings_(settings), pixel_(pixel), sample_(sample), index_(sample) {
    if (settings.replicates > 1) index_ = divide(sample, settings.replicates, sequence_);
    if (settings.type == SamplerType::Sobol) {
      plainIndex_ = index_;
      index_ = reverseBits(index_);
    } else {
      prepareIndex();
    }
  }

  /// In [0, 1).
  F get1D(UintOf<F> dimension) const {
    if (settings_.type == SamplerType::Sobol) {
      const Words key = sequenceKey(dimension);
      return owenSobol1D<F>(index_, key[0], key[1]);
    }
    if (settings_.type == SamplerType::Independent) return toUnitFloat<F>(independentWords(dimension)[0]);
    return other1D(dimension);
  }

  /// In [0, 1)^2.
  Vec2<F> get2D(UintOf<F> dimension) const {
    if (settings_.type == SamplerType::Sobol)
      return sobol2D(dimension, Purpose::Film, Purpose::BsdfDirection, Purpose::Lens);
    if (settings_.type == SamplerType::Independent) {
      const Words words = independentWords(dimension);
      return {toUnitFloat<F>(words[0]), toUnitFloat<F>(words[1])};
    }
    return other2D(dimension);
  }

  F get1D(UintOf<F> bounce, Purpose purpose) const { return get1D(dimensionOf(bounce, purpose)); }
  Vec2<F> get2D(UintOf<F> bounce, Purpose purpose) const {
    const Uint dimension = dimensionOf(bounce, purpose);
    if (settings_.type != SamplerType::Sobol) return get2D(dimension);
    // The same, without testing for purposes that this dimension cannot have.
    return shuffleOf(purpose) != nullptr ? sobol2D(dimension, purpose) : sobol2D(dimension);
  }

  const SamplerSettings& settings() const { return settings_; }
  UintOf<F> pixel() const { return pixel_; }
  UintOf<F> sample() const { return sample_; }

 private:
  using Uint = UintOf<F>;
  using Words = std::array<Uint, 4>;

  /// How a dimension of bounce 0 is stratified together with the others that are; null for those that are not.
  static const SobolShuffle* shuffleOf(Purpose purpose) {
    switch (purpose) {
      case Purpose::Film:
        return &kSobolFirst;
      case Purpose::BsdfDirection:
        return &kSobolSecond;
      case Purpose::Lens:
        return &kSobolThird;
      default:
        return nullptr;
    }
  }
  /// `possible`: those purposes stratified together that some lane's dimension may have.
  template <class... Purposes>
  Vec2<F> sobol2D(Uint dimension, Purposes... possible) const {
    const Words key = sequenceKey(dimension);
    Uint index = shuffledAlone(index_, key[0]), seedX = key[1], seedY = key[2];
    [[maybe_unused]] const auto placeTogether = [&](Purpose purpose) {
      const MaskOf<F> mine = dimension == dimensionOf(Uint(0u), purpose);
      if (!any(mine)) return;
      // A scramble turns the lowest bits of its word, the least random ones, into the highest of the coordinate. (Where
      // the index is shuffled by a hash, this does no harm; here neighbouring pixels would correlate.)
      index = select(mine, shuffledTogether(plainIndex_, *shuffleOf(purpose)), index);
      seedX = select(mine, mixBits(seedX), seedX);
      seedY = select(mine, mixBits(seedY), seedY);
    };
    (placeTogether(possible), ...);
    return owenSobol2D<F>(index, seedX, seedY);
  }

  /// Samples of one sequence; no more than floats can tell apart.
  std::uint32_t sampleCount() const {
    const std::uint32_t replicates = std::max(settings_.replicates, 1u);
    const std::uint32_t count = settings_.samplesPerPixel / replicates + (settings_.samplesPerPixel % replicates != 0);
    return std::clamp(count, 1u, 1u << 24);
  }
  BlueNoiseLayout layout() const { return BlueNoiseLayout::of(sampleCount()); }

  /// Replaces the index by what the type needs, and begins another sequence (`round`) where one ends.
  void prepareIndex() {
    Uint round(0u);
    switch (settings_.type) {
      case SamplerType::Stratified: {
        Uint place(0u);
        round = divide(index_, sampleCount(), place);
        index_ = place;
        break;
      }
      case SamplerType::BlueNoise:
        round = index_ >> layout().sampleBits;
        index_ = blueNoiseIndex(pixel_, index_, layout());
        break;
      case SamplerType::Pmj02:
        round = index_ >> kPmj02Bits;
        index_ = reverseBits(index_);
        break;
      default:
        break;
    }
    sequence_ ^= mixBits(round) << 8;
  }

  Words independentWords(Uint dimension) const { return randomWords(pixel_, sample_, dimension, Uint(settings_.seed)); }
  /// What all samples of one sequence share; `owner` is the pixel, if a sequence belongs to one.
  Words sequenceKey(Uint dimension, Uint owner) const {
    return randomWords(owner, dimension, sequence_, Uint(settings_.seed ^ 0x50b01u));
  }
  Words sequenceKey(Uint dimension) const { return sequenceKey(dimension, pixel_); }
  Words blueNoiseKey(Uint dimension) const { return sequenceKey(dimension, blueNoiseSquare(pixel_, layout())); }

  F other1D(Uint dimension) const {
    switch (settings_.type) {
      case SamplerType::Stratified:
        return stratified1D<F>(index_, sampleCount(), sequenceKey(dimension), independentWords(dimension)[0]);
      case SamplerType::Halton: {
        const Words key = sequenceKey(dimension);
        return halton<F>(index_, dimension, 0, key[0], key[1]);
      }
      case SamplerType::SobolFull:
        return sobolFull2D(dimension).x;
      case SamplerType::BlueNoise:
        return blueNoise1D<F>(index_, layout(), blueNoiseKey(dimension));
      default: {  // Pmj02
        const Words key = sequenceKey(dimension);
        return pmj02<F>(index_, key[0], key[1], key[2]).x;
      }
    }
  }

  Vec2<F> other2D(Uint dimension) const {
    switch (settings_.type) {
      case SamplerType::Stratified: {
        const Words jitter = independentWords(dimension);
        return stratified2D<F>(index_, sampleCount(), sequenceKey(dimension), jitter[0], jitter[1]);
      }
      case SamplerType::Halton: {
        const Words key = sequenceKey(dimension);
        return {halton<F>(index_, dimension, 0, key[0], key[1]), halton<F>(index_, dimension, 1, key[2], key[3])};
      }
      case SamplerType::SobolFull:
        return sobolFull2D(dimension);
      case SamplerType::BlueNoise:
        return blueNoise2D<F>(index_, layout(), blueNoiseKey(dimension));
      default: {  // Pmj02
        const Words key = sequenceKey(dimension);
        return pmj02<F>(index_, key[0], key[1], key[2]);
      }
    }
  }

  Vec2<F> sobolFull2D(Uint dimension) const {
    constexpr int bits = 7;
    static_assert(kSobolCoordinates == 2u << bits);
    const Uint block = dimension >> bits;
    Uint index = index_;
    if (any(block != Uint(0u))) {
      // A nested scramble keeps the nets, and decorrelates this block's points from those of the others.
      index = select(block != Uint(0u), owenScramble(index, sequenceKey(~block)[3]), index);
    }
    // A scramble turns the lowest bits of its word, the least random ones, into the highest of the coordinate. (Where
    // the index is shuffled too, this does no harm; here neighbouring pixels would correlate.)
    const Words key = sequenceKey(dimension);
    return owenSobolFull2D<F>(index, (dimension & Uint((1u << bits) - 1u)) << 1, mixBits(key[0]), mixBits(key[1]));
  }

  SamplerSettings settings_;
  Uint pixel_, sample_;
  Uint index_;                  ///< in its sequence, as the type needs it: for Sobol and Pmj02 bit-reversed
  Uint plainIndex_ = Uint(0u);  ///< for Sobol: in its sequence
  Uint sequence_ = Uint(0u);    ///< replicate; and the round, for types whose sequences end
};

}  // namespace steradian
