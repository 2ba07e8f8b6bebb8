#pragma once
/// How a surface scatters at one point: a closed variant of the models, in world space, at width 1.
#include <type_traits>
#include <variant>

#include "steradian/core/frame.h"
#include "steradian/materials/absorber.h"
#include "steradian/materials/coated.h"
#include "steradian/materials/dielectric.h"
#include "steradian/materials/fuzzy_metal.h"
#include "steradian/materials/lambert.h"
#include "steradian/materials/mirror.h"

namespace steradian {

/// Directions are unit vectors in world space that leave the surface. Reflection and transmission are told apart by the
/// geometric normal: where the shading normal has it otherwise, the value is black, so that light does not leak through
/// surfaces whose normals are interpolated.
class Bsdf {
 public:
  using Model =
      std::variant<Absorber<float>, Lambert<float>, Mirror<float>, FuzzyMetal<float>, Dielectric<float>, Coated<float>>;

  /// Both normals are unit and outward. A model takes the shading normal for its z axis.
  Bsdf(const Model& model, Vec3f geometricNormal, Vec3f shadingNormal)
      : model_(model), frame_(Frame<float>::fromZ(shadingNormal)), geometricNormal_(geometricNormal) {}

  /// Draws wi. The sample is Dirac if random.lobe < diracProbability(wo), else continuous.
  BsdfSample<float> sample(Vec3f wo, const BsdfRandom<float>& random, Transport transport) const;

  /// The continuous part: f |cos|, and the density with which sample() draws wi, the probability of its not being Dirac
  /// included. For a direction wi of any other density q, value / q is the weight of a sample.
  BsdfValue<float> eval(Vec3f wo, Vec3f wi, Transport transport) const;

  /// Probability that sample() takes a Dirac lobe; 0 or 1 for all models but the coated one.
  float diracProbability(Vec3f wo) const;

  /// Whether light samples alone may estimate the continuous part, as the strategy `light` does. False where there is
  /// none, and for fuzzy metal, whose value is unbounded: there the variance would be infinite.
  bool samplesLights(Vec3f wo) const;

  /// The share of light from all around that is reflected or transmitted, for the albedo picture: exact but for fuzzy
  /// metal's absorption below the horizon.
  Rgb albedo(Vec3f wo) const;

  Vec3f shadingNormal() const { return frame_.z; }
  Vec3f geometricNormal() const { return geometricNormal_; }

 private:
  bool leaks(Vec3f wo, Vec3f wi, Vec3f localWo, Vec3f localWi) const;
  float adjointOfShading(Vec3f wo, Vec3f wi, Vec3f localWo, Vec3f localWi, Transport transport) const;

  Model model_;
  Frame<float> frame_;
  Vec3f geometricNormal_;
};

// In the header: the path loop calls these per bounce, and is compiled for the models it meets.

inline bool Bsdf::leaks(Vec3f wo, Vec3f wi, Vec3f localWo, Vec3f localWi) const {
  const bool reflectsLocally = localWo.z * localWi.z > 0.0f;
  const bool reflects = dot(wo, geometricNormal_) * dot(wi, geometricNormal_) > 0.0f;
  return reflectsLocally != reflects;
}

// Shading normals make every model non-symmetric (Veach 1997, equation 5.19): light arrives by wo here.
inline float Bsdf::adjointOfShading(Vec3f wo, Vec3f wi, Vec3f localWo, Vec3f localWi, Transport transport) const {
  if (transport == Transport::Radiance) return 1.0f;
  const float above = absolute(localWo.z) * absDot(wi, geometricNormal_);
  const float below = absDot(wo, geometricNormal_) * absolute(localWi.z);
  return below > 0.0f ? above / below : 0.0f;
}

inline BsdfSample<float> Bsdf::sample(Vec3f wo, const BsdfRandom<float>& random, Transport transport) const {
  const Vec3f localWo = frame_.toLocal(wo);
  BsdfSample<float> s = std::visit([&](const auto& model) { return model.sample(localWo, random, transport); }, model_);
  if (s.pdf == 0.0f) return s;
  const Vec3f localWi = s.wi;
  s.wi = normalize(frame_.toWorld(localWi));
  if (leaks(wo, s.wi, localWo, localWi)) {
    s.pdf = 0.0f;
    s.lobe = 0u;
    return s;
  }
  s.weight *= adjointOfShading(wo, s.wi, localWo, localWi, transport);
  return s;
}

inline BsdfValue<float> Bsdf::eval(Vec3f wo, Vec3f wi, Transport transport) const {
  const Vec3f localWo = frame_.toLocal(wo), localWi = frame_.toLocal(wi);
  if (leaks(wo, wi, localWo, localWi)) return {};
  BsdfValue<float> v = std::visit([&](const auto& model) { return model.eval(localWo, localWi, transport); }, model_);
  v.value *= adjointOfShading(wo, wi, localWo, localWi, transport);
  return v;
}

inline float Bsdf::diracProbability(Vec3f wo) const {
  const Vec3f localWo = frame_.toLocal(wo);
  return std::visit([&](const auto& model) { return model.diracProbability(localWo); }, model_);
}

inline bool Bsdf::samplesLights(Vec3f wo) const {
  return std::visit(
      [&]<class M>(const M& model) {
        if constexpr (std::is_same_v<M, Absorber<float>>)
          return false;
        else if constexpr (std::is_same_v<M, FuzzyMetal<float>>)
          return model.fuzz == 1.0f;
        else
          return model.diracProbability(frame_.toLocal(wo)) < 1.0f;
      },
      model_);
}

}  // namespace steradian
