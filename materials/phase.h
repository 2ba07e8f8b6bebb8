#pragma once
/// How a medium scatters at one point, in world space: the phase function of Henyey & Greenstein.
#include "steradian/core/math/frame.h"
#include "steradian/core/sampling/henyey_greenstein.h"
#include "steradian/core/transport/scattering.h"

namespace STERADIAN_API steradian {

/// It has the members of a BSDF model, so that estimators treat both alike. There is no cosine: the value is the pdf.
/// Absorption is not part of it.
template <class F>
struct Phase {
  F anisotropy;  ///< mean cosine between -wo and wi, in (-1, 1)

  BsdfSample<F> sample(Vec3<F> wo, const BsdfRandom<F>& random, Transport) const {
    const Vec3<F> local = function().sample(random.direction);
    const Vec3<F> wi = normalize(Frame<F>::fromZ(-wo).toWorld(local));
    return {grey(F(1.0f)), wi, function().pdf(local), Lobe<F>(kLobeTransmission | kLobeDiffuse), F(1.0f)};
  }
  BsdfValue<F> eval(Vec3<F> wo, Vec3<F> wi, Transport) const {
    const F pdf = function().pdf(Frame<F>::fromZ(-wo).toLocal(wi));
    return {grey(pdf), pdf};
  }
  F diracProbability(Vec3<F>) const { return F(0.0f); }

 private:
  HenyeyGreenstein<F> function() const { return {anisotropy}; }
};

}  // namespace steradian
