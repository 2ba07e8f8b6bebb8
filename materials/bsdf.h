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

/// The one list of models: for points one by one (F = float) or in lanes. What has to match it is derived from it, or a
/// static_assert or a switch over its alternatives does not compile.
template <class F>
using BsdfModels = std::variant<Absorber<F>, Lambert<F>, Mirror<F>, FuzzyMetal<F>, Dielectric<F>, SchlickDielectric<F>,
                                Coated<F>, UniformDiffuse<F>>;

/// Whether the strategy `light`, which samples lights only, may estimate the continuous part of a model. False for
/// models without a continuous part, and for fuzzy metal, whose value is unbounded: the variance would be infinite.
template <class F>
MaskOf<F> suitsLightSampling(const Absorber<F>&, Vec3<F>) {
  return false;
}
template <class F>
MaskOf<F> suitsLightSampling(const FuzzyMetal<F>& model, Vec3<F>) {
  return model.fuzz == F(1.0f);
}
template <class F, class Model>
MaskOf<F> suitsLightSampling(const Model& model, Vec3<F> localWo) {
  return model.diracProbability(localWo) < F(1.0f);
}

/// A model on a surface. Directions are as in ShadingFrame.
class Bsdf {
 public:
  using Model = BsdfModels<float>;

  /// Both normals are unit and outward. A model takes the shading normal for its z axis.
  Bsdf(const Model& model, Vec3f geometricNormal, Vec3f shadingNormal)
      : model_(model), frame_(geometricNormal, shadingNormal) {}

  /// Draws wi. The sample is Dirac if random.lobe < diracProbability(wo), else continuous.
  BsdfSample<float> sample(Vec3f wo, const BsdfRandom<float>& random, Transport transport) const;

  /// The continuous part: f |cos|, and the pdf of wi under sample(), which includes the probability that the sample is
  /// not Dirac. A direction wi that was drawn from another pdf q has the weight value / q.
  BsdfValue<float> eval(Vec3f wo, Vec3f wi, Transport transport) const;

  /// Probability that sample() chooses a Dirac lobe; 0 or 1 for all models but Coated.
  float diracProbability(Vec3f wo) const;

  /// See suitsLightSampling above.
  bool suitsLightSampling(Vec3f wo) const;

  /// The fraction of uniform illumination that is reflected or transmitted towards wo, for the albedo picture. Exact,
  /// except that what fuzzy metal absorbs below the horizon is not subtracted.
  Rgb albedo(Vec3f wo) const;

  Vec3f shadingNormal() const { return frame_.shadingNormal(); }
  Vec3f geometricNormal() const { return frame_.geometricNormal(); }

 private:
  Model model_;
  ShadingFrame<float> frame_;
};

/// The index of a model at width 1 in Bsdf::Model.
template <class Model>
constexpr std::uint32_t indexOfModel() {
  return []<std::size_t... i>(std::index_sequence<i...>) {
    static_assert((std::is_same_v<Model, std::variant_alternative_t<i, Bsdf::Model>> + ...) == 1, "not in the list");
    return static_cast<std::uint32_t>(
        ((std::is_same_v<Model, std::variant_alternative_t<i, Bsdf::Model>> ? i : 0) + ...));
  }
  (std::make_index_sequence<std::variant_size_v<Bsdf::Model>>{});
}

// In the header, to be inlined: the path loop calls these at every bounce.

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

inline bool Bsdf::suitsLightSampling(Vec3f wo) const {
  return std::visit([&](const auto& model) { return steradian::suitsLightSampling(model, frame_.toLocal(wo)); },
                    model_);
}

}  // namespace steradian
