#pragma once
/// The path integrator.
#include "steradian/integrators/path/path_settings.h"
#include "steradian/integrators/render/integrator.h"

namespace STERADIAN_API steradian {

/// Path tracing with the given settings. What prepare() returns traces paths one at a time (path_loop.h) if the width
/// is 1, else several at once (path_packet.h): the same pictures, to the bit.
class PathIntegrator final : public Integrator {
 public:
  /// Throws Error (Usage) for settings out of their ranges.
  explicit PathIntegrator(const PathSettings& settings = {});

  const PathSettings& settings() const { return settings_; }

  /// Throws Error (Usage) if these execution settings are not usable, or not with the path settings: paths are not
  /// reused at width 1.
  void requireUsable(const ExecutionSettings& execution) const;
  /// Throws Error (Usage) as requireUsable(); also if a target is neither a shape of the scene nor "lights", and if
  /// paths are to be reused in a scene with media or motion.
  std::unique_ptr<const PreparedIntegrator> prepare(const Scene& scene,
                                                    const ExecutionSettings& execution) const override;

 private:
  PathSettings settings_;
};

}  // namespace steradian
