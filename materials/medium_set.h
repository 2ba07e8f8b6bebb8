#pragma once
/// Homogeneous media, ready for rays.
#include <vector>

#include "steradian/core/description.h"

namespace steradian {

struct Medium {
  Rgb extinction;  ///< absorption + scattering, 1/m
  Rgb scattering;  ///< 1/m
  Rgb emission;    ///< W sr^-1 m^-3
  float anisotropy = 0.0f;

  /// The share of radiance that is left after a way of `length` m (may be +inf): exp(-extinction length), the law of
  /// Bouguer, Lambert and Beer.
  Rgb transmittance(float length) const;
  /// The radiance that a way of `length` m sends back to its start: emission times the integral of the transmittance.
  Rgb emitted(float length) const;
  bool scatters() const { return !isBlack(scattering); }
};

class MediumSet {
 public:
  MediumSet() = default;
  explicit MediumSet(const std::vector<MediumDescription>& media);

  bool empty() const { return media_.empty(); }
  /// Null for kNone: vacuum.
  const Medium* find(Id medium) const { return medium < media_.size() ? &media_[medium] : nullptr; }

 private:
  std::vector<Medium> media_;
};

}  // namespace steradian
