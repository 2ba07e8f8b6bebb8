#include "steradian/integrators/path/path_kernels.h"

#include "steradian/integrators/path/camera_paths.h"

namespace steradian {
namespace {

/// Samples that one packet takes in a row: enough that lanes seldom idle at the end, few enough for the cache.
constexpr std::uint32_t kSamplesInARow = 4096;

/// As many rows of the tile as make about so many samples.
int rowsAtOnce(const Crop& tile, PassRange pass) {
  const auto perRow = static_cast<std::uint32_t>(tile.x1 - tile.x0) * pass.count();
  return static_cast<int>(std::max(kSamplesInARow / perRow, 1u));
}

template <class F>
void renderTile(const WideScene& scene, const PathPlan& plan, const RenderJob& job, PassRange pass, const Crop& tile,
                Film& film, PathCounts& counts) {
  std::vector<PixelSample> results;
  const int rows = rowsAtOnce(tile, pass);
  for (int y = tile.y0; y < tile.y1; y += rows) {
    const Crop strip{tile.x0, tile.x1, y, std::min(y + rows, tile.y1)};
    CameraSamples<F> samples(job, strip, pass);
    results.resize(samples.count());
    CameraPaths<F> paths(samples, results);
    PathPacket<F>(scene, plan, job.samplerSettings, counts).run(paths);
    std::span<const PixelSample> left = results;
    for (int row = strip.y0; row < strip.y1; ++row) {
      for (int x = strip.x0; x < strip.x1; ++x) {
        film.addSamples(x, row, pass.first, left.first(pass.count()));
        left = left.subspan(pass.count());
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
constinit const PathKernels pathKernels{kNativeWidth, kernel<4>(), kernel<8>(), kernel<16>()};
}

}  // namespace steradian
