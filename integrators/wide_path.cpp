#include "steradian/integrators/wide_path.h"

#include "steradian/integrators/tiles.h"

namespace steradian {
namespace {

const PathKernels& pathKernels(Isa isa) {
  if constexpr (STERADIAN_DISPATCH) {
    if (isa == Isa::Avx2) return avx2::pathKernels;
    if (isa == Isa::Avx512) return avx512::pathKernels;
  }
  return baseline::pathKernels;
}

}  // namespace

std::uint32_t nativeWidth(Isa isa) { return pathKernels(isa).nativeWidth; }

RenderPathTile pathKernel(Isa isa, std::uint32_t width) {
  const auto of = [&](const PathKernels& kernels) {
    return width == 4 ? kernels.width4 : width == 8 ? kernels.width8 : kernels.width16;
  };
  const RenderPathTile own = of(pathKernels(isa));
  return own != nullptr ? own : of(baseline::pathKernels);
}

WidePathTracer::WidePathTracer(const Scene& scene, const PathSettings& settings, std::uint32_t width)
    : reference_(scene, settings), wide_(scene), renderTile_(pathKernel(scene.geometry().isa(), width)) {}

void WidePathTracer::renderPass(const RenderJob& job, PassRange pass, Film& film) const {
  renderTiles(job, pass, film.crop(), [&](const Crop& tile, PathCounts& counts) {
    renderTile_(wide_, reference_.plan(), job, pass, tile, film, counts);
  });
}

}  // namespace steradian
