#pragma once
/// Counts that a render keeps: cheap enough to be always on.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "steradian/accel/query_counts.h"
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// Rays and paths. Each tile counts for itself; sums do not depend on the order.
struct PathCounts {
  /// The last entry of pathLengths counts all longer paths.
  static constexpr std::size_t kLengths = 65;

  std::uint64_t cameraRays = 0;                       ///< closest-hit queries that start at the camera
  std::uint64_t bounceRays = 0;                       ///< all other closest-hit queries
  std::uint64_t shadowRays = 0;                       ///< any-hit queries
  std::array<std::uint64_t, kLengths> pathLengths{};  ///< paths by their number of bounces
  EmbreeCounts embree;                                ///< what of the rays Embree traced

  void countPath(std::uint32_t bounces) {
    ++cameraRays;
    bounceRays += bounces;
    ++pathLengths[std::min<std::size_t>(bounces, kLengths - 1)];
  }
  PathCounts& operator+=(const PathCounts& other) {
    cameraRays += other.cameraRays;
    bounceRays += other.bounceRays;
    shadowRays += other.shadowRays;
    embree += other.embree;
    for (std::size_t i = 0; i < kLengths; ++i) pathLengths[i] += other.pathLengths[i];
    return *this;
  }
};

/// What one call of render() did.
struct RenderStatistics {
  double renderSeconds = 0.0;          ///< preparing and sampling: without reading, building, writing
  double prepareSeconds = 0.0;         ///< of it, what the integrator prepared
  double sampleSeconds = 0.0;          ///< of it, the passes
  std::uint64_t samples = 0;           ///< evaluated, those dropped included
  std::uint64_t nonFiniteSamples = 0;  ///< dropped: their radiance was not a number or infinite
  std::uint32_t passes = 0;
  std::uint32_t correlatedPixels = 1;  ///< see PreparedIntegrator
  PathCounts paths;
};

}  // namespace steradian
