#pragma once
/// What the random numbers of a sample are for: the names of a sampler's dimensions.
#include <cstdint>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

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
  TargetSelect,   ///< 1D: which of several sampling targets
  FreeFlight,     ///< 2D: the distance to scattering in media, and the channel it is sampled for
  Count
};
inline constexpr std::uint32_t kPurposeCount = static_cast<std::uint32_t>(Purpose::Count);

template <class U>
U dimensionOf(U bounce, Purpose purpose) {
  return bounce * U(kPurposeCount) + U(static_cast<std::uint32_t>(purpose));
}

}  // namespace steradian
