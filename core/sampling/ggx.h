#pragma once
/// Microfacet normals of the GGX distribution (Walter et al. 2007, "Microfacet models for refraction through rough
/// surfaces"), their masking by Smith's model, and the sampling of those that are visible.
///
/// Local frame: the surface's normal is (0, 0, 1); the roughness along x and y may differ (Heitz 2014, "Understanding
/// the masking-shadowing function in microfacet-based BRDFs"). Densities are per steradian.
#include "steradian/core/sampling/warp.h"

namespace STERADIAN_API steradian {

/// The distribution: an ellipsoid's normals. Both alphas are in [1e-4, 10]; narrower lobes are mirrors to floats.
template <class F>
struct Ggx {
  F alphaX, alphaY;

  /// Area of the facets with normal m per area of the surface and sr: 1 / (pi ax ay (mx^2 / ax^2 + my^2 / ay^2 +
  /// mz^2)^2) for m.z > 0, else 0. The integral of density(m) m.z is 1.
  F density(Vec3<F> m) const {
    const F x = m.x / alphaX, y = m.y / alphaY;
    const F s = x * x + y * y + m.z * m.z;
    return select(m.z > F(0.0f), F(kInvPi) / (alphaX * alphaY * s * s), F(0.0f));
  }
  /// sqrt(ax^2 x^2 + ay^2 y^2 + z^2): the length of w in the frame in which the ellipsoid is a sphere.
  F stretched(Vec3<F> w) const { return length(toSphere(w)); }
  Vec3<F> toSphere(Vec3<F> w) const { return {alphaX * w.x, alphaY * w.y, w.z}; }

  /// The part of the facets facing w that is not masked in its direction, w.z > 0: 2 z / (z + stretched(w)).
  F masking(Vec3<F> w) const { return F(2.0f) * w.z / (w.z + stretched(w)); }
  /// The part that is seen from both sides, correlated by height: 1 / (1 + lambda(a) + lambda(b)); a.z, b.z > 0.
  F maskingShadowing(Vec3<F> a, Vec3<F> b) const {
    const F crossed = b.z * stretched(a) + a.z * stretched(b);
    return F(2.0f) * a.z * b.z / crossed;
  }
};

/// The normals that are visible from wo (unit, wo.z >= 0), each in proportion to the area that it shows: the density is
///
///     masking(wo) max(0, wo . m) density(m) / wo.z = 2 max(0, wo . m) density(m) / (wo.z + stretched(wo)).
///
/// Sampled by spherical caps (Dupuy & Benyoub 2023, "Sampling visible GGX normals with spherical caps"): seen by the
/// unit vector w along toSphere(wo), the mirror images c of w about the visible normals of a sphere's upper half are
/// uniform in the cap c.z > -w.z. m.z > 0 for every sample; the cosine of a grazing one with wo may round to 0, which
/// makes it no sample. From the normal itself (wo = (0, 0, 1)) this is the density
/// of all normals, density(m) m.z.
template <class F>
struct GgxVisibleNormals {
  Ggx<F> ggx;
  Vec3<F> wo;

  Vec3<F> sample(Vec2<F> u) const {
    const Vec3<F> w = normalize(ggx.toSphere(wo));
    // 1 - c.z and 1 + c.z, and c.z + w.z, without cancellation: c is close to -w for grazing normals.
    const F height = F(1.0f) + w.z, above = u.y * height, beyond = (F(1.0f) - u.y) * height;
    const F sinTheta = safeSqrt(above * (beyond + oneMinusCosTheta(w)));
    const SinCos<F> phi = sinCosTwoPi(u.x);
    const Vec3<F> half{sinTheta * phi.cos + w.x, sinTheta * phi.sin + w.y, beyond};
    return normalize(Vec3<F>{ggx.alphaX * half.x, ggx.alphaY * half.y, half.z});
  }
  F pdf(Vec3<F> m) const {
    const F seen = maximum(dot(wo, m), F(0.0f));
    return F(2.0f) * seen * ggx.density(m) / (wo.z + ggx.stretched(wo));
  }
  Vec2<F> invert(Vec3<F> m) const {
    const Vec3<F> w = normalize(ggx.toSphere(wo));
    const Vec3<F> n = normalize(Vec3<F>{m.x / ggx.alphaX, m.y / ggx.alphaY, m.z});
    const Vec3<F> c = n * (F(2.0f) * dot(w, n)) - w;
    const F u = oneMinusCosTheta(c) / (F(1.0f) + w.z);
    return {invertAzimuth(c.x, c.y), clamp(u, F(0.0f), F(kOneMinusEpsilon))};
  }
};

/// The mirror images of wo (unit, wo.z >= 0) about the normals that are visible from there: the density of normals over
/// the Jacobian 4 wo . m, which leaves density(m) / (2 (wo.z + stretched(wo))), m = (wo + wi) / |wo + wi|. Some lie
/// below the horizon: they are part of the density, a BSDF absorbs them.
template <class F>
struct GgxReflection {
  GgxVisibleNormals<F> normals;

  Vec3<F> sample(Vec2<F> u) const {
    const Vec3<F> m = normals.sample(u);
    return normalize(m * (F(2.0f) * dot(normals.wo, m)) - normals.wo);
  }
  F pdf(Vec3<F> wi) const {
    const Vec3<F> sum = normals.wo + wi;
    const F size = length(sum);
    const Vec3<F> m = sum * select(size > F(0.0f), F(1.0f) / size, F(0.0f));
    return normals.ggx.density(m) * F(0.5f) / (normals.wo.z + normals.ggx.stretched(normals.wo));
  }
  Vec2<F> invert(Vec3<F> wi) const { return normals.invert(normalize(normals.wo + wi)); }
};

}  // namespace steradian
