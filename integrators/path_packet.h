#pragma once
/// Several paths at once: the loop of path_loop.h with a path in each lane. A lane whose path has ended takes the next
/// sample, so that all lanes have work until samples run out.
///
/// Each step computes, lane by lane, what tracePath computes in one turn of its loop, with the same functions in the
/// same order: pictures are the same to the bit. What differs between lanes (materials, lights, kinds of shapes) is
/// done one after the other for those lanes that need it.
#include <array>
#include <bit>
#include <optional>
#include <span>

#include "steradian/integrators/camera_samples.h"
#include "steradian/integrators/path_loop.h"
#include "steradian/integrators/wide_flight.h"
#include "steradian/integrators/wide_scene.h"

namespace steradian {

template <class F>
class PathPacket {
 public:
  static constexpr int width = widthOf<F>;

  PathPacket(const WideScene& scene, const PathPlan& plan, const RenderJob& job, PathCounts& counts)
      : scene_(scene),
        plan_(plan),
        samplerSettings_(job.samplerSettings),
        counts_(counts),
        flight_(scene),
        hasVolumes_(flight_.needed()),
        byLane_(plan.scatterPdf != ScatterPdf::Bsdf) {}

  /// Traces the path of every sample; results[number] is its sample.
  void run(CameraSamples<F>& samples, std::span<PixelSample> results) {
    for (int i = 0; i < width; ++i) start(i, samples, results);
    rebuildSampler();
    while (any(active_)) step(samples, results);
  }

 private:
  using Mask = MaskOf<F>;
  using Uint = UintOf<F>;

  /// What the paths meet.
  struct Vertex {
    ScatterPoint<F> point;
    Vec3<F> wo;
    ShadingFrame<F> frame;
    MaterialTable::Parameters<F> material;
    F diracProbability{0.0f};
    Mask lightSampled{true};
    // Where there are volumes:
    const SurfacePoint<F>* surface = nullptr;
    Mask inMedium{false};
    F anisotropy{0.0f};
  };
  /// A model on a surface.
  template <class Model>
  struct Shading {
    const ShadingFrame<F>& frame;
    const Model& model;

    BsdfValue<F> eval(Vec3<F> wo, Vec3<F> wi, Transport t) const { return frame.eval(model, wo, wi, t); }
    BsdfSample<F> sample(Vec3<F> wo, const BsdfRandom<F>& random, Transport t) const {
      return frame.sample(model, wo, random, t);
    }
  };
  /// Calls visit(scatterer, mask) for every kind of Shading and for Phase, if some active lane has it.
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

  void start(int i, CameraSamples<F>& samples, std::span<PixelSample> results);
  void rebuildSampler() { sampler_.emplace(samplerSettings_, pixel_, sample_); }
  void step(CameraSamples<F>& samples, std::span<PixelSample> results);
  /// The surfaces that the paths come to. (With a conditional operator the points would be copied.)
  SurfacePoint<F> fly() {
    if (!hasVolumes_) return scene_.intersect(ray_, active_);
    return flight_.fly(ray_, active_, sampler_->get2D(bounce_, Purpose::Phase), throughput_, radiance_);
  }
  void addEmission(const SurfacePoint<F>& surface, Mask arrived);
  Vertex vertexAt(const SurfacePoint<F>& surface, Mask hit, std::span<PixelSample> results);
  [[gnu::noinline]] void addMedia(Vertex& vertex, Mask hit, std::span<PixelSample> results);
  Spectrum<F> directLight(const Vertex& vertex, Mask going);
  Spectrum<F> directLight(const LightSet& lights, const Vertex& vertex, Mask lit);
  BsdfValue<F> eval(const Vertex& vertex, const Vec3<F>& wi, Mask lanes) const;
  BsdfSample<F> sample(const Vertex& vertex, const BsdfRandom<F>& random, Mask lanes) const;
  /// As in path_loop.h.
  F mixedDensity(const Vertex& vertex, const Vec3<F>& wi, F scattered, Mask lanes) const;
  BsdfSample<F> scatter(const Vertex& vertex, Mask going);
  [[gnu::noinline]] BsdfSample<F> scatterMixture(const Vertex& vertex, const BsdfRandom<F>& random, Mask going);
  /// Direct light and scattering by the functions of width 1, for the strategies that draw from other densities.
  BsdfSample<F> shadeByLane(const SurfacePoint<F>& surface, Mask going);

  template <class Visit>
  static void forEachLane(Mask mask, const Visit& visit) {
    for (std::uint32_t bits = laneBits(mask); bits != 0; bits &= bits - 1) visit(std::countr_zero(bits));
  }

  const WideScene& scene_;
  const PathPlan& plan_;
  const SamplerSettings samplerSettings_;
  PathCounts& counts_;
  WideFlight<F> flight_;
  bool hasVolumes_;
  bool byLane_;
  static constexpr std::uint32_t kDielectric = indexOfModel<Dielectric<float>>();

  // The state of each path, as in tracePath.
  Mask active_{false};
  Ray<F> ray_;
  ScatterPoint<F> from_;
  Spectrum<F> throughput_, radiance_;
  F fromDensity_{0.0f}, refraction_{1.0f}, weight_{0.0f};
  Uint bounce_{0u}, pixel_{0u}, sample_{0u};
  std::array<std::uint32_t, static_cast<std::size_t>(width)> number_{};
  std::optional<Sampler<F>> sampler_;
};

/// Gives lane i the next sample, or nothing to do.
template <class F>
void PathPacket<F>::start(int i, CameraSamples<F>& samples, std::span<PixelSample> results) {
  setLane(active_, i, !samples.empty());
  if (samples.empty()) return;
  const auto next = samples.take();
  setLane(ray_, i, next.ray);
  if (hasVolumes_) flight_.start(i, next.ray);
  setLane(from_.position, i, next.ray.origin);
  setLane(from_.positionError, i, Vec3f{});
  setLane(from_.geometricNormal, i, Vec3f{});
  setLane(from_.time, i, next.ray.time);
  setLane(throughput_, i, grey(1.0f));
  setLane(radiance_, i, Rgb{});
  setLane(fromDensity_, i, kDirac);
  setLane(refraction_, i, 1.0f);
  setLane(weight_, i, next.weight);
  setLane(bounce_, i, 0u);
  setLane(pixel_, i, next.pixel);
  setLane(sample_, i, next.sample);
  number_[static_cast<std::size_t>(i)] = next.number;
  results[next.number] = kMiss;
}

template <class F>
void PathPacket<F>::addEmission(const SurfacePoint<F>& surface, Mask arrived) {
  const float lightSamples = static_cast<float>(plan_.lightSamples);
  const Mask finds = scene_.findsLight(surface, arrived), sky = finds & !surface.valid;
  if (any(sky)) {
    const Emission<F> emission = plan_.lights->skyEmission(from_, ray_.direction);
    const F weight = select(emission.pdf > F(0.0f), misWeight(fromDensity_, F(lightSamples) * emission.pdf), F(1.0f));
    radiance_ = select(sky, radiance_ + throughput_ * emission.radiance * weight, radiance_);
  }
  // Few lanes at a time: once per path at most, but for lights that one sees through glass.
  forEachLane(finds & surface.valid, [&](int i) {
    const Emission<float> emission = plan_.lights->emission(lane(from_, i), lane(ray_, i), lane(surface, i));
    const float weight = emission.pdf > 0.0f ? misWeight(lane(fromDensity_, i), lightSamples * emission.pdf) : 1.0f;
    setLane(radiance_, i, lane(radiance_, i) + lane(throughput_, i) * emission.radiance * weight);
  });
}

template <class F>
typename PathPacket<F>::Vertex PathPacket<F>::vertexAt(const SurfacePoint<F>& surface, Mask hit,
                                                       std::span<PixelSample> results) {
  const Vec3<F> wo = -ray_.direction;
  const Vec3<F> shadingNormal = usableShadingNormal(surface.geometricNormal, surface.shadingNormal, wo);
  Vertex vertex{scatterPoint(surface, ray_.time),
                wo,
                {surface.geometricNormal, shadingNormal},
                scene_.materials().parameters(surface, hit & surface.valid),
                F(0.0f),
                Mask(true),
                &surface};
  if (hasVolumes_) {
    addMedia(vertex, hit, results);
    hit = hit & !vertex.inMedium;
  }
  const Mask first = hit & (bounce_ == Uint(0u));
  const Vec3<F> localWo = vertex.frame.toLocal(wo);
  Spectrum<F> albedo;
  scene_.materials().forEachModel(vertex.material, hit, [&](const auto& model, Mask mine) {
    vertex.diracProbability = select(mine, model.diracProbability(localWo), vertex.diracProbability);
    if (plan_.strategy == Strategy::Light) {
      vertex.lightSampled = select(mine, Mask(samplesLights(model, localWo)), vertex.lightSampled);
    }
    albedo = select(mine, model.albedo(localWo), albedo);
  });
  if (any(first)) {
    const Vec3<F> normal = faceForward(shadingNormal, wo);
    forEachLane(first, [&](int i) {
      PixelSample& result = results[number_[static_cast<std::size_t>(i)]];
      result.alpha = 1.0f;
      result.albedo = lane(albedo, i);
      result.normal = lane(normal, i);
      result.depth = lane(surface.distance, i);
    });
  }
  return vertex;
}

/// What media make of the vertices: places where they scatter, and the index around dielectrics.
template <class F>
void PathPacket<F>::addMedia(Vertex& vertex, Mask hit, std::span<PixelSample> results) {
  const Mask inMedium = flight_.inMedium();
  vertex.inMedium = inMedium;
  F& eta = vertex.material.eta;
  eta = select(vertex.material.model == Uint(kDielectric), eta / flight_.outsideEta(), eta);
  vertex.point.position = select(inMedium, flight_.position(), vertex.point.position);
  vertex.point.positionError = select(inMedium, Vec3<F>{}, vertex.point.positionError);
  vertex.point.geometricNormal = select(inMedium, Vec3<F>{}, vertex.point.geometricNormal);
  vertex.anisotropy = flight_.medium().anisotropy;
  forEachLane(hit & inMedium & (bounce_ == Uint(0u)), [&](int i) {
    PixelSample& result = results[number_[static_cast<std::size_t>(i)]];
    setFirstHit(result, lane(flight_.medium(), i), lane(flight_.distance(), i));
  });
}

template <class F>
Spectrum<F> PathPacket<F>::directLight(const Vertex& vertex, Mask going) {
  const Mask lit = going & (vertex.diracProbability < F(1.0f));
  if (plan_.strategy != Strategy::Light) return directLight(*plan_.lights, vertex, lit);
  const Spectrum<F> all = directLight(*plan_.lights, vertex, lit & vertex.lightSampled);
  return all + directLight(*plan_.diracLights, vertex, lit & !vertex.lightSampled);
}

template <class F>
Spectrum<F> PathPacket<F>::directLight(const LightSet& lights, const Vertex& vertex, Mask lit) {
  Spectrum<F> sum;
  if (lights.empty() || !any(lit)) return sum;
  const F count(static_cast<float>(plan_.lightSamples));
  for (std::uint32_t k = 0; k < plan_.lightSamples; ++k) {
    const Uint own = bounce_ + Uint(k * (plan_.maxDepth + 1));
    const F choice = lights.size() > 1 ? sampler_->get1D(own, Purpose::LightSelect) : F(0.0f);
    const LightSample<F> light =
        lights.sample(vertex.point, LightRandom<F>{choice, sampler_->get2D(own, Purpose::LightPosition)}, lit);
    Mask sampled = lit & (light.pdf > F(0.0f));
    const BsdfValue<F> f = eval(vertex, light.wi, sampled);
    sampled = sampled & !isBlack(f.value);
    if (!any(sampled)) continue;
    counts_.shadowRays += static_cast<std::uint64_t>(std::popcount(laneBits(sampled)));
    const Ray<F> shadow = spawnRay(vertex.point, light.wi, light.distance);
    const F other = plan_.strategy == Strategy::Mis ? mixedDensity(vertex, light.wi, f.pdf, sampled) : F(0.0f);
    const F weight = misWeight(count * light.pdf, other);
    if (hasVolumes_) {
      const Spectrum<F> visible = flight_.transmittance(*vertex.surface, vertex.wo, shadow, sampled);
      sum += select(sampled & !isBlack(visible), f.value * light.weight * visible * weight, Spectrum<F>{});
    } else {
      const Mask visible = sampled & !scene_.occluded(shadow, sampled);
      sum += select(visible, f.value * light.weight * weight, Spectrum<F>{});
    }
  }
  return sum / count;
}

template <class F>
BsdfValue<F> PathPacket<F>::eval(const Vertex& vertex, const Vec3<F>& wi, Mask lanes) const {
  BsdfValue<F> f;
  forEachScatterer(vertex, lanes, [&](const auto& scatterer, Mask mine) {
    const BsdfValue<F> v = scatterer.eval(vertex.wo, wi, Transport::Radiance);
    f.value = select(mine, v.value, f.value);
    f.pdf = select(mine, v.pdf, f.pdf);
  });
  return f;
}

template <class F>
BsdfSample<F> PathPacket<F>::sample(const Vertex& vertex, const BsdfRandom<F>& random, Mask lanes) const {
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
F PathPacket<F>::mixedDensity(const Vertex& vertex, const Vec3<F>& wi, F scattered, Mask lanes) const {
  if (!(plan_.targetWeight > 0.0f)) return scattered;
  const F targetPdf = (F(1.0f) - vertex.diracProbability) * plan_.targets->pdfDirection(vertex.point, wi, lanes);
  return F(plan_.targetWeight) * targetPdf + F(1.0f - plan_.targetWeight) * scattered;
}

template <class F>
BsdfSample<F> PathPacket<F>::scatter(const Vertex& vertex, Mask going) {
  const Mask choosing = going & (vertex.diracProbability > F(0.0f));
  F lobe(0.0f);
  if (any(choosing)) lobe = select(choosing, sampler_->get1D(bounce_, Purpose::BsdfLobe), lobe);
  const BsdfRandom<F> random{lobe, sampler_->get2D(bounce_, Purpose::BsdfDirection)};
  if (plan_.targetWeight > 0.0f) return scatterMixture(vertex, random, going);
  return sample(vertex, random, going);
}

template <class F>
BsdfSample<F> PathPacket<F>::scatterMixture(const Vertex& vertex, const BsdfRandom<F>& random, Mask going) {
  const Mask mixed = going & !(random.lobe < vertex.diracProbability);
  const MixtureChoice<F> choice(plan_.targetWeight, random.direction);
  const Mask aimed = mixed & choice.aimed;
  const BsdfSample<F> scattered = sample(vertex, {random.lobe, choice.direction}, going & !aimed);
  DirectionSample<F> target;
  if (any(aimed)) {
    const F select = plan_.targets->size() > 1 ? sampler_->get1D(bounce_, Purpose::Mixture) : F(0.0f);
    const LightRandom<F> targetRandom{select, choice.direction};
    target = plan_.targets->sampleDirection(vertex.point, targetRandom, aimed);
  }
  const Vec3<F> wi = select(aimed, target.wi, scattered.wi);
  const Mask found = mixed & (select(aimed, target.pdf, scattered.pdf) > F(0.0f));
  const BsdfValue<F> f = eval(vertex, wi, found);
  const Mask lit = found & !isBlack(f.value);
  const F pdf = any(lit) ? select(lit, mixedDensity(vertex, wi, f.pdf, lit), F(0.0f)) : F(0.0f);
  return {select(mixed, f.value / pdf, scattered.weight), wi, select(mixed, pdf, scattered.pdf), Lobe<F>(kLobeDiffuse),
          select(mixed, F(1.0f), scattered.eta)};
}

template <class F>
BsdfSample<F> PathPacket<F>::shadeByLane(const SurfacePoint<F>& surface, Mask going) {
  BsdfSample<F> samples;
  SceneQueries queries(scene_.scene(), counts_);
  forEachLane(going, [&](int i) {
    const SurfacePoint<float> point = lane(surface, i);
    const Vec3f wo = -lane(ray_.direction, i);
    const float time = lane(ray_.time, i);
    const Sampler<float> sampler(samplerSettings_, lane(pixel_, i), lane(sample_, i));
    const std::uint32_t bounce = lane(bounce_, i);
    const auto shade = [&](const auto& vertex) {
      const Rgb light = steradian::directLight(plan_, queries, vertex, sampler, bounce);
      setLane(radiance_, i, lane(radiance_, i) + lane(throughput_, i) * light);
      const BsdfSample<float> next = scatteredRay(plan_, queries, vertex, sampler, bounce);
      setLane(samples.weight, i, next.weight);
      setLane(samples.wi, i, next.wi);
      setLane(samples.pdf, i, next.pdf);
      setLane(samples.eta, i, next.eta);
    };
    if (lane(flight_.inMedium(), i)) {
      const Phase<float> phase{lane(flight_.medium().anisotropy, i)};
      shade(vertexOf(lane(flight_.position(), i), phase, wo, time, flight_.bodies(i)));
    } else {
      const Bsdf bsdf = scene_.scene().materials().bsdf(point, wo, lane(flight_.outsideEta(), i));
      shade(vertexOf(plan_, point, bsdf, wo, time, flight_.bodies(i)));
    }
  });
  return samples;
}

template <class F>
void PathPacket<F>::step(CameraSamples<F>& samples, std::span<PixelSample> results) {
  const SurfacePoint<F> surface = fly();
  Mask hit = active_ & surface.valid, arrived = active_;
  if (hasVolumes_) {
    arrived = active_ & !flight_.inMedium();
    hit = (hit | (active_ & flight_.inMedium())) & !isBlack(throughput_);
  }
  addEmission(surface, arrived);
  const Vertex vertex = vertexAt(surface, hit, results);
  Mask going = hit & (bounce_ != Uint(plan_.maxDepth));

  BsdfSample<F> next;
  if (byLane_) {
    next = shadeByLane(surface, going);
  } else {
    const Spectrum<F> light = throughput_ * directLight(vertex, going);
    radiance_ = select(going, radiance_ + light, radiance_);
    next = scatter(vertex, going);
  }
  going = going & (next.pdf > F(0.0f));
  throughput_ = select(going, throughput_ * next.weight, throughput_);
  refraction_ = select(going, refraction_ * sqr(next.eta), refraction_);
  const Mask atStake = going & !(bounce_ < Uint(plan_.rouletteStart));
  if (any(atStake)) {
    const F survival = survivalProbability(plan_.rouletteStrength, throughput_, refraction_);
    going = going & ((!atStake) | (sampler_->get1D(bounce_, Purpose::Roulette) < survival));
    throughput_ = select(atStake, throughput_ * (F(1.0f) / survival), throughput_);
  }

  if (hasVolumes_) flight_.scatter(surface, vertex.wo, next.wi, going);
  const Mask ended = active_ & !going;
  ray_ = spawnRay(vertex.point, next.wi, F(kInfinity));
  from_ = vertex.point;
  fromDensity_ = competingDensity(plan_.strategy, vertex.lightSampled, next.pdf);
  forEachLane(ended, [&](int i) {
    PixelSample& result = results[number_[static_cast<std::size_t>(i)]];
    result.radiance = lane(radiance_, i) * lane(weight_, i);
    result.alpha *= lane(weight_, i);
    counts_.countPath(lane(bounce_, i));
  });
  bounce_ = bounce_ + select(going, Uint(1u), Uint(0u));
  if (!any(ended)) return;
  forEachLane(ended, [&](int i) { start(i, samples, results); });
  rebuildSampler();
}

}  // namespace steradian
