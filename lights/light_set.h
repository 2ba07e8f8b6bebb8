#pragma once
/// All lights of a scene: chooses one by power, samples it, and tells what a ray that hits one finds.
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "steradian/core/math/bounds.h"
#include "steradian/lights/area_lights.h"
#include "steradian/lights/dirac_lights.h"
#include "steradian/lights/light_selection.h"
#include "steradian/lights/skies.h"

namespace STERADIAN_API steradian {

/// What sample() may choose from. Point, spot and distant lights always: nothing else finds them.
struct LightSetSettings {
  bool sampleAreas = true;  ///< false for the strategies that find them otherwise (`bsdf`, `mixture`)
  /// Constant and gradient skies are smooth: scattering finds them about as well, and without them the samples go to
  /// the other lights. `light` needs true.
  bool sampleSkies = false;
  /// Skies that are pictures may have a sun in them.
  bool sampleImageSkies = true;
};

/// For people: an emitting shape with all its primitives and instances, or another light.
struct LightInfo {
  std::string kind;          ///< "quad", "sphere", ..., "point", "spot", "distant", "sky"
  std::string name;          ///< may be empty; that of the sky is always
  std::size_t count = 1;     ///< of primitives
  Rgb power;                 ///< W per channel; of distant lights and skies what enters the scene's bounding sphere
  float probability = 0.0f;  ///< of being chosen by sample()
};

/// Selection: in proportion to the luminance of the power, whatever the place. A light without power is never chosen.
/// All skies together are one light. What sample() does not choose has pdf 0 in emission(), so that MIS weights of the
/// other techniques are 1.
class LightSet {
 public:
  /// The description must be valid. `sceneBounds` measures the power of distant lights and skies.
  LightSet(const SceneDescription& scene, const Bounds3& sceneBounds, LightSetSettings settings = {});

  /// One light, one direction. pdf 0: no sample. Lanes may choose different lights; those that are not active have no
  /// sample.
  template <class F>
  LightSample<F> sample(const ScatterPoint<F>& from, const LightRandom<F>& random,
                        MaskOf<F> active = MaskOf<F>(true)) const;

  /// What `ray`, which left `from`, finds: the emission of the surface it hit, or of the skies where hit.valid is
  /// false; with the density with which sample(from) would have chosen ray.direction through that light. Where lights
  /// overlap, each is a light of its own.
  Emission<float> emission(const ScatterPoint<float>& from, const Ray<float>& ray,
                           const SurfacePoint<float>& hit) const;

  /// What a ray finds that leaves the scene along `direction`, likewise.
  template <class F>
  Emission<F> skyEmission(const ScatterPoint<F>& from, const Vec3<F>& direction) const;

  /// The radiance alone, where the density does not matter (after the camera, after Dirac bounces).
  Rgb radiance(const Ray<float>& ray, const SurfacePoint<float>& hit) const;

  /// sample() never makes a sample. emission() may find light all the same.
  bool empty() const { return selection_.empty(); }
  /// Number of lights: primitives and their instances one by one, the skies as one.
  std::size_t size() const { return areas_.size() + diracs_.size() + (hasSky() ? 1u : 0u); }
  /// Rays that leave the scene find a sky.
  bool hasSky() const { return !skies_.empty(); }
  const AreaLights& areas() const { return areas_; }
  const std::vector<LightInfo>& info() const { return info_; }

 private:
  using DiracLight = std::variant<PointLight, PreparedSpot, DistantLight>;

  /// One light's entry in info_ and its weight in the selection.
  struct Weighed {
    std::size_t entry;
    float weight;
  };
  /// The light `index`, as if it were the only one.
  template <class F>
  LightSample<F> sampleOne(std::size_t index, const ScatterPoint<F>& from, Vec2<F> u) const;
  void listAreas(const SceneDescription& scene, bool sampled, std::vector<Weighed>& weighed);
  void listOthers(const SceneDescription& scene, float sceneRadius, std::vector<Weighed>& weighed);

  AreaLights areas_;
  std::vector<DiracLight> diracs_;
  Skies skies_;
  LightSelection selection_{{}};  ///< area lights, Dirac lights, skies
  std::vector<LightInfo> info_;
};

template <class F>
Emission<F> LightSet::skyEmission(const ScatterPoint<F>& from, const Vec3<F>& direction) const {
  if (!hasSky()) return {};
  const float probability = selection_.probability(areas_.size() + diracs_.size());
  const F pdf = probability > 0.0f ? F(probability) * skies_.pdf(from.geometricNormal, direction) : F(0.0f);
  return {skies_.radiance(direction), pdf};
}

template <class F>
LightSample<F> LightSet::sampleOne(std::size_t index, const ScatterPoint<F>& from, Vec2<F> u) const {
  if (index < areas_.size()) return areas_[index].sample(from, u);
  if (index < areas_.size() + diracs_.size()) {
    return std::visit([&](const auto& light) { return sampleLight(light, from.position); },
                      diracs_[index - areas_.size()]);
  }
  return skies_.sample(from.geometricNormal, u);
}

template <class F>
LightSample<F> LightSet::sample(const ScatterPoint<F>& from, const LightRandom<F>& random, MaskOf<F> active) const {
  LightSample<F> s;
  if (size() == 1 && !empty()) {
    s = sampleOne(0, from, random.position);
    s.pdf = select(active, s.pdf, F(0.0f));
    return s;
  }
  const auto [index, probability] = selection_.choose(random.select);
  MaskOf<F> left = active & (probability > F(0.0f));
  // Light by light of those that were chosen: mostly one, or as many as there are lanes.
  for (int i = 0; i < widthOf<F>; ++i) {
    if (!lane(left, i)) continue;
    const std::uint32_t chosen = lane(index, i);
    const MaskOf<F> mine = left & (index == UintOf<F>(chosen));
    const LightSample<F> one = sampleOne(chosen, from, random.position);
    s.weight = select(mine, one.weight, s.weight);
    s.wi = select(mine, one.wi, s.wi);
    s.distance = select(mine, one.distance, s.distance);
    s.pdf = select(mine, one.pdf, s.pdf);
    left = left & !mine;
  }
  s.weight *= F(1.0f) / select(probability > F(0.0f), probability, F(1.0f));
  s.pdf *= probability;
  return s;
}

}  // namespace steradian
