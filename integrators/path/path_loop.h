#pragma once
/// The loop of the path integrator: one path from the camera, light gathered at each vertex.
///
/// The direct-light strategies differ in two choices only: which lights are sampled at a vertex, and which density
/// scattering is taken to have when it competes with light sampling in the power heuristic. `bsdf` and `mixture` sample
/// those lights only that cannot be hit. `mis` samples all but smooth skies and takes the true density, which is that
/// of the mixture with sampling targets where there are any. `light` samples all and takes 0, so that light samples get
/// all the weight, hits of emitters none. Dirac lobes have infinity in every strategy. What light sampling cannot find
/// has pdf 0 as emission and belongs to scattering alone.
///
/// Where a medium scatters the path, its phase function takes the place of the BSDF, and the rest is the same.
#include "steradian/core/samplers/sampler.h"
#include "steradian/core/sampling/direction_pdf.h"
#include "steradian/core/transport/ray_offset.h"
#include "steradian/integrators/path/path_settings.h"
#include "steradian/integrators/path/scene_queries.h"
#include "steradian/integrators/render/integrator.h"
#include "steradian/materials/phase.h"

namespace STERADIAN_API steradian {

/// The settings, as they apply to one scene.
struct PathPlan {
  Strategy strategy;
  ScatterPdf scatterPdf;
  std::uint32_t maxDepth, lightSamples, rouletteStart;
  float rouletteStrength;
  std::uint32_t reuse = 1;      ///< see PathSettings
  float targetWeight;           ///< 0 where there is no target
  const LightSet* lights;       ///< sampled at vertices
  const LightSet* diracLights;  ///< sampled at those that PathVertex::lightSampled is false for
  const TargetSet* targets;     ///< null where targetWeight is 0
};

/// Where light arrives and leaves. Scatterer: Bsdf, or Phase<float> in a medium.
template <class Scatterer>
struct PathVertex {
  ScatterPoint<float> point;
  Vec3f axis;  ///< the shading normal, turned to the side of wo
  Vec3f wo;
  const Scatterer& bsdf;
  ScatterPdf scatterPdf;
  float diracProbability;  ///< of sampling one of the BSDF's Dirac lobes
  bool lightSampled;       ///< lights that could also be hit are sampled for it
  /// Where there are volumes: the bodies that the path came through, and the surface, or null in a medium.
  const InteriorStack* interior;
  const SurfacePoint<float>* surface;
};

/// The density, per steradian, with which `scatter` takes a continuous lobe and chooses wi; `bsdfPdf` is the BSDF's
/// own.
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

/// The BSDF's sample, or for its continuous lobes one of the density asked for.
template <class Vertex>
BsdfSample<float> scatter(const Vertex& vertex, BsdfRandom<float> random) {
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

/// The density with which a continuous lobe's wi is chosen by the mixture of targets and scattering, if there is one;
/// `bsdfPdf` is the BSDF's own.
template <class Queries, class Vertex>
float mixedDensity(const PathPlan& plan, Queries& queries, const Vertex& vertex, Vec3f wi, float bsdfPdf) {
  const float scattered = scatterDensity(vertex, wi, bsdfPdf);
  if (!(plan.targetWeight > 0.0f)) return scattered;
  const float targetPdf = (1.0f - vertex.diracProbability) * queries.targetPdf(*plan.targets, vertex.point, wi);
  return plan.targetWeight * targetPdf + (1.0f - plan.targetWeight) * scattered;
}

/// Whether to aim at a target, and the numbers for the direction: the first of them chooses and is used again, so that
/// the directions of either kind are as well distributed as all together.
template <class F>
struct MixtureChoice {
  MaskOf<F> aimed;
  Vec2<F> direction;

  MixtureChoice(float targetWeight, Vec2<F> u) : aimed(u.x < F(targetWeight)) {
    const F x = select(aimed, u.x / F(targetWeight), (u.x - F(targetWeight)) / F(1.0f - targetWeight));
    direction = {minimum(x, F(kOneMinusEpsilon)), u.y};
  }
};

/// One direction from the mixture of targets and scattering, over its marginal density. Dirac lobes come first, with
/// their own probability; the mixture covers the continuous ones.
template <class Queries, class Vertex>
BsdfSample<float> scatterMixture(const PathPlan& plan, Queries& queries, const Vertex& vertex, BsdfRandom<float> random,
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
    const BsdfSample<float> scattered = scatter(vertex, {random.lobe, choice.direction});
    if (!(scattered.pdf > 0.0f)) return {};
    wi = scattered.wi;
  }
  const BsdfValue<float> f = vertex.bsdf.eval(vertex.wo, wi, Transport::Radiance);
  if (isBlack(f.value)) return {};
  const float pdf = mixedDensity(plan, queries, vertex, wi, f.pdf);
  if (!(pdf > 0.0f)) return {};
  return {f.value / pdf, wi, pdf, kLobeDiffuse, 1.0f};
}

/// The density that scattering is taken to have where emission can be found by it and by light sampling (see above).
template <class F>
F competingDensity(Strategy strategy, MaskOf<F> lightSampled, F pdf) {
  if (strategy != Strategy::Light) return pdf;
  return select(lightSampled & (pdf != F(kDirac)), F(0.0f), F(kDirac));
}

/// The share of light that arrives at a vertex through its shadow ray.
template <class Queries, class Vertex>
Rgb visibility(Queries& queries, const Vertex& vertex, Ray<float> ray) {
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

/// Radiance that leaves the vertex towards wo, of light that arrives straight from the lights.
template <class Queries, class Vertex>
Rgb directLight(const PathPlan& plan, Queries& queries, const Vertex& vertex, const Sampler<float>& sampler,
                std::uint32_t bounce) {
  const LightSet& lights = vertex.lightSampled ? *plan.lights : *plan.diracLights;
  Rgb sum{};
  if (lights.empty() || vertex.diracProbability >= 1.0f) return sum;
  const float count = static_cast<float>(plan.lightSamples);
  for (std::uint32_t i = 0; i < plan.lightSamples; ++i) {
    // Further samples take the dimensions of bounces that no path reaches.
    const std::uint32_t own = bounce + i * (plan.maxDepth + 1);
    const float select = lights.size() > 1 ? sampler.get1D(own, Purpose::LightSelect) : 0.0f;
    const LightSample<float> light =
        queries.sampleLight(lights, vertex.point, {select, sampler.get2D(own, Purpose::LightPosition)});
    if (!(light.pdf > 0.0f)) continue;
    const BsdfValue<float> f = vertex.bsdf.eval(vertex.wo, light.wi, Transport::Radiance);
    if (isBlack(f.value)) continue;
    const Rgb visible = visibility(queries, vertex, spawnRay(vertex.point, light.wi, light.distance));
    if (isBlack(visible)) continue;
    const float other = plan.strategy == Strategy::Mis ? mixedDensity(plan, queries, vertex, light.wi, f.pdf) : 0.0f;
    sum += f.value * light.weight * visible * misWeight(count * light.pdf, other);
  }
  return sum / count;
}

/// The vertex at a point of a surface; `bsdf` must outlive it.
inline PathVertex<Bsdf> vertexOf(const PathPlan& plan, const SurfacePoint<float>& surface, const Bsdf& bsdf, Vec3f wo,
                                 float time, const InteriorStack& interior) {
  const bool lightSampled = plan.strategy != Strategy::Light || bsdf.samplesLights(wo);
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

/// The vertex where a medium scatters; what must outlive it, likewise.
inline PathVertex<Phase<float>> vertexOf(Vec3f position, const Phase<float>& phase, Vec3f wo, float time,
                                         const InteriorStack& interior) {
  return {{position, {}, {}, time}, wo, wo, phase, ScatterPdf::Bsdf, 0.0f, true, &interior, nullptr};
}

/// What the path met first, where that is a medium.
inline void setFirstHit(PixelSample& sample, const Medium<float>& medium, float distance) {
  sample.alpha = 1.0f;
  const auto share = [](float part, float whole) { return whole > 0.0f ? part / whole : 0.0f; };
  sample.albedo = {share(medium.scattering.r, medium.extinction.r), share(medium.scattering.g, medium.extinction.g),
                   share(medium.scattering.b, medium.extinction.b)};
  sample.depth = distance;
}

/// The probability of going on (PathSettings::rouletteStrength); `refraction` is what refraction has divided the
/// throughput by, which says nothing about how much light the path will find.
template <class F>
F survivalProbability(float strength, const Spectrum<F>& throughput, F refraction) {
  return F(1.0f) - F(strength) * (F(1.0f) - minimum(maxChannel(throughput) * refraction, F(1.0f)));
}

/// Where the path goes on from a vertex; pdf 0: nowhere.
template <class Queries, class Vertex>
BsdfSample<float> scatteredRay(const PathPlan& plan, Queries& queries, const Vertex& vertex,
                               const Sampler<float>& sampler, std::uint32_t bounce) {
  // Continuous parts are one lobe each: only where there are Dirac lobes is there something to choose.
  const float lobe = vertex.diracProbability > 0.0f ? sampler.get1D(bounce, Purpose::BsdfLobe) : 0.0f;
  const BsdfRandom<float> random{lobe, sampler.get2D(bounce, Purpose::BsdfDirection)};
  if (plan.targetWeight > 0.0f) return scatterMixture(plan, queries, vertex, random, sampler, bounce);
  return scatter(vertex, random);
}

/// Where a path's ray leads it.
struct Arrival {
  SurfacePoint<float> surface;  ///< valid if the path has come to one
  float outsideEta = 1.0f;      ///< see Boundary: of the surface
  bool inMedium = false;        ///< scattered before: in `medium`, `distance` from the ray's origin
  Medium<float> medium;
  float distance = 0.0f;
  bool isLost = false;  ///< given up (see Crossings)
};

/// The flight along `ray` to where it arrives, inside of `interior` in the end.
template <class Queries>
Arrival fly(Queries& queries, FreeFlight<float>& flight, Ray<float> ray, InteriorStack& interior) {
  const Volumes& volumes = queries.volumes();
  Arrival arrival;
  Crossings crossings;
  do {
    arrival.surface = queries.surfacePoint(ray, queries.intersect(ray));
    arrival.medium = volumes.media().at<float>(volumes.mediumIn(interior));
    const float distance = arrival.surface.valid ? arrival.surface.distance : kInfinity;
    arrival.inMedium = flight.sampleSegment(arrival.medium, ray, distance, true);
    if (!arrival.surface.valid || arrival.inMedium) break;
  } while (crossings.pass(volumes, arrival.surface, ray, interior));
  arrival.surface.valid = arrival.surface.valid && !arrival.inMedium;
  arrival.distance = flight.distance();
  arrival.outsideEta = crossings.outsideEta();
  arrival.isLost = crossings.isLost();
  return arrival;
}

/// One path along `ray`: the radiance that arrives by it, and what it met first.
template <class Queries>
PixelSample tracePath(const PathPlan& plan, Queries& queries, Ray<float> ray, const Sampler<float>& sampler) {
  const bool hasVolumes = !queries.volumes().empty();
  PixelSample result = kMiss;
  Rgb throughput = grey(1.0f);
  ScatterPoint<float> from{ray.origin, {}, {}, ray.time};
  InteriorStack interior;  // that the ray is inside of
  if (hasVolumes) interior = queries.interiorAtStart(ray);
  float fromDensity = kDirac;  // competingDensity of ray.direction
  float refraction = 1.0f;
  const float lightSamples = static_cast<float>(plan.lightSamples);
  std::uint32_t bounce = 0;
  for (;; ++bounce) {
    Arrival arrival;
    if (hasVolumes) {
      FreeFlight<float> flight(throughput, sampler.get2D(bounce, Purpose::FreeFlight));
      arrival = fly(queries, flight, ray, interior);
      result.radiance += throughput * flight.emitted();
      throughput = arrival.isLost ? Rgb{} : throughput * flight.weight();
    } else {
      arrival.surface = queries.surfacePoint(ray, queries.intersect(ray));
    }
    const SurfacePoint<float>& surface = arrival.surface;
    const bool inMedium = arrival.inMedium;
    if (!inMedium) {
      const Emission<float> emission = queries.emission(*plan.lights, from, ray, surface);
      const float weight = emission.pdf > 0.0f ? misWeight(fromDensity, lightSamples * emission.pdf) : 1.0f;
      result.radiance += throughput * emission.radiance * weight;
    }
    if (!surface.valid && !inMedium) break;
    if (hasVolumes && isBlack(throughput)) break;

    // Direct light at a vertex, and where the path goes on from there.
    const auto shade = [&](const auto& vertex) {
      result.radiance += throughput * directLight(plan, queries, vertex, sampler, bounce);
      const BsdfSample<float> next = scatteredRay(plan, queries, vertex, sampler, bounce);
      if (!(next.pdf > 0.0f)) return next;
      if (vertex.surface != nullptr) queries.volumes().scatter(surface, vertex.wo, next.wi, interior);
      ray = spawnRay(vertex.point, next.wi, kInfinity);
      from = vertex.point;
      fromDensity = competingDensity(plan.strategy, vertex.lightSampled, next.pdf);
      return next;
    };
    const Vec3f wo = -ray.direction;
    const bool last = bounce == plan.maxDepth;
    BsdfSample<float> next;
    if (inMedium) {
      if (bounce == 0) setFirstHit(result, arrival.medium, arrival.distance);
      if (last) break;
      const Phase<float> phase{arrival.medium.anisotropy};
      next = shade(vertexOf(ray.at(arrival.distance), phase, wo, ray.time, interior));
    } else {
      const Bsdf bsdf = queries.bsdf(surface, wo, arrival.outsideEta);
      if (bounce == 0) setFirstHit(result, surface, bsdf, wo);
      if (last) break;
      next = shade(vertexOf(plan, surface, bsdf, wo, ray.time, interior));
    }
    if (!(next.pdf > 0.0f)) break;
    throughput *= next.weight;
    refraction *= sqr(next.eta);
    if (bounce >= plan.rouletteStart) {
      const float survival = survivalProbability(plan.rouletteStrength, throughput, refraction);
      if (!(sampler.get1D(bounce, Purpose::Roulette) < survival)) break;
      throughput *= 1.0f / survival;
    }
  }
  queries.countPath(bounce);
  return result;
}

}  // namespace steradian
