#pragma once
/// Absorbs all light: the usual material of an area light.
#include "steradian/core/transport/scattering.h"

namespace STERADIAN_API steradian {

template <class F>
struct Absorber {
  BsdfSample<F> sample(Vec3<F> wo, const BsdfRandom<F>&, Transport) const {
    return {grey(F(0.0f)), wo, F(0.0f), Lobe<F>(0u), F(1.0f)};
  }
  BsdfValue<F> eval(Vec3<F>, Vec3<F>, Transport) const { return {grey(F(0.0f)), F(0.0f)}; }
  F diracProbability(Vec3<F>) const { return F(0.0f); }
  Spectrum<F> albedo(Vec3<F>) const { return grey(F(0.0f)); }
};

}  // namespace steradian
