#pragma once
/// The stages of path tracing for several paths at once, one in each lane: nextVertex(), sampleDirectLight() and
/// scatter(), in this order for each vertex (path_packet.h has the loop).
///
/// Each lane computes what path_loop.h computes for one path, by the same operations in the same order, so that
/// pictures are the same to the bit. Where lanes differ (in material, light or kind of shape), each alternative is
/// computed once, for the lanes that have it.
#include <bit>

#include "steradian/integrators/path/path_loop.h"
#include "steradian/integrators/path/path_state.h"
#include "steradian/integrators/path/wide_free_flight.h"
#include "steradian/integrators/path/wide_scene.h"

namespace STERADIAN_API steradian {

template <class F>
class PathLanes {
 public:
  using Mask = MaskOf<F>;
  using Uint = UintOf<F>;

  PathLanes(const WideScene& scene, const PathPlan& plan, PathCounts& counts)
      : scene_(scene),
        plan_(plan),
        counts_(counts),
        flight_(scene, counts),
        hasVolumes_(flight_.needed()),
        byLane_(plan.scatterPdf != ScatterPdf::Bsdf) {}

  /// The next vertices of the paths. For the members not described here see PathVertex.
  struct Vertex {
    SurfacePoint<F> surface;
    Mask hit{false};  ///< the path has a vertex; where it has none, it has ended
    ScatterPoint<F> point;
    Vec3<F> wo;
    ShadingFrame<F> frame;
    MaterialTable::Parameters<F> material;
    F diracProbability{0.0f};
    Mask lightSampled{true};
    // In scenes with volumes:
    Mask inMedium{false};  ///< a medium scatters the path there
    F anisotropy{0.0f};    ///< of that medium

    /// intersect() returns the surfaces that the paths' rays meet. (It is called here so that the points, which are
    /// large, are built in place.)
    template <class Intersect>
    Vertex(const MaterialTable& materials, const PathState<F>& path, const Intersect& intersect)
        : surface(intersect()),
          point(scatterPoint(surface, path.ray.time)),
          wo(-path.ray.direction),
          frame(surface.geometricNormal, usableShadingNormal(surface.geometricNormal, surface.shadingNormal, wo)),
          material(materials.parameters(surface, surface.valid)) {}
  };

  /// First stage: traces the rays of the active paths to their next vertices. The radiance emitted there, by the sky
  /// and by media on the way is added to `radiance`.
  [[gnu::always_inline]] inline Vertex nextVertex(PathState<F>& path, const Sampler<F>& sampler, Uint bounce,
                                                  Mask active, Spectrum<F>& radiance);
  /// Second stage, next event estimation: radiance that leaves the vertices towards wo of light that arrives straight
  /// from the lights, by light samples and shadow rays.
  Spectrum<F> sampleDirectLight(const Vertex& vertex, const Sampler<F>& sampler, Uint bounce, Mask going);
  struct Scattered {
    Mask going;  ///< the paths that go on
    F pdf;       ///< the density of their directions; may be kDirac
  };
  /// Third stage: samples the directions in which paths go on, plays Russian roulette, and makes `path` the state of
  /// those that are left.
  Scattered scatter(const Vertex& vertex, const Sampler<F>& sampler, Uint bounce, Mask going, PathState<F>& path);

  /// Records what camera rays have met first: sampleOf(i) returns the PixelSample& of lane i.
  template <class SampleOf>
  void recordFirstHit(const Vertex& vertex, Mask lanes, const SampleOf& sampleOf) const;
  /// The BSDF (or phase function) times the cosine for light from wi, and the density with which scatter() takes a
  /// continuous lobe and chooses wi.
  BsdfValue<F> evaluate(const Vertex& vertex, const Vec3<F>& wi, Mask lanes) const {
    BsdfValue<F> f = eval(vertex, wi, lanes);
    f.pdf = mixtureDensity(vertex, wi, f.pdf, lanes);
    return f;
  }

  bool hasVolumes() const { return hasVolumes_; }
  /// In scenes with volumes: the closed shapes that the lanes' rays are inside of, and their free flight.
  WideFreeFlight<F>& flight() { return flight_; }

 private:
  /// A model of reflection in its shading frame: what evaluates and samples like Phase.
  template <class Model>
  struct Shading {
    const ShadingFrame<F>& frame;
    const Model& model;

    BsdfValue<F> eval(Vec3<F> wo, Vec3<F> wi, Transport t) const { return frame.eval(model, wo, wi, t); }
    BsdfSample<F> sample(Vec3<F> wo, const BsdfRandom<F>& random, Transport t) const {
      return frame.sample(model, wo, random, t);
    }
  };
  /// Calls visit(scatterer, lanes) for Phase and for each kind of Shading that active lanes have.
  template <class Visit>
  void forEachScatterer(const Vertex& vertex, Mask active, const Visit& visit) const {
    if (hasVolumes_) {
      const Mask mine = active & vertex.inMedium;
      if (any(mine)) visit(Phase<F>{vertex.anisotropy}, mine);
      active = active & !vertex.inMedium;
    }
    scene_.materials().forEachModel(vertex.material, active, [&](const auto& model, Mask mine) {
      visit(Shading<std::decay_t<decltype(model)>>{vertex.frame, model}, mine);
    });
  }

  /// The surfaces that the paths' rays meet. (Two returns, as a conditional operator would copy the points.)
  SurfacePoint<F> intersect(PathState<F>& path, const Sampler<F>& sampler, Uint bounce, Mask active,
                            Spectrum<F>& radiance) {
    if (!hasVolumes_) return scene_.intersect(path.ray, active, &counts_.embree);
    return flight_.traceThroughMedia(path.ray, active, sampler.get2D(bounce, Purpose::FreeFlight), path.throughput,
                                     radiance);
  }
  /// Adds what surfaces and skies emit towards where the rays come from. `lanes`: those that no medium has scattered.
  void addEmittedRadiance(const PathState<F>& path, const SurfacePoint<F>& surface, Mask lanes, Spectrum<F>& radiance);
  /// Moves vertices in media to where these scatter, and makes the index of dielectrics relative to what is outside.
  [[gnu::noinline]] void applyMedia(Vertex& vertex);
  Spectrum<F> sampleDirectLight(const LightSet& lights, const Vertex& vertex, const Sampler<F>& sampler, Uint bounce,
                                Mask lit);
  BsdfValue<F> eval(const Vertex& vertex, const Vec3<F>& wi, Mask lanes) const;
  BsdfSample<F> sample(const Vertex& vertex, const BsdfRandom<F>& random, Mask lanes) const;
  // The functions of these names in path_loop.h, for several paths.
  F mixtureDensity(const Vertex& vertex, const Vec3<F>& wi, F scattered, Mask lanes) const;
  BsdfSample<F> sampleNextDirection(const Vertex& vertex, const Sampler<F>& sampler, Uint bounce, Mask going);
  [[gnu::noinline]] BsdfSample<F> sampleMixture(const Vertex& vertex, const BsdfRandom<F>& random,
                                                const Sampler<F>& sampler, Uint bounce, Mask going);
  /// Ends paths by chance that carry little, and returns those that go on, their throughput raised.
  Mask playRoulette(const Sampler<F>& sampler, Uint bounce, Mask going, PathState<F>& path);
  /// Calls visit(vertex, sampler, bounce, lane) for the lanes one by one, with a PathVertex: densities other than the
  /// BSDF's (PathPlan::scatterPdf) are left to the functions of path_loop.h.
  template <class Visit>
  void forEachVertex(const Vertex& vertex, const Sampler<F>& sampler, Uint bounce, Mask lanes, const Visit& visit);

  const WideScene& scene_;
  const PathPlan& plan_;
  PathCounts& counts_;
  WideFreeFlight<F> flight_;
  bool hasVolumes_;
  bool byLane_;  ///< vertices are dealt with by forEachVertex()
};

template <class F>
typename PathLanes<F>::Vertex PathLanes<F>::nextVertex(PathState<F>& path, const Sampler<F>& sampler, Uint bounce,
                                                       Mask active, Spectrum<F>& radiance) {
  // Intersect the rays with the scene; media may scatter paths before.
  Vertex vertex(scene_.materials(), path, [&] { return intersect(path, sampler, bounce, active, radiance); });
  const SurfacePoint<F>& surface = vertex.surface;
  vertex.hit = active & surface.valid;
  Mask unscattered = active;
  if (hasVolumes_) {
    unscattered = active & !flight_.inMedium();
    vertex.hit = (vertex.hit | (active & flight_.inMedium())) & !isBlack(path.throughput);
  }
  addEmittedRadiance(path, surface, unscattered, radiance);

  // Ask the materials what decides how the vertex is sampled.
  Mask onSurface = vertex.hit;
  if (hasVolumes_) {
    applyMedia(vertex);
    onSurface = onSurface & !vertex.inMedium;
  }
  const Vec3<F> localWo = vertex.frame.toLocal(vertex.wo);
  scene_.materials().forEachModel(vertex.material, onSurface, [&](const auto& model, Mask mine) {
    vertex.diracProbability = select(mine, model.diracProbability(localWo), vertex.diracProbability);
    if (plan_.strategy == Strategy::Light) {
      vertex.lightSampled = select(mine, Mask(suitsLightSampling(model, localWo)), vertex.lightSampled);
    }
  });
  return vertex;
}

template <class F>
template <class SampleOf>
void PathLanes<F>::recordFirstHit(const Vertex& vertex, Mask lanes, const SampleOf& sampleOf) const {
  const Vec3<F> normal = faceForward(vertex.frame.shadingNormal(), vertex.wo);
  const Vec3<F> localWo = vertex.frame.toLocal(vertex.wo);
  Spectrum<F> albedo;
  scene_.materials().forEachModel(vertex.material, lanes & !vertex.inMedium, [&](const auto& model, Mask mine) {
    albedo = select(mine, model.albedo(localWo), albedo);
  });
  forEachLane(lanes, [&](int i) {
    PixelSample& sample = sampleOf(i);
    if (lane(vertex.inMedium, i)) {
      setFirstHit(sample, lane(flight_.medium(), i), lane(flight_.distance(), i));
      return;
    }
    sample.alpha = 1.0f;
    sample.albedo = lane(albedo, i);
    sample.normal = lane(normal, i);
    sample.depth = lane(vertex.surface.distance, i);
  });
}

template <class F>
void PathLanes<F>::addEmittedRadiance(const PathState<F>& path, const SurfacePoint<F>& surface, Mask lanes,
                                      Spectrum<F>& radiance) {
  const float lightSamples = static_cast<float>(plan_.lightSamples);
  const Mask finds = scene_.findsLight(surface, lanes), sky = finds & !surface.valid;
  if (any(sky)) {
    const Emission<F> emission = plan_.lights->skyEmission(path.from, path.ray.direction);
    const F weight = emissionWeight(path.fromDensity, F(lightSamples), emission.pdf);
    radiance = select(sky, radiance + path.throughput * emission.radiance * weight, radiance);
  }
  // Lane by lane, as few hit an emitter at the same time: mostly a path ends there.
  forEachLane(finds & surface.valid, [&](int i) {
    const PathState<float> one = lane(path, i);
    const Emission<float> emission = plan_.lights->emission(one.from, one.ray, lane(surface, i));
    const float weight = emissionWeight(one.fromDensity, lightSamples, emission.pdf);
    setLane(radiance, i, lane(radiance, i) + one.throughput * emission.radiance * weight);
  });
}

template <class F>
void PathLanes<F>::applyMedia(Vertex& vertex) {
  const Mask inMedium = flight_.inMedium();
  vertex.inMedium = inMedium;
  vertex.material.outsideEta = flight_.outsideEta();
  vertex.point.position = select(inMedium, flight_.position(), vertex.point.position);
  vertex.point.positionError = select(inMedium, Vec3<F>{}, vertex.point.positionError);
  vertex.point.geometricNormal = select(inMedium, Vec3<F>{}, vertex.point.geometricNormal);
  vertex.anisotropy = flight_.medium().anisotropy;
}

template <class F>
Spectrum<F> PathLanes<F>::sampleDirectLight(const Vertex& vertex, const Sampler<F>& sampler, Uint bounce, Mask going) {
  if (byLane_) {
    Spectrum<F> light;
    SceneQueries queries(scene_.scene(), counts_);
    forEachVertex(vertex, sampler, bounce, going, [&](const auto& one, const auto& own, std::uint32_t k, int i) {
      setLane(light, i, steradian::sampleDirectLight(plan_, queries, one, own, k));
    });
    return light;
  }
  const Mask lit = going & (vertex.diracProbability < F(1.0f));
  if (plan_.strategy != Strategy::Light) return sampleDirectLight(*plan_.lights, vertex, sampler, bounce, lit);
  const Spectrum<F> all = sampleDirectLight(*plan_.lights, vertex, sampler, bounce, lit & vertex.lightSampled);
  return all + sampleDirectLight(*plan_.diracLights, vertex, sampler, bounce, lit & !vertex.lightSampled);
}

template <class F>
Spectrum<F> PathLanes<F>::sampleDirectLight(const LightSet& lights, const Vertex& vertex, const Sampler<F>& sampler,
                                            Uint bounce, Mask lit) {
  Spectrum<F> sum;
  if (lights.empty() || !any(lit)) return sum;
  const F count(static_cast<float>(plan_.lightSamples));
  for (std::uint32_t k = 0; k < plan_.lightSamples; ++k) {
    const Uint own = bounce + Uint(k * (plan_.maxDepth + 1));
    const F choice = lights.size() > 1 ? sampler.get1D(own, Purpose::LightSelect) : F(0.0f);
    const LightSample<F> light =
        lights.sample(vertex.point, LightRandom<F>{choice, sampler.get2D(own, Purpose::LightPosition)}, lit);
    Mask sampled = lit & (light.pdf > F(0.0f));
    const BsdfValue<F> f = eval(vertex, light.wi, sampled);
    sampled = sampled & !isBlack(f.value);
    if (!any(sampled)) continue;
    counts_.shadowRays += static_cast<std::uint64_t>(std::popcount(laneBits(sampled)));
    const Ray<F> shadow = spawnRay(vertex.point, light.wi, light.distance);
    const F scatterPdf = plan_.strategy == Strategy::Mis ? mixtureDensity(vertex, light.wi, f.pdf, sampled) : F(0.0f);
    const F weight = lightSampleWeight(count, light.pdf, scatterPdf);
    if (hasVolumes_) {
      const Spectrum<F> visible = flight_.shadowTransmittance(vertex.surface, vertex.wo, shadow, sampled);
      sum += select(sampled & !isBlack(visible), f.value * light.weight * visible * weight, Spectrum<F>{});
    } else {
      const Mask visible = sampled & !scene_.occluded(shadow, sampled, &counts_.embree);
      sum += select(visible, f.value * light.weight * weight, Spectrum<F>{});
    }
  }
  return sum / count;
}

template <class F>
BsdfValue<F> PathLanes<F>::eval(const Vertex& vertex, const Vec3<F>& wi, Mask lanes) const {
  BsdfValue<F> f;
  forEachScatterer(vertex, lanes, [&](const auto& scatterer, Mask mine) {
    const BsdfValue<F> v = scatterer.eval(vertex.wo, wi, Transport::Radiance);
    f.value = select(mine, v.value, f.value);
    f.pdf = select(mine, v.pdf, f.pdf);
  });
  return f;
}

template <class F>
BsdfSample<F> PathLanes<F>::sample(const Vertex& vertex, const BsdfRandom<F>& random, Mask lanes) const {
  BsdfSample<F> sample;
  forEachScatterer(vertex, lanes, [&](const auto& scatterer, Mask mine) {
    const BsdfSample<F> s = scatterer.sample(vertex.wo, random, Transport::Radiance);
    sample.weight = select(mine, s.weight, sample.weight);
    sample.wi = select(mine, s.wi, sample.wi);
    sample.pdf = select(mine, s.pdf, sample.pdf);
    sample.eta = select(mine, s.eta, sample.eta);
  });
  return sample;
}

template <class F>
F PathLanes<F>::mixtureDensity(const Vertex& vertex, const Vec3<F>& wi, F scattered, Mask lanes) const {
  if (!(plan_.targetWeight > 0.0f)) return scattered;
  const F targetPdf = (F(1.0f) - vertex.diracProbability) * plan_.targets->pdfDirection(vertex.point, wi, lanes);
  return F(plan_.targetWeight) * targetPdf + F(1.0f - plan_.targetWeight) * scattered;
}

template <class F>
BsdfSample<F> PathLanes<F>::sampleNextDirection(const Vertex& vertex, const Sampler<F>& sampler, Uint bounce,
                                                Mask going) {
  if (byLane_) {
    BsdfSample<F> samples;
    SceneQueries queries(scene_.scene(), counts_);
    forEachVertex(vertex, sampler, bounce, going, [&](const auto& one, const auto& own, std::uint32_t k, int i) {
      const BsdfSample<float> next = steradian::sampleNextDirection(plan_, queries, one, own, k);
      setLane(samples.weight, i, next.weight);
      setLane(samples.wi, i, next.wi);
      setLane(samples.pdf, i, next.pdf);
      setLane(samples.eta, i, next.eta);
    });
    return samples;
  }
  const Mask choosing = going & (vertex.diracProbability > F(0.0f));
  F lobe(0.0f);
  if (any(choosing)) lobe = select(choosing, sampler.get1D(bounce, Purpose::BsdfLobe), lobe);
  const BsdfRandom<F> random{lobe, sampler.get2D(bounce, Purpose::BsdfDirection)};
  if (plan_.targetWeight > 0.0f) return sampleMixture(vertex, random, sampler, bounce, going);
  return sample(vertex, random, going);
}

template <class F>
BsdfSample<F> PathLanes<F>::sampleMixture(const Vertex& vertex, const BsdfRandom<F>& random, const Sampler<F>& sampler,
                                          Uint bounce, Mask going) {
  const Mask mixed = going & !(random.lobe < vertex.diracProbability);
  const MixtureChoice<F> choice(plan_.targetWeight, random.direction);
  const Mask aimed = mixed & choice.aimed;
  const BsdfSample<F> scattered = sample(vertex, {random.lobe, choice.direction}, going & !aimed);
  DirectionSample<F> target;
  if (any(aimed)) {
    const F select = plan_.targets->size() > 1 ? sampler.get1D(bounce, Purpose::TargetSelect) : F(0.0f);
    const LightRandom<F> targetRandom{select, choice.direction};
    target = plan_.targets->sampleDirection(vertex.point, targetRandom, aimed);
  }
  const Vec3<F> wi = select(aimed, target.wi, scattered.wi);
  const Mask found = mixed & (select(aimed, target.pdf, scattered.pdf) > F(0.0f));
  const BsdfValue<F> f = eval(vertex, wi, found);
  const Mask lit = found & !isBlack(f.value);
  const F pdf = any(lit) ? select(lit, mixtureDensity(vertex, wi, f.pdf, lit), F(0.0f)) : F(0.0f);
  return {select(mixed, f.value / pdf, scattered.weight), wi, select(mixed, pdf, scattered.pdf), Lobe<F>(kLobeDiffuse),
          select(mixed, F(1.0f), scattered.eta)};
}

template <class F>
template <class Visit>
void PathLanes<F>::forEachVertex(const Vertex& vertex, const Sampler<F>& sampler, Uint bounce, Mask lanes,
                                 const Visit& visit) {
  forEachLane(lanes, [&](int i) {
    const SurfacePoint<float> surface = lane(vertex.surface, i);
    const Vec3f wo = lane(vertex.wo, i);
    const float time = lane(vertex.point.time, i);
    const Sampler<float> own(sampler.settings(), lane(sampler.pixel(), i), lane(sampler.sample(), i));
    const std::uint32_t k = lane(bounce, i);
    if (lane(vertex.inMedium, i)) {
      const Phase<float> phase{lane(vertex.anisotropy, i)};
      visit(vertexOf(lane(vertex.point.position, i), phase, wo, time, flight_.interior(i)), own, k, i);
    } else {
      const Bsdf bsdf = scene_.scene().materials().bsdf(surface, wo, lane(flight_.outsideEta(), i));
      visit(vertexOf(plan_, surface, bsdf, wo, time, flight_.interior(i)), own, k, i);
    }
  });
}

template <class F>
MaskOf<F> PathLanes<F>::playRoulette(const Sampler<F>& sampler, Uint bounce, Mask going, PathState<F>& path) {
  const Mask atStake = going & !(bounce < Uint(plan_.rouletteStart));
  if (!any(atStake)) return going;
  const F survival = survivalProbability(plan_.rouletteStrength, path.throughput, path.refraction);
  path.throughput = select(atStake, path.throughput * (F(1.0f) / survival), path.throughput);
  return going & ((!atStake) | (sampler.get1D(bounce, Purpose::Roulette) < survival));
}

template <class F>
typename PathLanes<F>::Scattered PathLanes<F>::scatter(const Vertex& vertex, const Sampler<F>& sampler, Uint bounce,
                                                       Mask going, PathState<F>& path) {
  const BsdfSample<F> next = sampleNextDirection(vertex, sampler, bounce, going);
  going = going & (next.pdf > F(0.0f));
  path.throughput = select(going, path.throughput * next.weight, path.throughput);
  path.refraction = select(going, path.refraction * sqr(next.eta), path.refraction);
  going = playRoulette(sampler, bounce, going, path);
  if (hasVolumes_) flight_.scatter(vertex.surface, vertex.wo, next.wi, going);
  path.ray = spawnRay(vertex.point, next.wi, F(kInfinity));
  path.from = vertex.point;
  path.fromDensity = competingDensity(plan_.strategy, vertex.lightSampled, next.pdf);
  return {going, next.pdf};
}

}  // namespace steradian
