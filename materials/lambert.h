#pragma once
/// Models share one form, in the local frame whose z axis is the shading normal, templated on F:
///
///     BsdfSample<F> sample(Vec3<F> wo, BsdfRandom<F>, Transport) const;
///     BsdfValue<F>  eval(Vec3<F> wo, Vec3<F> wi, Transport) const;  // the continuous part; pdf as sample() draws it
///     F             diracProbability(Vec3<F> wo) const;             // sample() is Dirac where random.lobe < this
///     Spectrum<F>   albedo(Vec3<F> wo) const;                       // reflected and transmitted fraction, for AOVs
///
/// Their members are their parameters: F or Spectrum<F>, the reflectance first (materials/model_parameters.h).
///
/// This one: an ideally diffuse surface, reflectance / pi, the same on both sides; light does not pass.
#include "steradian/core/transport/scattering.h"
#include "steradian/materials/local_frame.h"

namespace STERADIAN_API steradian {

template <class F>
struct Lambert {
  Spectrum<F> reflectance;  ///< 0..1

  BsdfSample<F> sample(Vec3<F> wo, const BsdfRandom<F>& random, Transport) const {
    const Vec3<F> wi = sampleCosineHemisphere(wo, random.direction);
    const F pdf = absolute(wi.z) * F(kInvPi);
    const MaskOf<F> valid = (wo.z != F(0.0f)) & (pdf > F(0.0f));
    return {reflectance, wi, select(valid, pdf, F(0.0f)),
            select(valid, Lobe<F>(kLobeReflection | kLobeDiffuse), Lobe<F>(0u)), F(1.0f)};
  }

  BsdfValue<F> eval(Vec3<F> wo, Vec3<F> wi, Transport) const {
    const F pdf = select(sameHemisphere(wo, wi), absolute(wi.z) * F(kInvPi), F(0.0f));
    return {reflectance * pdf, pdf};
  }

  F diracProbability(Vec3<F>) const { return F(0.0f); }
  Spectrum<F> albedo(Vec3<F>) const { return reflectance; }
};

}  // namespace steradian
