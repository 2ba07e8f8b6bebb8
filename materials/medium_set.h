#pragma once
/// Homogeneous media, ready for rays.
#include <vector>

#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

/// The medium that a ray travels through. In vacuum all coefficients are 0.
template <class F>
struct Medium {
  Spectrum<F> extinction;  ///< absorption + scattering, 1/m
  Spectrum<F> scattering;  ///< 1/m
  Spectrum<F> emission;    ///< W sr^-1 m^-3
  F anisotropy{0.0f};

  MaskOf<F> scatters() const { return !isBlack(scattering); }
  MaskOf<F> emits() const { return !isBlack(emission); }
  /// The fraction of radiance that is left after `length` m (may be +inf): exp(-extinction length), the Beer-Lambert
  /// law.
  Spectrum<F> transmittance(F length) const {
    const auto share = [&](F rate) { return select(rate > F(0.0f), exponential(-rate * length), F(1.0f)); };
    return {share(extinction.r), share(extinction.g), share(extinction.b)};
  }
  /// The radiance that a segment of `length` m emits towards its start: emission times the integral of transmittance.
  Spectrum<F> emitted(F length) const {
    const auto ofChannel = [&](F source, F rate) {
      const F seen = select(rate > F(0.0f), -exponentialMinusOne(-rate * length) / rate, length);
      return select(source > F(0.0f), source * seen, F(0.0f));
    };
    return {ofChannel(emission.r, extinction.r), ofChannel(emission.g, extinction.g),
            ofChannel(emission.b, extinction.b)};
  }
};

template <class F>
Medium<float> lane(const Medium<F>& m, int i) {
  return {lane(m.extinction, i), lane(m.scattering, i), lane(m.emission, i), lane(m.anisotropy, i)};
}
template <class F>
Medium<F> select(MaskOf<F> mask, const Medium<F>& a, const Medium<F>& b) {
  return {select(mask, a.extinction, b.extinction), select(mask, a.scattering, b.scattering),
          select(mask, a.emission, b.emission), select(mask, a.anisotropy, b.anisotropy)};
}

/// The media of a scene, by their index in the description; `none()` is vacuum.
class MediumSet {
 public:
  explicit MediumSet(const std::vector<MediumDescription>& media);

  std::uint32_t none() const { return static_cast<std::uint32_t>(records_.size() - 1); }
  /// `medium`: an index in the description, or none().
  template <class F>
  Medium<F> at(UintOf<F> medium) const;

 private:
  /// A medium as three blocks of four to gather.
  struct Record {
    Rgb extinction, scattering, emission;
    float anisotropy, unused[2];
  };
  std::vector<Record> records_;  ///< the last one is that of vacuum
};

template <class F>
Medium<F> MediumSet::at(UintOf<F> medium) const {
  static_assert(sizeof(Record) == 12 * sizeof(float));
  const float* first = &records_.data()->extinction.r;
  const UintOf<F> place = medium * UintOf<F>(12u);
  const auto a = gather4(first, place), b = gather4(first + 4, place), c = gather4(first + 8, place);
  return {{a[0], a[1], a[2]}, {a[3], b[0], b[1]}, {b[2], b[3], c[0]}, c[1]};
}

}  // namespace steradian
