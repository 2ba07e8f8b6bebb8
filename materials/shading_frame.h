#pragma once
/// Models in world space: a model works in the frame of the shading normal, while the geometric normal decides what is
/// reflection and what is transmission.
#include "steradian/core/math/frame.h"
#include "steradian/core/transport/scattering.h"

namespace STERADIAN_API steradian {

/// Directions are unit vectors in world space that leave the surface. Where the two normals disagree about whether wo
/// and wi are on the same side, the value is black, so that light does not leak through surfaces with interpolated
/// normals (Veach 1997, 5.3).
template <class F>
class ShadingFrame {
 public:
  /// Both normals are unit and outward. A model takes the shading normal for its z axis.
  ShadingFrame(Vec3<F> geometricNormal, Vec3<F> shadingNormal)
      : frame_(Frame<F>::fromZ(shadingNormal)), geometricNormal_(geometricNormal) {}

  Vec3<F> shadingNormal() const { return frame_.z; }
  Vec3<F> geometricNormal() const { return geometricNormal_; }
  Vec3<F> toLocal(Vec3<F> w) const { return frame_.toLocal(w); }

  template <class Model>
  BsdfSample<F> sample(const Model& model, Vec3<F> wo, const BsdfRandom<F>& random, Transport transport) const {
    const Vec3<F> localWo = frame_.toLocal(wo);
    BsdfSample<F> s = model.sample(localWo, random, transport);
    const Vec3<F> localWi = s.wi;
    s.wi = normalize(frame_.toWorld(localWi));
    const MaskOf<F> passes = (s.pdf > F(0.0f)) & !leaks(wo, s.wi, localWo, localWi);
    s.pdf = select(passes, s.pdf, F(0.0f));
    s.lobe = select(passes, s.lobe, Lobe<F>(0u));
    s.weight *= shadingNormalCorrection(wo, s.wi, localWo, localWi, transport);
    return s;
  }

  template <class Model>
  BsdfValue<F> eval(const Model& model, Vec3<F> wo, Vec3<F> wi, Transport transport) const {
    const Vec3<F> localWo = frame_.toLocal(wo), localWi = frame_.toLocal(wi);
    BsdfValue<F> v = model.eval(localWo, localWi, transport);
    v.value *= shadingNormalCorrection(wo, wi, localWo, localWi, transport);
    const MaskOf<F> leak = leaks(wo, wi, localWo, localWi);
    return {select(leak, grey(F(0.0f)), v.value), select(leak, F(0.0f), v.pdf)};
  }

 private:
  MaskOf<F> leaks(Vec3<F> wo, Vec3<F> wi, Vec3<F> localWo, Vec3<F> localWi) const {
    const MaskOf<F> reflectsLocally = localWo.z * localWi.z > F(0.0f);
    const MaskOf<F> reflects = dot(wo, geometricNormal_) * dot(wi, geometricNormal_) > F(0.0f);
    return reflectsLocally ^ reflects;
  }
  /// Shading normals make every BSDF non-symmetric: the factor of Veach 1997, equation 5.19, where importance is
  /// transported, which means that light arrives along wo. PBRT calls it CorrectShadingNormal.
  F shadingNormalCorrection(Vec3<F> wo, Vec3<F> wi, Vec3<F> localWo, Vec3<F> localWi, Transport transport) const {
    if (transport == Transport::Radiance) return F(1.0f);
    const F above = absolute(localWo.z) * absDot(wi, geometricNormal_);
    const F below = absDot(wo, geometricNormal_) * absolute(localWi.z);
    return select(below > F(0.0f), above / below, F(0.0f));
  }

  Frame<F> frame_;
  Vec3<F> geometricNormal_;
};

/// The normal to shade a point with: the shading normal, or the geometric normal where the two disagree about the side
/// that wo is on.
template <class F>
Vec3<F> usableShadingNormal(Vec3<F> geometricNormal, Vec3<F> shadingNormal, Vec3<F> wo) {
  const MaskOf<F> disagree = dot(shadingNormal, wo) * dot(geometricNormal, wo) <= F(0.0f);
  return select(disagree, geometricNormal, shadingNormal);
}

}  // namespace steradian
