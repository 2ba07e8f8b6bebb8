#pragma once
/// Perlin's noise, and the patterns that "The Next Week" (section 5) makes of it.
#include <memory>
#include <vector>

#include "steradian/core/math/vec.h"
#include "steradian/core/samplers/rng.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

/// Gradient noise on the lattice of whole numbers (Perlin 1985, "An image synthesizer"): at each lattice point a random
/// unit vector, whose dot products with the offsets to the eight corners of a cell are blended by 3t^2 - 2t^3. It is
/// zero at lattice points, continuous with its first derivatives, and in (-1, 1).
class PerlinNoise {
 public:
  explicit PerlinNoise(std::uint32_t seed);

  /// Beyond 2^23, where floats have no fraction, it is zero.
  template <class F>
  F noise(Vec3<F> p) const;

  /// |the sum of `octaves` noises, each of twice the frequency and half the size| (the book's turb).
  template <class F>
  F turbulence(Vec3<F> p, int octaves) const;

 private:
  static constexpr std::uint32_t kVectors = 256;

  /// A coordinate's cell, as the hashes of its two ends, and the place in it.
  template <class F>
  struct Cell {
    UintOf<F> low, high;
    F fraction, blend;
  };
  template <class F>
  static Cell<F> cellOf(F x, std::uint32_t key);

  /// The vectors' x, y, z and a zero. Copies of a texture share them.
  std::shared_ptr<const std::vector<float>> vectors_;
  std::uint32_t keyX_, keyY_, keyZ_;
};

/// A NoiseTexture ready for lookup.
class NoisePattern {
 public:
  /// The texture must be valid (see validate()).
  explicit NoisePattern(const NoiseTexture& texture);

  /// The colour at a point in world space.
  template <class F>
  Spectrum<F> value(Vec3<F> position) const {
    return broadcast<F>(colour_) * share(position);
  }

 private:
  /// The factor of the colour, in [0, 1].
  template <class F>
  F share(Vec3<F> position) const;

  PerlinNoise noise_;
  NoiseTexture::Pattern pattern_;
  Rgb colour_;
  float scale_;
  int octaves_;
};

template <class F>
PerlinNoise::Cell<F> PerlinNoise::cellOf(F x, std::uint32_t key) {
  const F place = clamp(x, -0x1p23f, 0x1p23f);
  const F floor = floorOf(place);
  const F t = place - floor;
  const UintOf<F> corner = toUnsigned(toInt(floor));
  return {mixBits(corner ^ UintOf<F>(key)), mixBits((corner + UintOf<F>(1u)) ^ UintOf<F>(key)), t,
          t * t * (F(3.0f) - F(2.0f) * t)};
}

template <class F>
F PerlinNoise::noise(Vec3<F> p) const {
  const Cell<F> x = cellOf(p.x, keyX_), y = cellOf(p.y, keyY_), z = cellOf(p.z, keyZ_);
  const F one(1.0f);
  const auto corner = [&](UintOf<F> hash, F dx, F dy, F dz) {
    const UintOf<F> vector = (mixBits(hash) & UintOf<F>(kVectors - 1)) << 2;
    const auto g = gather4(vectors_->data(), vector);
    return (g[0] * dx + g[1] * dy) + g[2] * dz;
  };
  const auto alongX = [&](UintOf<F> hash, F dy, F dz) {
    const F a = corner(hash ^ x.low, x.fraction, dy, dz), b = corner(hash ^ x.high, x.fraction - one, dy, dz);
    return a + (b - a) * x.blend;
  };
  const auto alongY = [&](UintOf<F> hash, F dz) {
    const F a = alongX(hash ^ y.low, y.fraction, dz), b = alongX(hash ^ y.high, y.fraction - one, dz);
    return a + (b - a) * y.blend;
  };
  const F a = alongY(z.low, z.fraction), b = alongY(z.high, z.fraction - one);
  return a + (b - a) * z.blend;
}

template <class F>
F PerlinNoise::turbulence(Vec3<F> p, int octaves) const {
  F sum(0.0f);
  float weight = 1.0f, frequency = 1.0f;
  for (int i = 0; i < octaves; ++i) {
    sum = sum + F(weight) * noise(p * F(frequency));
    weight *= 0.5f;
    frequency *= 2.0f;
  }
  return absolute(sum);
}

template <class F>
F NoisePattern::share(Vec3<F> position) const {
  const F half(0.5f), one(1.0f);
  switch (pattern_) {
    case NoiseTexture::Pattern::Noise:
      return half * (one + noise_.noise(position * F(scale_)));
    case NoiseTexture::Pattern::Turbulence:
      return minimum(noise_.turbulence(position * F(scale_), octaves_), one);
    case NoiseTexture::Pattern::Marble: {
      const F phase = F(scale_) * position.z + F(10.0f) * noise_.turbulence(position, octaves_);
      // In turns, of which the whole ones do not count.
      const F turns = clamp(phase * F(kInvTwoPi), -0x1p23f, 0x1p23f);
      return clamp(half * (one + sinCosTwoPi(turns - floorOf(turns)).sin), 0.0f, 1.0f);
    }
  }
  return F(0.0f);
}

}  // namespace steradian
