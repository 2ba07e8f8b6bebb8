#include "steradian/integrators/path/wide_path.h"

#include "steradian/integrators/render/tiles.h"

namespace steradian {

WidePathTracer::WidePathTracer(const Scene& scene, const PathSettings& settings, std::uint32_t width)
    : reference_(scene, settings),
      wide_(scene),
      renderTile_(pathKernel(scene.geometry().isa(), width, settings.reuse > 1)),
      tileUnit_(settings.reuse > 1 ? kSharingEdge : 1) {}

void WidePathTracer::renderPass(const RenderJob& job, PassRange pass, Film& film) const {
  renderTiles(job, pass, film.crop(), tileUnit_, [&](const Crop& tile, PathCounts& counts) {
    renderTile_(wide_, reference_.plan(), job, pass, tile, film, counts);
  });
}

}  // namespace steradian
