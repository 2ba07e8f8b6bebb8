#pragma once
/// Integrators: what turns a scene into the samples of a picture.
///
/// An `Integrator` is configuration: it is checked when it is constructed, never changes, and may serve several scenes
/// and renders at once. What it computes for one scene is a `PreparedIntegrator`, and that is what renders.
///
/// To write an estimator of your own, derive from RadianceIntegrator and supply one function;
/// AmbientOcclusionIntegrator (integrators/auxiliary/aov.h) is an example. If it needs to compute something for each
/// scene first, derive from RadianceIntegratorWith.
#include <functional>
#include <memory>

#include "steradian/core/base/execution_settings.h"
#include "steradian/core/film/film.h"
#include "steradian/core/samplers/sampler.h"
#include "steradian/integrators/render/render_job.h"
#include "steradian/integrators/scene/scene.h"

namespace STERADIAN_API steradian {

/// An integrator together with all that it has computed for one scene. Immutable.
class PreparedIntegrator {
 public:
  PreparedIntegrator() = default;
  PreparedIntegrator(const PreparedIntegrator&) = delete;
  PreparedIntegrator& operator=(const PreparedIntegrator&) = delete;
  virtual ~PreparedIntegrator() = default;

  /// Adds the samples pass.first, ..., pass.end - 1 of each pixel of the film's crop to the film, with TBB in the
  /// caller's arena. Asks job.monitor between tiles whether to stop: a pixel has all samples of a pass or none.
  virtual void renderPass(const RenderJob& job, PassRange pass, Film& film) const = 0;

  /// The largest number of pixels whose errors are correlated, such as a block of pixels that share paths; 1: the
  /// errors of all pixels are independent.
  virtual std::uint32_t correlatedPixels() const { return 1; }
};

class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Computes what is needed to render this scene. Called once per render, before the passes. Never null. The result
  /// refers to the scene and may refer to this integrator, so it must not outlive either of them.
  ///
  /// Throws Error (Usage) if the integrator cannot render this scene, or not with these execution settings.
  virtual std::unique_ptr<const PreparedIntegrator> prepare(const Scene& scene,
                                                            const ExecutionSettings& execution) const = 0;
};

/// Renders passes sample by sample: tiles, camera rays, filter weights and the film are taken care of.
class PreparedSampleIntegrator : public PreparedIntegrator {
 public:
  /// The radiance that arrives along a camera ray, W sr^-1 m^-2, and what the ray hit first; counts the rays traced.
  /// Of the sampler, the dimensions of Film, Lens and Time are used up. Called by many threads at once; must not throw.
  virtual PixelSample evaluate(const Ray<float>& ray, const Sampler<float>& sampler, PathCounts& counts) const = 0;

  void renderPass(const RenderJob& job, PassRange pass, Film& film) const final;
};

/// An estimator of the radiance along camera rays, which needs nothing computed beforehand.
class RadianceIntegrator : public Integrator {
 public:
  /// An unbiased estimate of the radiance that arrives along `ray`, W sr^-1 m^-2. Of the sampler, the dimensions of
  /// Film, Lens and Time are used up. Called by many threads at once; must not throw.
  virtual Rgb radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const = 0;

  std::unique_ptr<const PreparedIntegrator> prepare(const Scene& scene, const ExecutionSettings&) const final;
};

/// An estimator of the radiance along camera rays that first computes a `Prepared` for each scene, once per render:
///
///     /// Shows how far away things are, black at the far end of the scene.
///     class FadeIntegrator final : public RadianceIntegratorWith<Bounds3> {
///       Bounds3 prepareRadiance(const Scene& scene) const override { return scene.geometry().bounds(); }
///       Rgb radiance(const Scene& scene, const Bounds3& bounds, const Ray<float>& ray,
///                    const Sampler<float>&) const override {
///         const PixelSample hit = traceFirstHit(scene, ray);
///         return grey(hit.alpha > 0.0f ? 1.0f - minimum(hit.depth / length(bounds.extent()), 1.0f) : 0.0f);
///       }
///     };
///
/// `Prepared` may be any type, also one that can be neither copied nor moved.
template <class Prepared>
class RadianceIntegratorWith : public Integrator {
 public:
  /// Computes what radiance() needs to know about the scene. May throw Error (Usage) if the scene cannot be rendered.
  virtual Prepared prepareRadiance(const Scene& scene) const = 0;
  /// See RadianceIntegrator::radiance; `prepared` is what prepareRadiance() computed for this scene.
  virtual Rgb radiance(const Scene& scene, const Prepared& prepared, const Ray<float>& ray,
                       const Sampler<float>& sampler) const = 0;

  std::unique_ptr<const PreparedIntegrator> prepare(const Scene& scene, const ExecutionSettings&) const final;
};

/// The sample of a camera ray that hits nothing and finds no light.
inline constexpr PixelSample kMiss{.alpha = 0.0f};
/// A sample without radiance: alpha, albedo, normal (turned to the ray's origin) and depth of the first surface that a
/// camera ray hits.
PixelSample traceFirstHit(const Scene& scene, const Ray<float>& ray);
/// The same where the hit is known.
void setFirstHit(PixelSample& sample, const SurfacePoint<float>& surface, const Bsdf& bsdf, Vec3f wo);

namespace detail {
using RadianceFunction = std::function<Rgb(const Ray<float>&, const Sampler<float>&)>;
std::unique_ptr<const PreparedIntegrator> prepareWith(const Scene& scene, RadianceFunction radiance);
}  // namespace detail

template <class Prepared>
std::unique_ptr<const PreparedIntegrator> RadianceIntegratorWith<Prepared>::prepare(const Scene& scene,
                                                                                    const ExecutionSettings&) const {
  const std::shared_ptr<const Prepared> prepared(new Prepared(prepareRadiance(scene)));
  return detail::prepareWith(scene, [this, &scene, prepared](const Ray<float>& ray, const Sampler<float>& sampler) {
    return radiance(scene, *prepared, ray, sampler);
  });
}

}  // namespace steradian
