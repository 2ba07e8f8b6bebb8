#include "steradian/integrators/path/path_kernels.h"
#include "steradian/integrators/path/shared_paths.h"

namespace steradian {
namespace {

/// Samples per pixel that one packet takes in a row: enough that lanes seldom idle at the end, few enough for the
/// cache.
constexpr std::uint32_t kSamplesInARow = 4;

template <class F>
void renderTile(const WideScene& scene, const PathPlan& plan, const RenderJob& job, PassRange pass, const Crop& tile,
                Film& film, PathCounts& counts) {
  for (int y = tile.y0 / kSharingEdge * kSharingEdge; y < tile.y1; y += kSharingEdge) {
    for (int x = tile.x0 / kSharingEdge * kSharingEdge; x < tile.x1; x += kSharingEdge) {
      for (std::uint32_t first = pass.first; first < pass.end; first += kSamplesInARow) {
        const std::uint32_t count = std::min(kSamplesInARow, pass.end - first);
        SharedPaths<F> paths(scene, plan, job, x, y, first, count, counts);
        PathPacket<F>(scene, plan, job.samplerSettings, counts).run(paths);
        std::span<const PixelSample> left = paths.finish();
        for (int row = y; row < y + kSharingEdge; ++row) {
          for (int column = x; column < x + kSharingEdge; ++column, left = left.subspan(count)) {
            if (column < tile.x0 || column >= tile.x1 || row < tile.y0 || row >= tile.y1) continue;
            film.addSamples(column, row, first, left.first(count));
          }
        }
      }
    }
  }
}

template <int width>
constexpr RenderPathTile kernel() {
  if constexpr (width == kNativeWidth || STERADIAN_ISA::kEveryWidth) return renderTile<Lanes<width>>;
  return nullptr;
}

}  // namespace

namespace STERADIAN_ISA {
constinit const PathKernels sharingKernels{kNativeWidth, kernel<4>(), kernel<8>(), kernel<16>()};
}

}  // namespace steradian
