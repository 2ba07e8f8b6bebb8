#include "steradian/integrators/integrator.h"

#include <tbb/parallel_for.h>

#include <vector>

#include "steradian/core/float_mode.h"

namespace steradian {
namespace {

/// Adds the pass's samples of one tile to the film.
void renderTile(const RadianceIntegrator& integrator, const RenderJob& job, PassRange pass, const Crop& tile,
                Film& film, PathCounts& counts) {
  const FlushDenormals floatMode;
  std::vector<PixelSample> samples(pass.count());
  for (int y = tile.y0; y < tile.y1; ++y) {
    for (int x = tile.x0; x < tile.x1; ++x) {
      const std::uint32_t pixel = RenderJob::pixelKey(x, y);
      for (std::uint32_t i = 0; i < pass.count(); ++i) {
        const Sampler<float> sampler(job.samplerSettings, pixel, pass.first + i);
        const WeightedRay camera = job.cameraRay(x, y, sampler);
        PixelSample& sample = samples[i];
        sample = integrator.evaluate(job.scene, camera.ray, sampler, counts);
        sample.radiance *= camera.weight;
        sample.alpha *= camera.weight;
      }
      film.addSamples(x, y, pass.first, samples);
    }
  }
}

std::uint64_t pixelsOf(const Crop& tile) {
  return static_cast<std::uint64_t>(tile.x1 - tile.x0) * static_cast<std::uint64_t>(tile.y1 - tile.y0);
}

}  // namespace

void RadianceIntegrator::renderPass(const RenderJob& job, PassRange pass, Film& film) const {
  const std::vector<Crop> tiles = tilesOf(film.crop(), job.tileSize);
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(0, tiles.size(), 1),
      [&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          if (job.monitor.stopRequested()) return;
          PathCounts counts;
          renderTile(*this, job, pass, tiles[i], film, counts);
          job.monitor.finishedTile(pixelsOf(tiles[i]) * pass.count(), counts);
        }
      },
      tbb::simple_partitioner());
}

PixelSample RadianceIntegrator::evaluate(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler,
                                         PathCounts& counts) const {
  PixelSample sample = traceFirstHit(scene, ray);
  sample.radiance = radiance(scene, ray, sampler);
  counts.countPath(0);
  return sample;
}

PixelSample traceFirstHit(const Scene& scene, const Ray<float>& ray) {
  PixelSample sample = kMiss;
  const Hit<float> hit = scene.geometry().intersect(ray);
  if (!hit.valid) return sample;
  const SurfacePoint<float> surface = scene.geometry().surfacePoint(ray, hit);
  const Vec3f wo = -ray.direction;
  setFirstHit(sample, surface, scene.materials().bsdf(surface, wo), wo);
  return sample;
}

void setFirstHit(PixelSample& sample, const SurfacePoint<float>& surface, const Bsdf& bsdf, Vec3f wo) {
  sample.alpha = 1.0f;
  sample.albedo = bsdf.albedo(wo);
  sample.normal = faceForward(bsdf.shadingNormal(), wo);
  sample.depth = surface.distance;
}

}  // namespace steradian
