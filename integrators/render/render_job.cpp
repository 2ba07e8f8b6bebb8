#include "steradian/integrators/render/render_job.h"

#include <algorithm>

#include "steradian/core/base/parallel.h"

namespace steradian {

void RenderMonitor::finishedTile(std::uint64_t samples, const PathCounts& counts) {
  const std::lock_guard lock(mutex_);
  samples_ += samples;
  counts_ += counts;
  // A callback that waits for TBB must not be given another tile meanwhile: that would wait for this lock.
  isolated([&] { report_(samples_); });
}

std::vector<Crop> tilesOf(const Crop& crop, int size) {
  size = std::min(size, Image::maxSide);  // sums of coordinates must not overflow
  std::vector<Crop> tiles;
  for (int y = crop.y0 / size * size; y < crop.y1; y += size) {
    for (int x = crop.x0 / size * size; x < crop.x1; x += size) {
      tiles.push_back(
          {std::max(x, crop.x0), std::min(x + size, crop.x1), std::max(y, crop.y0), std::min(y + size, crop.y1)});
    }
  }
  return tiles;
}

}  // namespace steradian
