#pragma once
/// A perfect mirror on both sides: the books' metal without fuzz.
#include "steradian/core/transport/scattering.h"
#include "steradian/materials/local_frame.h"

namespace STERADIAN_API steradian {

template <class F>
struct Mirror {
  Spectrum<F> reflectance;  ///< 0..1

  BsdfSample<F> sample(Vec3<F> wo, const BsdfRandom<F>&, Transport) const {
    const MaskOf<F> valid = wo.z != F(0.0f);
    return {reflectance, mirrored(wo), select(valid, F(kDirac), F(0.0f)),
            select(valid, Lobe<F>(kLobeReflection | kLobeDirac), Lobe<F>(0u)), F(1.0f)};
  }

  BsdfValue<F> eval(Vec3<F>, Vec3<F>, Transport) const { return {grey(F(0.0f)), F(0.0f)}; }
  F diracProbability(Vec3<F>) const { return F(1.0f); }
  Spectrum<F> albedo(Vec3<F>) const { return reflectance; }
};

}  // namespace steradian
