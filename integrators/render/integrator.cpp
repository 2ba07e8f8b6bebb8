#include "steradian/integrators/render/integrator.h"

#include <vector>

#include "steradian/integrators/render/tiles.h"

namespace steradian {
namespace {

/// Adds the pass's samples of one tile to the film.
void renderTile(const PreparedSampleIntegrator& integrator, const RenderJob& job, PassRange pass, const Crop& tile,
                Film& film, PathCounts& counts) {
  std::vector<PixelSample> samples(pass.count());
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const std::uint32_t pixel = RenderJob::pixelKey(x, y);
      for (std::uint32_t i = 0; i < pass.count(); ++i) {
        const Sampler<float> sampler(job.samplerSettings, pixel, pass.first + i);
        const WeightedRay<float> camera = job.cameraRay(static_cast<float>(x), static_cast<float>(y), sampler);
        PixelSample& sample = samples[i];
        sample = integrator.evaluate(camera.ray, sampler, counts);
        sample.radiance *= camera.weight;
        sample.alpha *= camera.weight;
      }
      film.addSamples(x, y, pass.first, samples);
    }
  }
}

/// Camera samples by a function that estimates radiance: the camera ray is traced once more for what it hits first.
class PreparedRadiance final : public PreparedSampleIntegrator {
 public:
  PreparedRadiance(const Scene& scene, detail::RadianceFunction radiance)
      : scene_(scene), radiance_(std::move(radiance)) {}
  PixelSample evaluate(const Ray<float>& ray, const Sampler<float>& sampler, PathCounts& counts) const override {
    PixelSample sample = traceFirstHit(scene_, ray);
    sample.radiance = radiance_(ray, sampler);
    counts.countPath(0);
    return sample;
  }

 private:
  const Scene& scene_;
  const detail::RadianceFunction radiance_;
};

}  // namespace

void PreparedSampleIntegrator::renderPass(const RenderJob& job, PassRange pass, Film& film) const {
  renderTiles(job, pass, film.crop(), 1,
              [&](const Crop& tile, PathCounts& counts) { renderTile(*this, job, pass, tile, film, counts); });
}

std::unique_ptr<const PreparedIntegrator> detail::prepareWith(const Scene& scene, RadianceFunction radiance) {
  return std::make_unique<PreparedRadiance>(scene, std::move(radiance));
}

std::unique_ptr<const PreparedIntegrator> RadianceIntegrator::prepare(const Scene& scene,
                                                                      const ExecutionSettings&) const {
  return detail::prepareWith(scene, [this, &scene](const Ray<float>& ray, const Sampler<float>& sampler) {
    return radiance(scene, ray, sampler);
  });
}

PixelSample traceFirstHit(const Scene& scene, const Ray<float>& ray) {
  PixelSample sample = kMiss;
  const Scene::FirstSurface first = scene.firstSurface(ray, scene.interiorAtStart(ray));
  if (!first.point.valid) return sample;
  const Vec3f wo = -ray.direction;
  setFirstHit(sample, first.point, scene.materials().bsdf(first.point, wo, first.outsideEta), wo);
  return sample;
}

void setFirstHit(PixelSample& sample, const SurfacePoint<float>& surface, const Bsdf& bsdf, Vec3f wo) {
  sample.alpha = 1.0f;
  sample.albedo = bsdf.albedo(wo);
  sample.normal = faceForward(bsdf.shadingNormal(), wo);
  sample.depth = surface.distance;
}

}  // namespace steradian
