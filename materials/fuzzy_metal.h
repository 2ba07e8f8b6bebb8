#pragma once
/// The books' fuzzy metal ("In One Weekend", 10.6): the mirror direction m plus a point of the sphere of radius f, the
/// fuzz, with uniform density. What falls below the horizon is absorbed.
///
/// Closed density. A direction w at the angle t < 90 degrees from m leaves the sphere about m at the distances
/// r = cos t +- q, q = sqrt(f^2 - sin^2 t), where sin t < f. It crosses the sphere there at an angle of cosine q / f to
/// the sphere's normal, so each of the two points has the density r^2 / (4 pi f^2) / (q / f) per steradian. Their sum
/// is
///
///     p(w) = (cos^2 t + q^2) / (2 pi f q) = (cos 2t + f^2) / (2 pi f sqrt(f^2 - sin^2 t)).
///
/// With f = 1 the nearer point is the surface point itself, and p is cos t / pi. The probability of a direction within
/// the angle t is 1 - q cos t / f.
///
/// The model is defined by what it does to a path from the camera: value = reflectance p above the horizon. It is not
/// reciprocal; Transport::Importance uses its adjoint, which is value |cos wi| / |cos wo|, since p is symmetric.
/// At the edge of the cone p is infinite (integrable): `light` must not rely on light samples alone (see
/// suitsLightSampling in bsdf.h).
#include "steradian/core/transport/scattering.h"
#include "steradian/materials/local_frame.h"

namespace STERADIAN_API steradian {

template <class F>
struct FuzzyMetal {
  /// Below this the cone of directions is as narrow as rounding errors: use Mirror.
  static constexpr float minFuzz = 1e-4f;

  Spectrum<F> reflectance;  ///< 0..1
  F fuzz;                   ///< minFuzz..1

  BsdfSample<F> sample(Vec3<F> wo, const BsdfRandom<F>& random, Transport transport) const {
    const Vec3<F> mirror = mirrored(wo);
    const Vec3<F> sum = mirror + UniformSphere<F>::sample(random.direction) * fuzz;
    const F squared = lengthSquared(sum);
    const MaskOf<F> found = squared > F(1e-12f);
    const Vec3<F> wi = sum * (F(1.0f) / squareRoot(maximum(squared, F(1e-12f))));
    const F pdf = select(found & sameHemisphere(wo, wi), density(mirror, wi), F(0.0f));
    const MaskOf<F> valid = pdf > F(0.0f);
    return {reflectance * adjointFactor(wo, wi, transport), wi, pdf,
            select(valid, Lobe<F>(kLobeReflection | kLobeGlossy), Lobe<F>(0u)), F(1.0f)};
  }

  BsdfValue<F> eval(Vec3<F> wo, Vec3<F> wi, Transport transport) const {
    const F pdf = select(sameHemisphere(wo, wi), density(mirrored(wo), wi), F(0.0f));
    return {reflectance * (pdf * adjointFactor(wo, wi, transport)), pdf};
  }

  F diracProbability(Vec3<F>) const { return F(0.0f); }
  Spectrum<F> albedo(Vec3<F>) const { return reflectance; }

 private:
  /// p(w), also below the surface. Rounding moves sampled directions by about 1e-7 in sin t, some of them out of the
  /// cone. So q^2 is kept above a width d of that order, and the cone is made wider by d, so that no sample has density
  /// 0. The integral of p stays the same: that of d(q^2) / q is 2 sqrt(d) over the last d of the sharp edge, and
  /// sqrt(d)
  /// + sqrt(d) over both sides of the blurred one.
  F density(Vec3<F> mirror, Vec3<F> wi) const {
    const F sinSquared = lengthSquared(cross(mirror, wi));
    const F width = F(3e-7f) * fuzz;
    const F qSquared = fuzz * fuzz - sinSquared;
    const F q = squareRoot(maximum(qSquared, width));
    const F numerator = maximum(F(1.0f) - F(2.0f) * sinSquared + fuzz * fuzz, F(0.0f));
    const MaskOf<F> inside = (qSquared > -width) & (dot(mirror, wi) > F(0.0f));
    return select(inside, numerator / (F(kTwoPi) * fuzz * q), F(0.0f));
  }

  static F adjointFactor(Vec3<F> wo, Vec3<F> wi, Transport transport) {
    if (transport == Transport::Radiance) return F(1.0f);
    return absolute(wi.z) / maximum(absolute(wo.z), F(1e-12f));
  }
};

}  // namespace steradian
