#include "steradian/integrators/path/path_kernels.h"

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

}  // namespace steradian
