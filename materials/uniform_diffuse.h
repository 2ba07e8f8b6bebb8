#pragma once
/// Scatters uniformly into the hemisphere of wo, with the pdf 1 / 2 pi: the "hemisphere" material of "The Rest of Your
/// Life" (6.3), which is "In One Weekend" (9.1) as well. Darker than Lambert to the front and brighter at grazing
/// angles.
///
/// The model is defined by what it does to a path from the camera: value = reflectance / 2 pi, without a cosine. So it
/// is not reciprocal; Transport::Importance uses its adjoint, which is value |cos wi| / |cos wo|.
#include "steradian/core/transport/scattering.h"
#include "steradian/materials/local_frame.h"

namespace STERADIAN_API steradian {

template <class F>
struct UniformDiffuse {
  Spectrum<F> reflectance;  ///< 0..1

  BsdfSample<F> sample(Vec3<F> wo, const BsdfRandom<F>& random, Transport transport) const {
    const Vec3<F> upper = UniformHemisphere<F>::sample(random.direction);
    const Vec3<F> wi{upper.x, upper.y, copySign(upper.z, wo.z)};
    const MaskOf<F> valid = sameHemisphere(wo, wi);
    return {reflectance * adjointFactor(wo, wi, transport), wi, select(valid, F(kInvTwoPi), F(0.0f)),
            select(valid, Lobe<F>(kLobeReflection | kLobeDiffuse), Lobe<F>(0u)), F(1.0f)};
  }

  BsdfValue<F> eval(Vec3<F> wo, Vec3<F> wi, Transport transport) const {
    const F pdf = select(sameHemisphere(wo, wi), F(kInvTwoPi), F(0.0f));
    return {reflectance * (pdf * adjointFactor(wo, wi, transport)), pdf};
  }

  F diracProbability(Vec3<F>) const { return F(0.0f); }
  Spectrum<F> albedo(Vec3<F>) const { return reflectance; }

 private:
  static F adjointFactor(Vec3<F> wo, Vec3<F> wi, Transport transport) {
    if (transport == Transport::Radiance) return F(1.0f);
    return absolute(wi.z) / maximum(absolute(wo.z), F(1e-12f));
  }
};

}  // namespace steradian
