#pragma once
/// All skies of a scene as one light.
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "steradian/core/sampling/distribution.h"
#include "steradian/lights/environment_map.h"
#include "steradian/lights/sky.h"

namespace STERADIAN_API steradian {

/// All are infinitely far away, so their radiances add up. Sampling chooses one of the skies that are sampled, by
/// power, and a direction by its pdf; the pdf of that direction is the weighted sum over all of them.
class Skies {
 public:
  /// The skies of the scene, and which are sampled: constant and gradient ones, environment maps.
  Skies(const SceneDescription& scene, bool sampleSmooth, bool samplePictures);
  /// The same skies, others of which are sampled; pictures and their tables are shared.
  Skies(const Skies& skies, bool sampleSmooth, bool samplePictures);

  /// Whether there are none.
  bool empty() const { return parts_.empty(); }

  /// W sr^-1 m^-2, from a unit direction.
  template <class F>
  Spectrum<F> radiance(Vec3<F> direction) const;

  /// A direction, from a surface with this normal or (normal zero) a point in a medium; weight: radiance of all skies /
  /// pdf.
  template <class F>
  LightSample<F> sample(Vec3<F> normal, Vec2<F> u) const;
  /// The pdf of sample(), per sr.
  template <class F>
  F pdf(Vec3<F> normal, Vec3<F> wi) const;

  /// The power that enters a sphere of this radius, W per channel: of all skies, and of those that are sampled.
  Rgb power(float sceneRadius) const;
  Rgb sampledPower(float sceneRadius) const;

 private:
  struct Part {
    std::variant<Sky, EnvironmentMap> sky;
    bool sampled;
    float share = 0.0f;  ///< the probability of being chosen
  };
  /// Sets the shares of the parts, by their power.
  void setShares();

  template <class F>
  static Spectrum<F> radianceOf(const Part& part, Vec3<F> direction) {
    return std::visit([&](const auto& sky) { return sky.radiance(direction); }, part.sky);
  }
  template <class F>
  static F pdfOf(const Sky&, Vec3<F> normal, Vec3<F> wi) {
    return skyPdf(normal, wi);
  }
  template <class F>
  static F pdfOf(const EnvironmentMap& picture, Vec3<F>, Vec3<F> wi) {
    return picture.pdf(wi);
  }
  template <class F>
  static EnvironmentMap::Sample<F> sampleOf(const Sky& sky, Vec3<F> normal, Vec2<F> u) {
    const DirectionSample<F> d = sampleSky(normal, u);
    return {d, sky.radiance(d.wi)};
  }
  template <class F>
  static EnvironmentMap::Sample<F> sampleOf(const EnvironmentMap& picture, Vec3<F>, Vec2<F> u) {
    return picture.sample(u);
  }
  /// Samples a direction by the pdf of the part `chosen`.
  template <class F>
  LightSample<F> sampleFrom(std::size_t chosen, Vec3<F> normal, Vec2<F> u) const;

  std::vector<Part> parts_;
  /// The distribution of parts to sample, over [0, number of parts); none if at most one is sampled.
  std::optional<PiecewiseConstant1D> choice_;
};

template <class F>
Spectrum<F> Skies::radiance(Vec3<F> direction) const {
  Spectrum<F> sum;
  for (const Part& part : parts_) sum += radianceOf(part, direction);
  return sum;
}

template <class F>
F Skies::pdf(Vec3<F> normal, Vec3<F> wi) const {
  F sum(0.0f);
  for (const Part& part : parts_) {
    if (part.share == 0.0f) continue;
    sum = sum + F(part.share) * std::visit([&](const auto& sky) { return pdfOf(sky, normal, wi); }, part.sky);
  }
  return sum;
}

template <class F>
LightSample<F> Skies::sampleFrom(std::size_t chosen, Vec3<F> normal, Vec2<F> u) const {
  const Part& own = parts_[chosen];
  const auto drawn = std::visit([&](const auto& sky) { return sampleOf(sky, normal, u); }, own.sky);
  const Vec3<F> wi = drawn.direction.wi;
  Spectrum<F> radiance = drawn.radiance;
  F pdf = F(own.share) * drawn.direction.pdf;
  for (const Part& other : parts_) {
    if (&other == &own) continue;
    radiance += radianceOf(other, wi);
    if (other.share == 0.0f) continue;
    pdf = pdf + F(other.share) * std::visit([&](const auto& sky) { return pdfOf(sky, normal, wi); }, other.sky);
  }
  const MaskOf<F> valid = drawn.direction.pdf > F(0.0f);
  return {radiance * select(valid, F(1.0f) / pdf, F(0.0f)), wi, F(kInfinity), select(valid, pdf, F(0.0f))};
}

template <class F>
LightSample<F> Skies::sample(Vec3<F> normal, Vec2<F> u) const {
  if (!choice_) {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      if (parts_[i].share > 0.0f) return sampleFrom(i, normal, u);
    }
    return {};
  }
  const auto choice = choice_->sample(u.x);
  const F rest = clamp(choice.x - toFloat(toSigned(choice.bin)), 0.0f, kOneMinusEpsilon);
  LightSample<F> sample;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const MaskOf<F> mine = choice.bin == UintOf<F>(static_cast<std::uint32_t>(i));
    if (!any(mine)) continue;
    const LightSample<F> s = sampleFrom(i, normal, Vec2<F>{rest, u.y});
    sample.weight = select(mine, s.weight, sample.weight);
    sample.wi = select(mine, s.wi, sample.wi);
    sample.distance = select(mine, s.distance, sample.distance);
    sample.pdf = select(mine, s.pdf, sample.pdf);
  }
  return sample;
}

}  // namespace steradian
