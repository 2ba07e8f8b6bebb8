#pragma once
/// The loop of the path integrator, for one path: tracePath(), at the end of this file, and what it is made of.
///
/// The path starts at the camera. At each vertex light is gathered by light samples (next event estimation) and the
/// next direction is sampled. The four strategies for direct light differ in two choices only:
///
/// - Which lights are sampled. `bsdf` and `mixture`: only point, spot and distant lights, which rays cannot hit.
///   `mis`: all lights but smooth skies. `light`: all.
/// - Which density scattering has in the weights of multiple importance sampling (mis_weights.h). `light` takes 0, so
///   that light samples get all the weight. All others take the true density, which is that of a mixture where
///   directions are also aimed at sampling targets.
///
/// Emission that light sampling cannot find has lightPdf 0 and is left to scattering. Where a medium scatters the path,
/// its phase function takes the place of the BSDF, and the rest is the same.
#include "steradian/core/samplers/sampler.h"
#include "steradian/core/sampling/direction_pdf.h"
#include "steradian/core/transport/ray_offset.h"
#include "steradian/integrators/path/mis_weights.h"
#include "steradian/integrators/path/path_context.h"
#include "steradian/integrators/path/path_state.h"
#include "steradian/integrators/path/scene_queries.h"
#include "steradian/integrators/render/integrator.h"
#include "steradian/materials/phase.h"

namespace STERADIAN_API steradian {

/// A vertex of the path, where light is gathered. Scatterer: Bsdf on a surface, Phase<float> in a medium.
template <class Scatterer>
struct PathVertex {
  ScatterPoint<float> point;
  Vec3f axis;  ///< the shading normal, turned to the side of wo
  Vec3f wo;
  const Scatterer& bsdf;
  ScatterPdf scatterPdf;
  float diracProbability;  ///< of sampling one of the BSDF's Dirac lobes
  bool lightSampled;       ///< false: of the lights only those are sampled that cannot be hit
  // Used in scenes with volumes only: the closed shapes that the path was inside of when it arrived, and the surface
  // that it arrived at (null in a medium).
  const InteriorStack* interior;
  const SurfacePoint<float>* surface;
};

/// The density, per steradian, with which sampleScatterPdf() takes a continuous lobe and chooses wi. `bsdfPdf` is the
/// density of the BSDF's own sampling.
template <class Vertex>
float scatterDensity(const Vertex& vertex, Vec3f wi, float bsdfPdf) {
  const float continuous = 1.0f - vertex.diracProbability;
  switch (vertex.scatterPdf) {
    case ScatterPdf::Bsdf:
      return bsdfPdf;
    case ScatterPdf::Cosine:
      return continuous * maximum(dot(wi, vertex.axis), 0.0f) * kInvPi;
    case ScatterPdf::Hemisphere:
      return dot(wi, vertex.axis) >= 0.0f ? continuous * kInvTwoPi : 0.0f;
    case ScatterPdf::Sphere:
      return continuous * kInvFourPi;
  }
  return 0.0f;
}

/// Samples a direction by PathVertex::scatterPdf: with the BSDF, or with the density that takes its place for
/// continuous lobes.
template <class Vertex>
BsdfSample<float> sampleScatterPdf(const Vertex& vertex, BsdfRandom<float> random) {
  const ScatterPdf kind = vertex.scatterPdf;
  if (kind == ScatterPdf::Bsdf || random.lobe < vertex.diracProbability) {
    return vertex.bsdf.sample(vertex.wo, random, Transport::Radiance);
  }
  DirectionSample<float> direction = SpherePdf<float>().sample(random.direction);
  if (kind == ScatterPdf::Cosine) direction = CosinePdf<float>(vertex.axis).sample(random.direction);
  if (kind == ScatterPdf::Hemisphere) direction = HemispherePdf<float>(vertex.axis).sample(random.direction);
  const BsdfValue<float> f = vertex.bsdf.eval(vertex.wo, direction.wi, Transport::Radiance);
  const float pdf = scatterDensity(vertex, direction.wi, f.pdf);
  if (!(pdf > 0.0f) || isBlack(f.value)) return {};
  return {f.value / pdf, direction.wi, pdf, kLobeDiffuse, 1.0f};
}

/// The density, per steradian, with which sampleNextDirection() takes a continuous lobe and chooses wi: that of the
/// mixture of sampling targets and scattering, or of scattering alone where there are no targets. `bsdfPdf` is the
/// density of the BSDF's own sampling.
template <class Queries, class Vertex>
float mixtureDensity(const PathPlan& plan, Queries& queries, const Vertex& vertex, Vec3f wi, float bsdfPdf) {
  const float scattered = scatterDensity(vertex, wi, bsdfPdf);
  if (!(plan.targetWeight > 0.0f)) return scattered;
  const float targetPdf = (1.0f - vertex.diracProbability) * queries.targetPdf(*plan.targets, vertex.point, wi);
  return plan.targetWeight * targetPdf + (1.0f - plan.targetWeight) * scattered;
}

/// Whether to aim at a target, and the random numbers for the direction. The first number makes the choice; what is
/// left of it, scaled to [0, 1), is used again, so that the directions of each kind are as well stratified as all
/// together.
template <class F>
struct MixtureChoice {
  MaskOf<F> aimed;
  Vec2<F> direction;

  MixtureChoice(float targetWeight, Vec2<F> u) : aimed(u.x < F(targetWeight)) {
    const F x = select(aimed, u.x / F(targetWeight), (u.x - F(targetWeight)) / F(1.0f - targetWeight));
    direction = {minimum(x, F(kOneMinusEpsilon)), u.y};
  }
};

/// Samples a direction from the mixture of sampling targets and scattering; its pdf is the marginal density of the
/// mixture. A Dirac lobe is chosen first, with its own probability: the mixture covers the continuous lobes.
template <class Queries, class Vertex>
BsdfSample<float> sampleMixture(const PathPlan& plan, Queries& queries, const Vertex& vertex, BsdfRandom<float> random,
                                const Sampler<float>& sampler, std::uint32_t bounce) {
  if (random.lobe < vertex.diracProbability) return vertex.bsdf.sample(vertex.wo, random, Transport::Radiance);
  Vec3f wi;
  const MixtureChoice<float> choice(plan.targetWeight, random.direction);
  if (choice.aimed) {
    const float select = plan.targets->size() > 1 ? sampler.get1D(bounce, Purpose::TargetSelect) : 0.0f;
    const DirectionSample<float> target = queries.sampleTarget(*plan.targets, vertex.point, {select, choice.direction});
    if (!(target.pdf > 0.0f)) return {};
    wi = target.wi;
  } else {
    const BsdfSample<float> scattered = sampleScatterPdf(vertex, {random.lobe, choice.direction});
    if (!(scattered.pdf > 0.0f)) return {};
    wi = scattered.wi;
  }
  const BsdfValue<float> f = vertex.bsdf.eval(vertex.wo, wi, Transport::Radiance);
  if (isBlack(f.value)) return {};
  const float pdf = mixtureDensity(plan, queries, vertex, wi, f.pdf);
  if (!(pdf > 0.0f)) return {};
  return {f.value / pdf, wi, pdf, kLobeDiffuse, 1.0f};
}

/// The transmittance of a shadow ray from the vertex: 0 if a surface occludes it, else what the media on its way let
/// through.
template <class Queries, class Vertex>
Rgb shadowTransmittance(Queries& queries, const Vertex& vertex, Ray<float> ray) {
  const Volumes& volumes = queries.volumes();
  if (!volumes.passable() && queries.occluded(ray)) return {};
  if (volumes.empty()) return grey(1.0f);
  InteriorStack interior = *vertex.interior;
  if (vertex.surface != nullptr) volumes.scatter(*vertex.surface, vertex.wo, ray.direction, interior);
  Rgb share = grey(1.0f);
  const auto reach = [&](float distance) {
    share *= volumes.media().at<float>(volumes.mediumIn(interior)).transmittance(distance - ray.tMin);
  };
  if (!volumes.passable()) {
    reach(ray.tMax);
    return share;
  }
  queries.countShadowRay();
  SurfacePoint<float> met;
  Crossings crossings;
  do {
    met = queries.surfacePoint(ray, queries.intersect(ray));
    reach(met.valid ? met.distance : ray.tMax);
    if (!met.valid) return share;
  } while (!isBlack(share) && crossings.pass(volumes, met, ray, interior));
  return {};
}

/// Next event estimation: radiance that leaves the vertex towards wo of light that arrives straight from the lights, by
/// light samples and shadow rays.
template <class Queries, class Vertex>
Rgb sampleDirectLight(const PathPlan& plan, Queries& queries, const Vertex& vertex, const Sampler<float>& sampler,
                      std::uint32_t bounce) {
  const LightSet& lights = vertex.lightSampled ? *plan.lights : *plan.diracLights;
  Rgb sum{};
  if (lights.empty() || vertex.diracProbability >= 1.0f) return sum;
  const float count = static_cast<float>(plan.lightSamples);
  for (std::uint32_t i = 0; i < plan.lightSamples; ++i) {
    // Further light samples take the random numbers of bounces beyond the last.
    const std::uint32_t own = bounce + i * (plan.maxDepth + 1);
    const float select = lights.size() > 1 ? sampler.get1D(own, Purpose::LightSelect) : 0.0f;
    const LightSample<float> light =
        queries.sampleLight(lights, vertex.point, {select, sampler.get2D(own, Purpose::LightPosition)});
    if (!(light.pdf > 0.0f)) continue;
    const BsdfValue<float> f = vertex.bsdf.eval(vertex.wo, light.wi, Transport::Radiance);
    if (isBlack(f.value)) continue;
    const Rgb visible = shadowTransmittance(queries, vertex, spawnRay(vertex.point, light.wi, light.distance));
    if (isBlack(visible)) continue;
    const float scatterPdf =
        plan.strategy == Strategy::Mis ? mixtureDensity(plan, queries, vertex, light.wi, f.pdf) : 0.0f;
    sum += f.value * light.weight * visible * lightSampleWeight(count, light.pdf, scatterPdf);
  }
  return sum / count;
}

/// The vertex at a point of a surface. It refers to `surface`, `bsdf` and `interior`.
inline PathVertex<Bsdf> vertexOf(const PathPlan& plan, const SurfacePoint<float>& surface, const Bsdf& bsdf, Vec3f wo,
                                 float time, const InteriorStack& interior) {
  const bool lightSampled = plan.strategy != Strategy::Light || bsdf.suitsLightSampling(wo);
  return {scatterPoint(surface, time),
          faceForward(bsdf.shadingNormal(), wo),
          wo,
          bsdf,
          plan.scatterPdf,
          bsdf.diracProbability(wo),
          lightSampled,
          &interior,
          &surface};
}

/// The vertex at a point where a medium scatters the path. It refers to `phase` and `interior`.
inline PathVertex<Phase<float>> vertexOf(Vec3f position, const Phase<float>& phase, Vec3f wo, float time,
                                         const InteriorStack& interior) {
  return {{position, {}, {}, time}, wo, wo, phase, ScatterPdf::Bsdf, 0.0f, true, &interior, nullptr};
}

/// Records what a camera ray met first where that is a medium: see setFirstHit() of integrator.h.
inline void setFirstHit(PixelSample& sample, const Medium<float>& medium, float distance) {
  sample.alpha = 1.0f;
  const auto share = [](float part, float whole) { return whole > 0.0f ? part / whole : 0.0f; };
  sample.albedo = {share(medium.scattering.r, medium.extinction.r), share(medium.scattering.g, medium.extinction.g),
                   share(medium.scattering.b, medium.extinction.b)};
  sample.depth = distance;
}

/// The probability with which a path survives Russian roulette (see PathSettings::rouletteStrength). `refraction` is
/// what the refractions so far have divided the throughput by: radiance is scaled there, but the path is worth as much.
template <class F>
F survivalProbability(float strength, const Spectrum<F>& throughput, F refraction) {
  return F(1.0f) - F(strength) * (F(1.0f) - minimum(maxChannel(throughput) * refraction, F(1.0f)));
}

/// Samples the direction in which the path goes on from a vertex; pdf 0: it ends there.
template <class Queries, class Vertex>
BsdfSample<float> sampleNextDirection(const PathPlan& plan, Queries& queries, const Vertex& vertex,
                                      const Sampler<float>& sampler, std::uint32_t bounce) {
  // All continuous lobes are sampled as one, so that a lobe is chosen only where there are Dirac lobes as well.
  const float lobe = vertex.diracProbability > 0.0f ? sampler.get1D(bounce, Purpose::BsdfLobe) : 0.0f;
  const BsdfRandom<float> random{lobe, sampler.get2D(bounce, Purpose::BsdfDirection)};
  if (plan.targetWeight > 0.0f) return sampleMixture(plan, queries, vertex, random, sampler, bounce);
  return sampleScatterPdf(vertex, random);
}

/// What a ray meets: a surface, or a point in a medium that scatters the path.
struct Interaction {
  SurfacePoint<float> surface;  ///< valid if it is a surface
  float outsideEta = 1.0f;      ///< of that surface: see Boundary
  bool inMedium = false;        ///< it is in `medium`, `distance` from the ray's origin
  Medium<float> medium;
  float distance = 0.0f;
  bool isLost = false;  ///< the ray was given up: see Crossings
};

/// Traces a ray through media, and through surfaces that do not stop it, to what it meets. `interior` holds the closed
/// shapes that the ray starts in, and in the end those that it is in there.
template <class Queries>
Interaction traceThroughMedia(Queries& queries, FreeFlight<float>& flight, Ray<float> ray, InteriorStack& interior) {
  const Volumes& volumes = queries.volumes();
  Interaction met;
  Crossings crossings;
  do {
    met.surface = queries.surfacePoint(ray, queries.intersect(ray));
    met.medium = volumes.media().at<float>(volumes.mediumIn(interior));
    const float distance = met.surface.valid ? met.surface.distance : kInfinity;
    met.inMedium = flight.sampleSegment(met.medium, ray, distance, true);
    if (!met.surface.valid || met.inMedium) break;
  } while (crossings.pass(volumes, met.surface, ray, interior));
  met.surface.valid = met.surface.valid && !met.inMedium;
  met.distance = flight.distance();
  met.outsideEta = crossings.outsideEta();
  met.isLost = crossings.isLost();
  return met;
}

/// Traces the ray of the path to what it meets next. The radiance that media emit on the way is added to `radiance`,
/// and the path's throughput is weakened by them.
template <class Queries>
Interaction nextInteraction(Queries& queries, const Sampler<float>& sampler, std::uint32_t bounce,
                            PathState<float>& path, InteriorStack& interior, Rgb& radiance) {
  Interaction met;
  if (queries.volumes().empty()) {
    met.surface = queries.surfacePoint(path.ray, queries.intersect(path.ray));
    return met;
  }
  FreeFlight<float> flight(path.throughput, sampler.get2D(bounce, Purpose::FreeFlight));
  met = traceThroughMedia(queries, flight, path.ray, interior);
  radiance += path.throughput * flight.emitted();
  path.throughput = met.isLost ? Rgb{} : path.throughput * flight.weight();
  return met;
}

/// Traces one path along a camera ray: the radiance that arrives by it, and what the ray met first.
template <class Queries>
PixelSample tracePath(const PathPlan& plan, Queries& queries, const Ray<float>& cameraRay,
                      const Sampler<float>& sampler) {
  const bool hasVolumes = !queries.volumes().empty();
  PixelSample result = kMiss;
  PathState<float> path(cameraRay);
  InteriorStack interior;  // the closed shapes that the ray is inside of
  if (hasVolumes) interior = queries.interiorAtStart(cameraRay);
  const float lightSamples = static_cast<float>(plan.lightSamples);
  std::uint32_t bounce = 0;
  for (;; ++bounce) {
    // Intersect the ray with the scene; a medium may scatter the path before.
    const Interaction met = nextInteraction(queries, sampler, bounce, path, interior, result.radiance);
    const SurfacePoint<float>& surface = met.surface;

    // Add the radiance that the surface emits, or the sky if there is none.
    if (!met.inMedium) {
      const Emission<float> emission = queries.emission(*plan.lights, path.from, path.ray, surface);
      const float weight = emissionWeight(path.fromDensity, lightSamples, emission.pdf);
      result.radiance += path.throughput * emission.radiance * weight;
    }
    if (!surface.valid && !met.inMedium) break;
    if (hasVolumes && isBlack(path.throughput)) break;

    // Sample direct light at the vertex, and the direction in which the path goes on from there.
    const auto shade = [&](const auto& vertex) {
      result.radiance += path.throughput * sampleDirectLight(plan, queries, vertex, sampler, bounce);
      const BsdfSample<float> next = sampleNextDirection(plan, queries, vertex, sampler, bounce);
      if (!(next.pdf > 0.0f)) return next;
      if (vertex.surface != nullptr) queries.volumes().scatter(surface, vertex.wo, next.wi, interior);
      path.ray = spawnRay(vertex.point, next.wi, kInfinity);
      path.from = vertex.point;
      path.fromDensity = competingDensity(plan.strategy, vertex.lightSampled, next.pdf);
      return next;
    };
    const Ray<float> ray = path.ray;
    const Vec3f wo = -ray.direction;
    const bool last = bounce == plan.maxDepth;
    BsdfSample<float> next;
    if (met.inMedium) {
      if (bounce == 0) setFirstHit(result, met.medium, met.distance);
      if (last) break;
      const Phase<float> phase{met.medium.anisotropy};
      next = shade(vertexOf(ray.at(met.distance), phase, wo, ray.time, interior));
    } else {
      const Bsdf bsdf = queries.bsdf(surface, wo, met.outsideEta);
      if (bounce == 0) setFirstHit(result, surface, bsdf, wo);
      if (last) break;
      next = shade(vertexOf(plan, surface, bsdf, wo, ray.time, interior));
    }
    if (!(next.pdf > 0.0f)) break;
    path.throughput *= next.weight;
    path.refraction *= sqr(next.eta);

    // End the path by chance if it carries little (Russian roulette).
    if (bounce >= plan.rouletteStart) {
      const float survival = survivalProbability(plan.rouletteStrength, path.throughput, path.refraction);
      if (!(sampler.get1D(bounce, Purpose::Roulette) < survival)) break;
      path.throughput *= 1.0f / survival;
    }
  }
  queries.countPath(bounce);
  return result;
}

}  // namespace steradian
