#include "steradian/integrators/path/wide_path.h"

#include "steradian/integrators/render/tiles.h"

namespace steradian {
namespace {

const PathKernels& pathKernels(Isa isa, bool sharing) {
  if constexpr (STERADIAN_DISPATCH) {
    if (isa == Isa::Avx2) return sharing ? avx2::sharingKernels : avx2::pathKernels;
    if (isa == Isa::Avx512) return sharing ? avx512::sharingKernels : avx512::pathKernels;
  }
  return sharing ? baseline::sharingKernels : baseline::pathKernels;
}

}  // namespace

std::uint32_t nativeWidth(Isa isa) { return pathKernels(isa, false).nativeWidth; }

RenderPathTile pathKernel(Isa isa, std::uint32_t width, bool sharing) {
  const auto of = [&](const PathKernels& kernels) {
    return width == 4 ? kernels.width4 : width == 8 ? kernels.width8 : kernels.width16;
  };
  const RenderPathTile own = of(pathKernels(isa, sharing));
  return own != nullptr ? own : of(pathKernels(Isa::Baseline, sharing));
}

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
