#pragma once
/// The path integrator at full width.
#include "steradian/integrators/path/path.h"
#include "steradian/integrators/path/path_kernels.h"
#include "steradian/integrators/path/wide_scene.h"

namespace STERADIAN_API steradian {

/// Traces several paths of one scene at once (path_packet.h says how): the same pictures as PathTracer, to the bit.
class WidePathTracer final : public Integrator {
 public:
  /// The scene must outlive this. `width` is 4, 8 or 16 paths. Throws as PathIntegrator::prepare.
  WidePathTracer(const Scene& scene, const PathSettings& settings, std::uint32_t width);

  /// job.scene must be that of the constructor.
  void renderPass(const RenderJob& job, PassRange pass, Film& film) const override;

 private:
  PathTracer reference_;
  WideScene wide_;
  RenderPathTile renderTile_;
  int tileUnit_;
};

}  // namespace steradian
