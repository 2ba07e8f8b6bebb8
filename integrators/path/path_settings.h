#pragma once
/// What a user may choose about the path integrator.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// Where directions towards light come from. Point, spot and distant lights cannot be hit: every strategy samples them.
enum class Strategy {
  Bsdf,    ///< light is found by scattered rays only
  Light,   ///< one point on a light per vertex; scattered rays count emission only after lobes that lights cannot
           ///< be sampled for: Dirac ones, and metal with fuzz < 1, whose variance would be infinite
  Mis,     ///< shadow rays and scattered ones, weighted by the power heuristic (Veach 1997, 9.2); where there are
           ///< sampling targets besides the lights, scattered rays are drawn from a mixture of them and the BSDF
  Mixture  ///< one direction per vertex from a mixture of sampling targets and BSDF ("The Rest of Your Life", 10-12)
};

/// Which density proposes scattered directions for the continuous lobes. The estimate stays right with each of them;
/// only the noise differs ("The Rest of Your Life", 6).
enum class ScatterPdf {
  Bsdf,        ///< the material's own
  Cosine,      ///< cos/pi about the shading normal, on the side of wo
  Hemisphere,  ///< 1/(2 pi), likewise
  Sphere       ///< 1/(4 pi)
};

struct PathSettings {
  static constexpr std::uint32_t kMaxDepth = 100000, kMaxLightSamples = 1024, kMaxReuse = 32;

  Strategy strategy = Strategy::Mis;
  ScatterPdf scatterPdf = ScatterPdf::Bsdf;
  /// Shadow rays per vertex, 1..kMaxLightSamples.
  std::uint32_t lightSamples = 1;
  /// Roulette begins with the ray that leaves the vertex after so many bounces, up to kMaxDepth. (This and the strength
  /// by measurement: BENCHMARKS.md, "Roulette".)
  std::uint32_t rouletteStart = 4;
  /// s in [0, 1]. A path goes on with probability 1 - s (1 - min(1, t)), t being the largest channel of its throughput
  /// without the scaling that refraction brings. 0: no roulette; 1: as probable as it is bright.
  float rouletteStrength = 0.4f;
  /// Bounces up to kMaxDepth, 0 for emission only; nothing: as the scene says.
  std::optional<std::uint32_t> maxDepth = std::nullopt;
  /// Mixture, Mis: the probability of choosing a target, in [0, 1]; nothing: 0.5, and 0.25 for Mis, which samples the
  /// lights besides. With 1, light from elsewhere is lost.
  std::optional<float> targetWeight = std::nullopt;
  /// Mixture, Mis: names of shapes and `lights`; none: those that the scene flags; for Mixture or else its
  /// lights, for Mis those that do not emit.
  std::vector<std::string> targets = {};
  /// That many neighbouring pixels, 1 or a power of two up to kMaxReuse, share what their paths find after the second
  /// vertex (shared_paths.h). Where most light comes from Lambertian surfaces by way of others, pixels have several
  /// times less noise in the same time; but those that share err together, as a block. Not for scenes with media or
  /// motion, nor for a width of 1 (ExecutionSettings) or another scatterPdf. Roulette begins with the second vertex at
  /// the earliest. Squares of 16 x 16 pixels are traced whole, also where the crop cuts through them.
  std::uint32_t reuse = 1;
};

}  // namespace steradian
