#include "steradian/integrators/auxiliary/aov.h"

#include "steradian/core/sampling/direction_pdf.h"
#include "steradian/core/transport/ray_offset.h"

namespace steradian {

Rgb NormalIntegrator::radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>&) const {
  const PixelSample hit = traceFirstHit(scene, ray);
  if (hit.alpha == 0.0f) return scene.lights().radiance(ray, {});
  return {0.5f * (hit.normal.x + 1.0f), 0.5f * (hit.normal.y + 1.0f), 0.5f * (hit.normal.z + 1.0f)};
}

Rgb AlbedoIntegrator::radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>&) const {
  return traceFirstHit(scene, ray).albedo;
}

Rgb DepthIntegrator::radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>&) const {
  const PixelSample hit = traceFirstHit(scene, ray);
  return grey(hit.alpha > 0.0f ? hit.depth : 0.0f);
}

Rgb AmbientOcclusionIntegrator::radiance(const Scene& scene, const Ray<float>& ray,
                                         const Sampler<float>& sampler) const {
  Scene::FirstSurface first = scene.firstSurface(ray, scene.interiorAtStart(ray));
  const SurfacePoint<float>& surface = first.point;
  if (!surface.valid) return {};
  const CosinePdf<float> cosine(faceForward(surface.shadingNormal, -ray.direction));
  const Vec3f wi = cosine.sample(sampler.get2D(0, Purpose::BsdfDirection)).wi;
  const Ray<float> probe = spawnRay(scatterPoint(surface, ray.time), wi, distance_);
  if (!scene.volumes().passable()) return grey(scene.geometry().occluded(probe) ? 0.0f : 1.0f);
  scene.volumes().scatter(surface, -ray.direction, wi, first.interior);
  return grey(scene.firstSurface(probe, first.interior).point.valid ? 0.0f : 1.0f);
}

}  // namespace steradian
