#include "steradian/integrators/wide_path.h"

#include "steradian/integrators/path_packet.h"
#include "steradian/integrators/tiles.h"

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
    PathPacket<F>(scene, plan, job, counts).run(samples, results);
    std::span<const PixelSample> left = results;
    for (int row = strip.y0; row < strip.y1; ++row) {
      for (int x = strip.x0; x < strip.x1; ++x) {
        film.addSamples(x, row, pass.first, left.first(pass.count()));
        left = left.subspan(pass.count());
      }
    }
  }
}

}  // namespace

WidePathTracer::WidePathTracer(const Scene& scene, const PathSettings& settings, std::uint32_t width)
    : reference_(scene, settings), wide_(scene), width_(width) {}

void WidePathTracer::renderPass(const RenderJob& job, PassRange pass, Film& film) const {
  renderTiles(job, pass, film.crop(), [&](const Crop& tile, PathCounts& counts) {
    const PathPlan& plan = reference_.plan();
    switch (width_) {
      case 4:
        return renderTile<Lanes<4>>(wide_, plan, job, pass, tile, film, counts);
      case 8:
        return renderTile<Lanes<8>>(wide_, plan, job, pass, tile, film, counts);
      default:
        return renderTile<Lanes<16>>(wide_, plan, job, pass, tile, film, counts);
    }
  });
}

}  // namespace steradian
