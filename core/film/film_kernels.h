#pragma once
/// Sums of a few samples: the hot function of Film, once per instruction set (core/base/isa.h).
#include <array>
#include <cstdint>
#include <span>

#include "steradian/core/film/film.h"
#include "steradian/core/film/fixed_point.h"

namespace steradian {

/// What of a sample is summed over all samples: radiance, alpha, albedo, normal.
inline std::array<float, 10> valuesOf(const PixelSample& s) {
  return {s.radiance.r, s.radiance.g, s.radiance.b, s.alpha,    s.albedo.r,
          s.albedo.g,   s.albedo.b,   s.normal.x,   s.normal.y, s.normal.z};
}

struct SampleSums {
  static constexpr std::size_t kMaxCount = 16;

  std::array<FixedPoint128, 3> radiance;
  FixedPoint128 depth;                              ///< of hits
  std::array<FixedPoint64, 7> narrow;               ///< alpha, albedo, normal
  std::array<std::int64_t, kMaxCount> luminance{};  ///< of each sample, in steps of FixedPoint64
  std::uint32_t hits = 0;
};

struct STERADIAN_API FilmKernels {
  /// The sums of up to kMaxCount samples; false if a value is too large for the fast path, or not finite.
  bool (*sum)(std::span<const PixelSample> samples, SampleSums& sums);
};

/// `isa` must be usable.
const FilmKernels& filmKernels(Isa isa);

namespace baseline {
extern const FilmKernels filmKernels;
}
namespace avx2 {
extern const FilmKernels filmKernels;
}
namespace avx512 {
extern const FilmKernels filmKernels;
}

}  // namespace steradian
