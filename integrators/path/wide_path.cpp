#include "steradian/integrators/path/wide_path.h"

#include "steradian/integrators/render/tiles.h"

namespace steradian {

WidePathTracer::WidePathTracer(const Scene& scene, const PathSettings& settings, const ExecutionSettings& execution)
    : context_(scene, settings),
      wide_(scene),
      renderTile_(pathKernel(execution.isa, execution.width == 0 ? nativeWidth(execution.isa) : execution.width,
                             settings.reuse > 1)),
      tileUnit_(settings.reuse > 1 ? kSharingEdge : 1) {}

void WidePathTracer::renderPass(const RenderJob& job, PassRange pass, Film& film) const {
  renderTiles(job, pass, film.crop(), tileUnit_, [&](const Crop& tile, PathCounts& counts) {
    renderTile_(wide_, context_.plan(), job, pass, tile, film, counts);
  });
}

}  // namespace steradian
