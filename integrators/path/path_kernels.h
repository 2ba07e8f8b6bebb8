#pragma once
/// The hot functions of the wide path integrator, once per instruction set (core/base/isa.h).
#include "steradian/core/base/isa.h"
#include "steradian/integrators/path/path_loop.h"
#include "steradian/integrators/path/wide_scene.h"
#include "steradian/integrators/render/render_job.h"

namespace steradian {

/// Renders the samples of a pass in one tile. Where pixels share paths, tiles are made of whole squares
/// (kSharingEdge), but for what the crop cuts off.
using RenderPathTile = void (*)(const WideScene&, const PathPlan&, const RenderJob&, PassRange, const Crop& tile, Film&,
                                PathCounts&);

/// Null: not compiled for this set.
struct PathKernels {
  std::uint32_t nativeWidth;
  RenderPathTile width4, width8, width16;
};

/// Pixels that share paths are of one square of this edge, and the picture is divided into such.
inline constexpr int kSharingEdge = 16;

/// Paths traced at once by default: as many as an instruction holds floats.
STERADIAN_API std::uint32_t nativeWidth(Isa isa);
/// `width` is 4, 8 or 16; `sharing`: see PathSettings::reuse. Each set has the function of its native width. Those of
/// other widths are the baseline's, on every machine: they are there to compare with, and to compile them for each set
/// would take two minutes.
RenderPathTile pathKernel(Isa isa, std::uint32_t width, bool sharing);

namespace baseline {
inline constexpr bool kEveryWidth = true;
extern const PathKernels pathKernels, sharingKernels;
}  // namespace baseline
namespace avx2 {
inline constexpr bool kEveryWidth = false;
extern const PathKernels pathKernels, sharingKernels;
}  // namespace avx2
namespace avx512 {
inline constexpr bool kEveryWidth = false;
extern const PathKernels pathKernels, sharingKernels;
}  // namespace avx512

}  // namespace steradian
