#pragma once
/// Integrators: what turns a scene into the samples of a picture.
///
/// An integrator of your own usually derives from RadianceIntegrator and supplies one function; see
/// AmbientOcclusionIntegrator (aov.h) for one. Integrators are immutable: one object may serve several renders at once.
#include <memory>

#include "steradian/core/film/film.h"
#include "steradian/core/samplers/sampler.h"
#include "steradian/integrators/render/render_job.h"
#include "steradian/integrators/scene/scene.h"

namespace STERADIAN_API steradian {

class Integrator {
 public:
  virtual ~Integrator() = default;

  /// What this integrator computes beforehand for one scene: the integrator to render that scene with, or null if it is
  /// this one. The result must not outlive the scene. Called once per render, before the passes. Throws Error (Usage)
  /// if the integrator cannot render the scene as it is set.
  virtual std::unique_ptr<const Integrator> prepare(const Scene&) const { return nullptr; }

  /// The largest number of pixels with correlated errors, such as a block whose pixels share paths; 1: the errors of
  /// pixels are independent.
  virtual std::uint32_t correlatedPixels() const { return 1; }

  /// Adds the samples pass.first, ..., pass.end - 1 of each pixel of the film's crop to the film, with TBB in the
  /// caller's arena. Asks job.monitor between tiles whether to stop: a pixel has all samples of a pass or none.
  virtual void renderPass(const RenderJob& job, PassRange pass, Film& film) const = 0;
};

/// Estimates the radiance along camera rays; tiles, camera samples and film are taken care of.
class RadianceIntegrator : public Integrator {
 public:
  /// An unbiased estimate of the radiance that arrives along `ray`, W sr^-1 m^-2. Of the sampler, the dimensions of
  /// Film, Lens and Time are used up. Called by many threads at once; must not throw.
  virtual Rgb radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const = 0;

  /// The same with what the ray met first, for integrators that know it anyway; counts the rays. By default the camera
  /// ray is traced once more.
  virtual PixelSample evaluate(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler,
                               PathCounts& counts) const;

  void renderPass(const RenderJob& job, PassRange pass, Film& film) const final;
};

/// What a sample is that met nothing and found no light.
inline constexpr PixelSample kMiss{.alpha = 0.0f};
/// A sample without radiance: alpha, albedo, normal (turned to the ray's origin) and depth of the first surface that a
/// camera ray meets.
PixelSample traceFirstHit(const Scene& scene, const Ray<float>& ray);
/// The same where the hit is known.
void setFirstHit(PixelSample& sample, const SurfacePoint<float>& surface, const Bsdf& bsdf, Vec3f wo);

}  // namespace steradian
