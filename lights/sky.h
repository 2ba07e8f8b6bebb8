#pragma once
/// Smooth skies: radiance from infinitely far away, constant or linear in the y of the direction.
#include "steradian/core/math/frame.h"
#include "steradian/core/sampling/warp.h"
#include "steradian/core/scene/description.h"
#include "steradian/core/transport/scattering.h"

namespace STERADIAN_API steradian {

/// All smooth skies of a scene in one: their radiances add up, and the sum is linear in y again.
struct Sky {
  Rgb nadir{}, zenith{};

  void add(const ConstantSky& sky) { *this = {nadir + sky.radiance, zenith + sky.radiance}; }
  void add(const GradientSky& sky) { *this = {nadir + sky.nadir, zenith + sky.zenith}; }

  /// Radiance from `direction`, W sr^-1 m^-2.
  template <class F>
  Spectrum<F> radiance(Vec3<F> direction) const {
    const F t = F(0.5f) * (direction.y + F(1.0f));
    return broadcast<F>(nadir) * (F(1.0f) - t) + broadcast<F>(zenith) * t;
  }

  /// The integral of the radiance over all directions: W m^-2 per channel.
  Rgb total() const { return (nadir + zenith) * (0.5f * kFourPi); }
};

/// The pdf with which smooth skies are sampled: |cos| / 2 pi with the normal, on both sides of the surface, since
/// lights do not know to which side it scatters; 1 / 4 pi for a point in a medium (normal zero).
template <class F>
F skyPdf(Vec3<F> normal, Vec3<F> wi) {
  const MaskOf<F> free = lengthSquared(normal) == F(0.0f);
  return select(free, F(kInvFourPi), absDot(normal, wi) * F(kInvTwoPi));
}

/// A direction with the pdf skyPdf, per sr.
template <class F>
DirectionSample<F> sampleSky(Vec3<F> normal, Vec2<F> u) {
  const MaskOf<F> free = lengthSquared(normal) == F(0.0f);
  const Vec3<F> axis = select(free, Vec3<F>{F(0.0f), F(0.0f), F(1.0f)}, normal);
  // The first random number also chooses the side.
  const MaskOf<F> above = u.x < F(0.5f);
  const F rest = minimum(F(2.0f) * select(above, u.x, u.x - F(0.5f)), F(kOneMinusEpsilon));
  const Vec3<F> cosine = Frame<F>::fromZ(select(above, axis, -axis)).toWorld(CosineHemisphere<F>::sample({rest, u.y}));
  const Vec3<F> wi = select(free, UniformSphere<F>::sample(u), cosine);
  return {wi, skyPdf(normal, wi), F(kInfinity)};
}

}  // namespace steradian
