#pragma once
/// Smooth interface between two dielectrics. Samples reflect with the probability of the Fresnel reflectance and
/// refract otherwise.
///
/// Radiance scales with the square of the refractive index of the medium, so Transport::Radiance divides by eta^2
/// (index on the side of wi over that on the side of wo) where it refracts. Between entering and leaving a body this
/// cancels; the books leave it out. Transport::Importance is not scaled (Veach 1997, 5.2).
#include "steradian/core/transport/scattering.h"
#include "steradian/materials/fresnel.h"
#include "steradian/materials/local_frame.h"

namespace STERADIAN_API steradian {

/// `schlick`: reflects by Schlick's approximation with the books' cosine (see fresnelSchlick); else by Fresnel's
/// formulas.
template <class F, bool schlick = false>
struct Dielectric {
  F eta;  ///< refractive index below the surface over that above, where the normal points to

  /// Makes an index that is relative to vacuum relative to that of the medium outside.
  void setOutsideEta(F outsideEta) { eta = eta / outsideEta; }

  BsdfSample<F> sample(Vec3<F> wo, const BsdfRandom<F>& random, Transport transport) const {
    const F side = copySign(F(1.0f), wo.z);
    const F cosine = minimum(absolute(wo.z), F(1.0f));
    const F ratio = select(wo.z > F(0.0f), eta, F(1.0f) / eta);
    const MaskOf<F> reflects = random.lobe < reflectionProbability(wo);
    const F inverse = F(1.0f) / ratio;
    const F transmitted = refractedCosine(cosine, ratio);
    // Snell: the tangential part shrinks with the index; renormalised, as rounding at grazing angles adds up.
    const Vec3<F> refracted =
        normalize(Vec3<F>{-wo.x * inverse, -wo.y * inverse, -side * maximum(transmitted, F(1e-20f))});
    const F scale = transport == Transport::Radiance ? inverse * inverse : F(1.0f);
    const MaskOf<F> valid = wo.z != F(0.0f);
    const Lobe<F> lobe =
        select(reflects, Lobe<F>(kLobeReflection | kLobeDirac), Lobe<F>(kLobeTransmission | kLobeDirac));
    return {grey(select(reflects, F(1.0f), scale)), select(reflects, mirrored(wo), refracted),
            select(valid, F(kDirac), F(0.0f)), select(valid, lobe, Lobe<F>(0u)), select(reflects, F(1.0f), ratio)};
  }

  BsdfValue<F> eval(Vec3<F>, Vec3<F>, Transport) const { return {grey(F(0.0f)), F(0.0f)}; }
  F diracProbability(Vec3<F>) const { return F(1.0f); }
  Spectrum<F> albedo(Vec3<F>) const { return grey(F(1.0f)); }

  /// Probability that sample() reflects.
  F reflectionProbability(Vec3<F> wo) const {
    const F cosine = minimum(absolute(wo.z), F(1.0f));
    const F ratio = select(wo.z > F(0.0f), eta, F(1.0f) / eta);
    if constexpr (schlick) return fresnelSchlick(cosine, ratio);
    return fresnelDielectric(cosine, ratio);
  }
};

template <class F>
using SchlickDielectric = Dielectric<F, true>;

}  // namespace steradian
