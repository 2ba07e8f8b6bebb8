#include "steradian/apps/bench/replay.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "steradian/core/float_mode.h"

namespace steradian::bench {
namespace {

/// About the rays of one sample per pixel of a tile.
constexpr std::size_t kRun = 2048;

std::uint64_t countHits(const Geometry& geometry, std::span<const RecordedRay> rays) {
  const FlushDenormals floatMode;
  std::uint64_t hits = 0;
  for (const RecordedRay& recorded : rays) {
    const bool hit =
        recorded.kind == RayKind::Shadow ? geometry.occluded(recorded.ray) : geometry.intersect(recorded.ray).valid;
    hits += hit ? 1u : 0u;
  }
  return hits;
}

}  // namespace

std::uint64_t replay(const Geometry& geometry, std::span<const RecordedRay> rays) {
  std::atomic<std::uint64_t> hits{0};
  const std::size_t runs = (rays.size() + kRun - 1) / kRun;
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, runs, 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          const std::size_t begin = i * kRun;
          hits += countHits(geometry, rays.subspan(begin, std::min(kRun, rays.size() - begin)));
        }
      },
      tbb::simple_partitioner());
  return hits;
}

}  // namespace steradian::bench
