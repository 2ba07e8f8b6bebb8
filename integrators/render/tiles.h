#pragma once
/// A pass over a film in tiles, on all threads of the caller's arena.
#include "steradian/core/base/float_mode.h"
#include "steradian/core/base/parallel.h"
#include "steradian/core/film/film.h"
#include "steradian/integrators/render/render_job.h"

namespace STERADIAN_API steradian {

/// Calls renderTile(tile, counts) for each tile of the crop until the job is to stop; edges of tiles are multiples of
/// `unit`. A tile must add all samples of the pass to each of its pixels.
template <class RenderTile>
void renderTiles(const RenderJob& job, PassRange pass, const Crop& crop, int unit, const RenderTile& renderTile) {
  const int size = std::min(job.tileSize, Image::maxSide);  // rounding up must not overflow
  const std::vector<Crop> tiles = tilesOf(crop, (size + unit - 1) / unit * unit);
  parallelForEach(tiles.size(), [&](std::size_t i) {
    if (job.monitor.stopRequested()) return;
    const FlushDenormals floatMode;
    const Crop& tile = tiles[i];
    PathCounts counts;
    renderTile(tile, counts);
    const auto pixels = static_cast<std::uint64_t>(tile.x1 - tile.x0) * static_cast<std::uint64_t>(tile.y1 - tile.y0);
    job.monitor.finishedTile(pixels * pass.count(), counts);
  });
}

}  // namespace steradian
