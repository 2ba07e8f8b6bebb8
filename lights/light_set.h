#pragma once
/// All lights of a scene: chooses one by power, samples it, and gives the emission that rays find by hitting one.
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "steradian/core/math/bounds.h"
#include "steradian/lights/area_lights.h"
#include "steradian/lights/dirac_lights.h"
#include "steradian/lights/light_selection.h"
#include "steradian/lights/skies.h"

namespace STERADIAN_API steradian {

/// Which lights sample() may choose. Point, spot and distant lights it always may: no ray can hit them.
struct LightSetSettings {
  bool sampleAreas = true;  ///< area lights; false for the strategies that sample them otherwise (`bsdf`, `mixture`)
  /// Constant and gradient skies. They are smooth, so BSDF samples find them about as well, and light samples are
  /// better spent on the other lights. The strategy `light` needs true.
  bool sampleSkies = false;
  /// Environment maps, which may contain a sun.
  bool sampleImageSkies = true;
};

/// A light as reports name it: an emitting shape with all its primitives and instances, or another light.
struct LightInfo {
  std::string kind;          ///< "quad", "sphere", ..., "point", "spot", "distant", "sky"
  std::string name;          ///< may be empty; that of the sky is always
  std::size_t count = 1;     ///< of primitives
  Rgb power;                 ///< W per channel; of distant lights and skies what enters the scene's bounding sphere
  float probability = 0.0f;  ///< of being chosen by sample()
};

/// sample() chooses a light with a probability in proportion to the luminance of its power, the same for all points. A
/// light without power is never chosen. All skies together are one light. A light that sample() never chooses has pdf 0
/// in emission(), so that the MIS weight of the other techniques is 1.
class LightSet {
 public:
  /// The description must be valid. `sceneBounds` measures the power of distant lights and skies.
  LightSet(const SceneDescription& scene, const Bounds3& sceneBounds, LightSetSettings settings = {});
  /// The lights of `lights`, sampled by other settings. Both share the lights, whichever lives longer; only the table
  /// to choose from is made, and that of an image sky that was not sampled before.
  LightSet(const LightSet& lights, LightSetSettings settings);

  /// Chooses a light and a direction to it. pdf 0 means no sample, as in lanes that are not active. Lanes may choose
  /// different lights.
  template <class F>
  LightSample<F> sample(const ScatterPoint<F>& from, const LightRandom<F>& random,
                        MaskOf<F> active = MaskOf<F>(true)) const;

  /// The emission that `ray` from `from` finds at its hit, or of the skies if hit.valid is false; with the pdf with
  /// which sample(from) would have chosen this light and this direction. Where lights overlap, each counts for itself.
  Emission<float> emission(const ScatterPoint<float>& from, const Ray<float>& ray,
                           const SurfacePoint<float>& hit) const;

  /// The same for a ray that leaves the scene along `direction`.
  template <class F>
  Emission<F> skyEmission(const ScatterPoint<F>& from, const Vec3<F>& direction) const;

  /// The radiance alone, where the pdf does not matter: for camera rays and after Dirac bounces.
  Rgb radiance(const Ray<float>& ray, const SurfacePoint<float>& hit) const;

  /// sample() never gives a sample. emission() may be positive all the same.
  bool empty() const { return selection_.empty(); }
  /// Number of lights: primitives and their instances one by one, the skies as one.
  std::size_t size() const { return skyIndex() + (hasSky() ? 1u : 0u); }
  /// Whether there is a sky.
  bool hasSky() const { return !skies_.empty(); }
  const AreaLights& areas() const { return lights_->areas; }
  const std::vector<LightInfo>& info() const { return info_; }

 private:
  using DiracLight = std::variant<PointLight, PreparedSpot, DistantLight>;

  /// What does not depend on the settings: all lights but the skies.
  struct Lights {
    explicit Lights(const SceneDescription& scene, float sceneRadius);
    void add(const DiracLight& light, LightInfo of);

    AreaLights areas;
    std::vector<DiracLight> diracs;
    float sceneRadius;
    // Of both kinds, in this order:
    std::vector<float> power;           ///< luminance
    std::vector<std::uint32_t> infoOf;  ///< index in info
    std::vector<LightInfo> info;        ///< probabilities are still 0
  };
  LightSet(std::shared_ptr<const Lights> lights, Skies skies, LightSetSettings settings);

  std::size_t skyIndex() const { return lights_->areas.size() + lights_->diracs.size(); }
  /// The light `index`, as if it were the only one.
  template <class F>
  LightSample<F> sampleOne(std::size_t index, const ScatterPoint<F>& from, Vec2<F> u) const;

  std::shared_ptr<const Lights> lights_;
  Skies skies_;
  LightSelection selection_{{}};  ///< area lights, Dirac lights, skies
  std::vector<LightInfo> info_;
};

template <class F>
Emission<F> LightSet::skyEmission(const ScatterPoint<F>& from, const Vec3<F>& direction) const {
  if (!hasSky()) return {};
  const float probability = selection_.probability(skyIndex());
  const F pdf = probability > 0.0f ? F(probability) * skies_.pdf(from.geometricNormal, direction) : F(0.0f);
  return {skies_.radiance(direction), pdf};
}

template <class F>
LightSample<F> LightSet::sampleOne(std::size_t index, const ScatterPoint<F>& from, Vec2<F> u) const {
  const AreaLights& areas = lights_->areas;
  if (index < areas.size()) return areas[index].sample(from, u);
  if (index < skyIndex()) {
    return std::visit([&](const auto& light) { return sampleLight(light, from.position); },
                      lights_->diracs[index - areas.size()]);
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
  // Each chosen light once, for all lanes that chose it.
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
