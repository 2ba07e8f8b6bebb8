#pragma once
/// The records that materials, lights and estimators exchange.
///
/// Conventions. Directions are unit length and leave the surface; `wo` points to where the path came from, `wi` is
/// sampled. A pdf is per steradian unless its name says `position` (per m^2). A sample with pdf 0 is no sample. A Dirac
/// sample has pdf == kDirac; eval never returns kDirac.
#include "steradian/core/math/vec.h"
#include "steradian/core/transport/spectrum.h"

namespace STERADIAN_API steradian {

/// The quantity that is carried along the path: it determines the scaling at refraction and the adjoint of
/// non-symmetric models.
enum class Transport { Radiance, Importance };

/// The pdf of a sample from a discrete set of directions (mirror, glass, point light).
inline constexpr float kDirac = kInfinity;

/// Power heuristic (beta 2) for one sample each of densities a and b (Veach 1997, section 9.2.4): the weight of the
/// strategy with density a > 0. A Dirac a gives 1, a Dirac b gives 0.
template <class F>
F misWeight(F a, F b) {
  return F(1.0f) / (F(1.0f) + sqr(b / a));
}

/// Lobe of a BSDF sample: bits. 0 is "no sample".
template <class F>
using Lobe = UintOf<F>;
inline constexpr std::uint32_t kLobeReflection = 1, kLobeTransmission = 2, kLobeDiffuse = 4, kLobeGlossy = 8,
                               kLobeDirac = 16;

/// The random numbers in [0,1) that one call consumes.
template <class F>
struct BsdfRandom {
  F lobe;
  Vec2<F> direction;
};
template <class F>
struct LightRandom {
  F select;
  Vec2<F> position;
};

template <class F>
struct BsdfSample {
  Spectrum<F> weight;  ///< f |cos| / pdf; for a Dirac lobe the limit of it: the lobe's throughput / its probability
  Vec3<F> wi;          ///< unit
  F pdf{0.0f};         ///< per sr; kDirac; 0: no sample (absorbed)
  Lobe<F> lobe{0u};
  F eta{1.0f};  ///< refractive index behind the interface over that before it, along the path; 1 for reflection
};

template <class F>
struct BsdfValue {
  Spectrum<F> value;  ///< f |cos|, 1/sr
  F pdf{0.0f};        ///< per sr: the density with which sample() chooses wi
};

/// The point that light is gathered at: on a surface, or free (in a medium) with normal and errors zero.
template <class F>
struct ScatterPoint {
  Vec3<F> position;
  Vec3<F> positionError;    ///< see SurfacePoint
  Vec3<F> geometricNormal;  ///< zero for a free point
  F time{0.0f};
};

template <class F>
ScatterPoint<float> lane(const ScatterPoint<F>& p, int i) {
  return {lane(p.position, i), lane(p.positionError, i), lane(p.geometricNormal, i), lane(p.time, i)};
}

template <class F>
void setLane(ScatterPoint<F>& p, int i, const ScatterPoint<float>& value) {
  setLane(p.position, i, value.position);
  setLane(p.positionError, i, value.positionError);
  setLane(p.geometricNormal, i, value.geometricNormal);
  setLane(p.time, i, value.time);
}

/// A direction towards a shape or light, with its density.
template <class F>
struct DirectionSample {
  Vec3<F> wi;
  F pdf{0.0f};            ///< per sr; 0: no sample
  F distance{kInfinity};  ///< to the sampled point, scene units; +inf if only a direction was sampled
};

/// A point on a surface, with its density.
template <class F>
struct PositionSample {
  Vec3<F> position;
  Vec3<F> normal;  ///< unit, outward
  F pdf{0.0f};     ///< per m^2
};

template <class F>
struct LightSample {
  Spectrum<F> weight;  ///< Li / pdf, unoccluded; the probability of the light's selection is inside
  Vec3<F> wi;
  F distance{0.0f};  ///< a shadow ray tests (0, distance): already shortened by the emitter's error; may be +inf
  F pdf{0.0f};       ///< per sr, selection included; kDirac for point, spot, distant; 0: no sample
};

/// Emission found by a ray that was not made by light sampling: radiance, and the density with which light sampling
/// would have chosen this direction (0 where it never does).
template <class F>
struct Emission {
  Spectrum<F> radiance;
  F pdf{0.0f};
};

}  // namespace steradian
