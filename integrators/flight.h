#pragma once
/// How rays get from one place to the next: through media, and through surfaces that are none to them.
///
/// A ray is traced in segments, from surface to surface: its origin stays, tMin moves on to the surface passed. Whoever
/// traces hands in what each segment met; so the wide integrator traces all its lanes at once, and decides lane by lane
/// with the functions of the scalar one.
#include "steradian/core/ray.h"
#include "steradian/integrators/volumes.h"

namespace steradian {

/// A ray that is passed through this often without being scattered is given up.
inline constexpr std::uint32_t kMostCrossings = 10000;

/// The flight of a path: to the surface that it meets, or to where a medium scatters it.
///
/// The optical depth at which it is scattered is drawn once, for one channel, and used up segment by segment. The
/// channel is chosen as the throughput has it, and weights count all of them (the balance heuristic; Wilkie et al.
/// 2014, "Hero wavelength spectral sampling"). Media that only absorb are not sampled: what they let through is known.
class Flight {
 public:
  Flight() = default;
  /// `random`: two numbers in [0, 1).
  Flight(Rgb throughput, Vec2f random);

  /// One segment: `ray`, inside of `bodies`, met `met` (not valid: nothing, however far). True if it goes on beyond:
  /// then `ray` is what is left to trace.
  bool advance(const Volumes& volumes, const SurfacePoint<float>& met, Ray<float>& ray, Bodies& bodies);

  /// Of the whole flight, once advance has returned false.
  Rgb weight() const { return weight_; }            ///< of where it arrives
  Rgb emitted() const { return emitted_; }          ///< radiance that the media on its way send to its start
  float distance() const { return distance_; }      ///< m
  float outsideEta() const { return outsideEta_; }  ///< see Boundary: of the surface met
  /// The medium that scatters it; null: it met a surface, or nothing.
  const Medium* scatteredBy() const { return scatteredBy_; }
  Vec3f position() const { return position_; }  ///< where it is scattered

 private:
  Rgb shareOf(Rgb left) const;

  Rgb choice_{};  ///< probability of each channel
  int channel_ = 0;
  float depthLeft_ = kInfinity;  ///< optical depth in that channel
  Rgb left_ = grey(1.0f);        ///< transmittance of media that scatter, so far
  Rgb passed_ = grey(1.0f);      ///< of those that only absorb
  Rgb weight_ = grey(1.0f), emitted_{};
  float distance_ = 0.0f, outsideEta_ = 1.0f;
  const Medium* scatteredBy_ = nullptr;
  Vec3f position_{};
  // The last boundary that the ray passed:
  std::uint32_t crossings_ = 0;  ///< how many before it, and itself
  Bodies before_;
  Vec3f passedError_{};
};

/// The way of a shadow ray to the light.
class LightWay {
 public:
  /// As Flight::advance; `met` is what `ray` met before its tMax.
  bool advance(const Volumes& volumes, const SurfacePoint<float>& met, Ray<float>& ray, Bodies& bodies);
  /// The share of the light that arrives.
  Rgb transmittance() const { return transmittance_; }

 private:
  Rgb transmittance_ = grey(1.0f);
  std::uint32_t crossings_ = 0;
};

}  // namespace steradian
