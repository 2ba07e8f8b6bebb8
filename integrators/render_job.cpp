#include "steradian/integrators/render_job.h"

#include <tbb/task_arena.h>

#include <algorithm>

namespace steradian {

void RenderMonitor::finishedTile(std::uint64_t samples, const PathCounts& counts) {
  const std::lock_guard lock(mutex_);
  samples_ += samples;
  counts_ += counts;
  // A callback that waits for TBB must not be given another tile meanwhile: that would wait for this lock.
  tbb::this_task_arena::isolate([&] { report_(samples_); });
}

WeightedRay RenderJob::cameraRay(int x, int y, const Sampler<float>& sampler) const {
  const FilterSample<float> place = filter.sample(sampler.get2D(0, Purpose::Film));
  const Vec2f film{static_cast<float>(x) + 0.5f + place.offset.x, static_cast<float>(y) + 0.5f + place.offset.y};
  const Vec2f lens = camera.hasLens() ? sampler.get2D(0, Purpose::Lens) : Vec2f{};
  return {camera.ray<float>({film, lens, sampler.get1D(0, Purpose::Time)}), place.weight};
}

std::vector<Crop> tilesOf(const Crop& crop, int size) {
  size = std::min(size, Image::maxSide);  // sums of coordinates must not overflow
  std::vector<Crop> tiles;
  for (int y = crop.y0; y < crop.y1; y += size) {
    for (int x = crop.x0; x < crop.x1; x += size) {
      tiles.push_back({x, std::min(x + size, crop.x1), y, std::min(y + size, crop.y1)});
    }
  }
  return tiles;
}

}  // namespace steradian
