#include "steradian/apps/books/book_integrator.h"

namespace steradian::books {

Rgb BookIntegrator::radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const {
  const auto maxDepth = static_cast<std::uint32_t>(scene.description().defaults.maxDepth);
  Rgb sum{}, throughput = grey(1.0f);
  Ray<float> next = ray;
  ScatterPoint<float> from{ray.origin, {}, {}, ray.time};
  for (std::uint32_t bounce = 0;; ++bounce) {
    const SurfacePoint<float> surface = scene.geometry().surfacePoint(next, scene.geometry().intersect(next));
    sum += throughput * scene.lights().emission(from, next, surface).radiance;
    if (!surface.valid || bounce == maxDepth) return sum;

    const Vec3f wo = -next.direction;
    const float chosen = sampler.get1D(bounce, Purpose::BsdfLobe);
    const BsdfRandom<float> random{mistake_ == Mistake::AlwaysRefracts ? kOneMinusEpsilon : chosen,
                                   sampler.get2D(bounce, Purpose::BsdfDirection)};
    const BsdfSample<float> scattered = scene.materials().bsdf(surface, wo).sample(wo, random, Transport::Radiance);
    if (!(scattered.pdf > 0.0f)) return sum;
    throughput *= scattered.weight;
    if (mistake_ == Mistake::UniformDenominator && scattered.pdf != kDirac) throughput *= scattered.pdf / kInvTwoPi;
    from = scatterPoint(surface, ray.time);
    next = spawnRay(from, scattered.wi, kInfinity);
  }
}

}  // namespace steradian::books
