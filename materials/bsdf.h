#pragma once
/// How a surface scatters at one point: a closed variant of the models, in world space, at width 1.
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>

#include "steradian/materials/absorber.h"
#include "steradian/materials/coated.h"
#include "steradian/materials/dielectric.h"
#include "steradian/materials/fuzzy_metal.h"
#include "steradian/materials/lambert.h"
#include "steradian/materials/mirror.h"
#include "steradian/materials/shading_frame.h"
#include "steradian/materials/uniform_diffuse.h"

namespace STERADIAN_API steradian {

/// Whether light samples alone may estimate the continuous part of a model, as the strategy `light` does. False where
/// there is none, and for fuzzy metal, whose value is unbounded: there the variance would be infinite.
template <class F>
MaskOf<F> samplesLights(const Absorber<F>&, Vec3<F>) {
  return false;
}
template <class F>
MaskOf<F> samplesLights(const FuzzyMetal<F>& model, Vec3<F>) {
  return model.fuzz == F(1.0f);
}
template <class F, class Model>
MaskOf<F> samplesLights(const Model& model, Vec3<F> localWo) {
  return model.diracProbability(localWo) < F(1.0f);
}

/// Directions and sides as in ShadingFrame.
class Bsdf {
 public:
  using Model = std::variant<Absorber<float>, Lambert<float>, Mirror<float>, FuzzyMetal<float>, Dielectric<float>,
                             Coated<float>, UniformDiffuse<float>>;

  /// Both normals are unit and outward. A model takes the shading normal for its z axis.
  Bsdf(const Model& model, Vec3f geometricNormal, Vec3f shadingNormal)
      : model_(model), frame_(geometricNormal, shadingNormal) {}

  /// Draws wi. The sample is Dirac if random.lobe < diracProbability(wo), else continuous.
  BsdfSample<float> sample(Vec3f wo, const BsdfRandom<float>& random, Transport transport) const;

  /// The continuous part: f |cos|, and the density with which sample() draws wi, the probability of its not being Dirac
  /// included. For a direction wi of any other density q, value / q is the weight of a sample.
  BsdfValue<float> eval(Vec3f wo, Vec3f wi, Transport transport) const;

  /// Probability that sample() takes a Dirac lobe; 0 or 1 for all models but the coated one.
  float diracProbability(Vec3f wo) const;

  /// See samplesLights above.
  bool samplesLights(Vec3f wo) const;

  /// The share of light from all around that is reflected or transmitted, for the albedo picture: exact but for fuzzy
  /// metal's absorption below the horizon.
  Rgb albedo(Vec3f wo) const;

  Vec3f shadingNormal() const { return frame_.shadingNormal(); }
  Vec3f geometricNormal() const { return frame_.geometricNormal(); }

 private:
  Model model_;
  ShadingFrame<float> frame_;
};

/// The index of a model in Bsdf::Model.
template <class Model>
constexpr std::uint32_t indexOfModel() {
  return []<std::size_t... i>(std::index_sequence<i...>) {
    return static_cast<std::uint32_t>(
        ((std::is_same_v<Model, std::variant_alternative_t<i, Bsdf::Model>> ? i : 0) + ...));
  }
  (std::make_index_sequence<std::variant_size_v<Bsdf::Model>>{});
}

// In the header: the path loop calls these per bounce, and is compiled for the models it meets.

inline BsdfSample<float> Bsdf::sample(Vec3f wo, const BsdfRandom<float>& random, Transport transport) const {
  return std::visit([&](const auto& model) { return frame_.sample(model, wo, random, transport); }, model_);
}

inline BsdfValue<float> Bsdf::eval(Vec3f wo, Vec3f wi, Transport transport) const {
  return std::visit([&](const auto& model) { return frame_.eval(model, wo, wi, transport); }, model_);
}

inline float Bsdf::diracProbability(Vec3f wo) const {
  const Vec3f localWo = frame_.toLocal(wo);
  return std::visit([&](const auto& model) { return model.diracProbability(localWo); }, model_);
}

inline bool Bsdf::samplesLights(Vec3f wo) const {
  return std::visit([&](const auto& model) { return steradian::samplesLights(model, frame_.toLocal(wo)); }, model_);
}

}  // namespace steradian
