#pragma once
/// Reflection and refraction at a smooth interface between two dielectrics, for unpolarised light.
///
/// `eta` is the refractive index of the far side over that of the near side (where the cosine is measured).
#include "steradian/core/math/vec.h"

namespace STERADIAN_API steradian {

/// Cosine of the refracted direction, measured on the far side; 0 at total internal reflection (Snell).
template <class F>
F refractedCosine(F cosine, F eta) {
  return safeSqrt(F(1.0f) - maximum(F(1.0f) - cosine * cosine, F(0.0f)) / (eta * eta));
}

/// Reflected fraction of the power that arrives under `cosine` in [0, 1]; 1 at total internal reflection (Fresnel).
template <class F>
F fresnelDielectric(F cosine, F eta) {
  const F transmitted = refractedCosine(cosine, eta);
  const F parallel = (eta * cosine - transmitted) / (eta * cosine + transmitted);
  const F perpendicular = (cosine - eta * transmitted) / (cosine + eta * transmitted);
  const F reflectance = F(0.5f) * (parallel * parallel + perpendicular * perpendicular);
  return select(transmitted > F(0.0f), reflectance, F(1.0f));
}

/// Schlick's polynomial with the cosine of the incident side whichever medium is denser, as "In One Weekend" (11.4)
/// has it; 1 at total internal reflection. Schlick (1994) means the cosine on the thinner side: inside glass this one
/// reflects too little below the critical angle.
template <class F>
F fresnelSchlick(F cosine, F eta) {
  const F atNormal = sqr((F(1.0f) - eta) / (F(1.0f) + eta));
  const F c = F(1.0f) - cosine;
  const F reflectance = atNormal + (F(1.0f) - atNormal) * (sqr(c * c) * c);
  return select(refractedCosine(cosine, eta) > F(0.0f), reflectance, F(1.0f));
}

/// Fraction of diffuse light (radiance equal in all directions) that enters a medium of relative index `eta`:
/// the integral of (1 - Fresnel) 2 c dc over the cosine c, to 1e-6. From the inside out it is
/// diffuseTransmittance(1/eta) == diffuseTransmittance(eta) / eta^2, by reciprocity.
double diffuseTransmittance(double eta);

}  // namespace steradian
