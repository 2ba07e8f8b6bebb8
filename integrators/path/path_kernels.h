#pragma once
/// The hot functions of the wide path integrator, once per instruction set (core/base/isa.h).
#include "steradian/core/base/isa.h"
#include "steradian/integrators/path/path_loop.h"
#include "steradian/integrators/path/wide_scene.h"
#include "steradian/integrators/render/render_job.h"

namespace steradian {

/// Renders the samples of a pass in one tile. Where pixels share paths, tiles consist of whole squares of edge
/// kSharingEdge; only the crop may cut through these.
using RenderPathTile = void (*)(const WideScene&, const PathPlan&, const RenderJob&, PassRange, const Crop& tile, Film&,
                                PathCounts&);

/// The functions for one instruction set. Null: that width is not compiled for it.
struct PathKernels {
  std::uint32_t nativeWidth;
  RenderPathTile width4, width8, width16;
};

/// Edge of the squares, in pixels, that the picture is divided into where pixels share paths: those that do so lie in
/// one square.
inline constexpr int kSharingEdge = 16;

/// Paths traced at once by default: as many as an instruction holds floats.
STERADIAN_API std::uint32_t nativeWidth(Isa isa);
/// The function for an instruction set and a width of 4, 8 or 16; `sharing`: pixels share paths (PathSettings::reuse).
/// Each set has the function of its native width only. For other widths the baseline's is returned: these are there to
/// compare with, and compiling them for every set would take two minutes.
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
