#pragma once
/// A smooth dielectric coat over a Lambert base, in closed form: varnished wood. Both sides are coated.
///
/// The coat reflects the Fresnel term F(wo) as a mirror. The rest enters the coat and is scattered by the base
/// (reflectance a). The underside of the coat reflects the part R_i of it, the diffuse internal reflectance, back to
/// the base, again and again: a geometric series with the sum 1 / (1 - a R_i) (Saunderson 1942, J. Opt. Soc. Am. 32).
/// Refraction scales radiance by 1/eta^2:
///
///     f = (1 - F(wo)) (1 - F(wi)) a / (pi eta^2 (1 - a R_i)).
///
/// It is reciprocal, and white for a = 1: the integral of (1 - F) cos / pi is eta^2 (1 - R_i).
#include "steradian/core/transport/scattering.h"
#include "steradian/materials/fresnel.h"
#include "steradian/materials/local_frame.h"

namespace STERADIAN_API steradian {

template <class F>
struct Coated {
  Spectrum<F> reflectance;  ///< of the base, 0..1
  F eta;                    ///< refractive index of the coat over that outside
  F internalReflectance;    ///< R_i = 1 - diffuseTransmittance(1/eta)

  BsdfSample<F> sample(Vec3<F> wo, const BsdfRandom<F>& random, Transport transport) const {
    const F dirac = diracProbability(wo);
    const MaskOf<F> mirrors = random.lobe < dirac;
    const Vec3<F> wi = select(mirrors, mirrored(wo), sampleCosineHemisphere(wo, random.direction));
    const BsdfValue<F> base = eval(wo, wi, transport);
    const F pdf = select(mirrors, select(wo.z != F(0.0f), F(kDirac), F(0.0f)), base.pdf);
    const F coat = fresnel(wo) / maximum(dirac, F(1e-30f));
    const Spectrum<F> weight = select(mirrors, grey(coat), base.value * (F(1.0f) / maximum(base.pdf, F(1e-30f))));
    const Lobe<F> lobe =
        select(mirrors, Lobe<F>(kLobeReflection | kLobeDirac), Lobe<F>(kLobeReflection | kLobeDiffuse));
    return {weight, wi, pdf, select(pdf > F(0.0f), lobe, Lobe<F>(0u)), F(1.0f)};
  }

  BsdfValue<F> eval(Vec3<F> wo, Vec3<F> wi, Transport) const {
    const F cosine = select(sameHemisphere(wo, wi), absolute(wi.z) * F(kInvPi), F(0.0f));
    const F passes = (F(1.0f) - fresnel(wo)) * (F(1.0f) - fresnel(wi)) / (eta * eta);
    return {baseReflectance() * (passes * cosine), (F(1.0f) - diracProbability(wo)) * cosine};
  }

  /// The part of all reflected light that the coat reflects, so that samples of both lobes have about the same weight.
  F diracProbability(Vec3<F> wo) const {
    const F coat = fresnel(wo);
    const F base = (F(1.0f) - coat) * (F(1.0f) - internalReflectance) * maxChannel(baseReflectance());
    return coat / maximum(coat + base, F(1e-30f));
  }

  Spectrum<F> albedo(Vec3<F> wo) const {
    const F coat = fresnel(wo);
    return grey(coat) + baseReflectance() * ((F(1.0f) - coat) * (F(1.0f) - internalReflectance));
  }

 private:
  F fresnel(Vec3<F> w) const { return fresnelDielectric(minimum(absolute(w.z), F(1.0f)), eta); }
  /// Of the base with all internal reflections: a / (1 - a R_i).
  Spectrum<F> baseReflectance() const {
    const auto channel = [&](F a) { return a / (F(1.0f) - a * internalReflectance); };
    return {channel(reflectance.r), channel(reflectance.g), channel(reflectance.b)};
  }
};

}  // namespace steradian
