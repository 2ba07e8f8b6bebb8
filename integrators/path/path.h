#pragma once
/// The path integrator.
#include "steradian/integrators/path/path_loop.h"
#include "steradian/integrators/path/path_settings.h"
#include "steradian/integrators/render/integrator.h"

namespace STERADIAN_API steradian {

/// The settings, checked. Paths are traced by what prepare() returns: WidePathTracer (wide_path.h), or with width 1
/// PathTracer.
class PathIntegrator final : public Integrator {
 public:
  /// Throws Error (Usage) for settings out of their ranges.
  explicit PathIntegrator(const PathSettings& settings = {});

  const PathSettings& settings() const { return settings_; }

  std::uint32_t correlatedPixels() const override { return settings_.reuse; }
  /// Throws Error (Usage) if a target is neither a shape of the scene nor "lights", and if paths are to be reused in a
  /// scene with media or motion.
  std::unique_ptr<const Integrator> prepare(const Scene& scene) const override;
  void renderPass(const RenderJob& job, PassRange pass, Film& film) const override;

 private:
  PathSettings settings_;
};

/// Traces paths through one scene, one at a time (path_loop.h says how).
class PathTracer final : public RadianceIntegrator {
 public:
  /// The scene must outlive this. Throws as PathIntegrator::prepare.
  PathTracer(const Scene& scene, const PathSettings& settings);

  PathTracer(const PathTracer&) = delete;  // the plan points into it
  PathTracer& operator=(const PathTracer&) = delete;

  const PathPlan& plan() const { return plan_; }

  /// `scene` must be that of the constructor.
  Rgb radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const override;
  PixelSample evaluate(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler,
                       PathCounts& counts) const override;

 private:
  std::optional<LightSet> lights_, diracLights_;
  std::optional<TargetSet> targets_;
  PathPlan plan_;
};

}  // namespace steradian
