#pragma once
/// The path integrator at widths above 1.
#include "steradian/integrators/path/path_context.h"
#include "steradian/integrators/path/path_kernels.h"
#include "steradian/integrators/path/wide_scene.h"
#include "steradian/integrators/render/integrator.h"

namespace STERADIAN_API steradian {

/// Traces several paths of one scene at once (path_packet.h says how): the same pictures as at width 1, to the
/// bit.
class WidePathTracer final : public PreparedIntegrator {
 public:
  /// The scene must outlive this. The execution settings must be usable, and their width must not be 1. Throws as
  /// PathContext.
  WidePathTracer(const Scene& scene, const PathSettings& settings, const ExecutionSettings& execution);

  void renderPass(const RenderJob& job, PassRange pass, Film& film) const override;
  std::uint32_t correlatedPixels() const override { return context_.plan().reuse; }

 private:
  PathContext context_;
  WideScene wide_;
  RenderPathTile renderTile_;
  int tileUnit_;  ///< edges of tiles are multiples of this many pixels
};

}  // namespace steradian
