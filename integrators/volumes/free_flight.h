#pragma once
/// Free flight: how far paths get in participating media before they are scattered or absorbed.
///
/// A ray is traced in segments, from surface to surface: its origin stays, tMin moves on to the surface passed
/// (crossings.h). What media do to a segment is computed here, for one path or for several at once.
#include "steradian/core/math/ray.h"
#include "steradian/core/sampling/warp.h"
#include "steradian/materials/medium_set.h"

namespace STERADIAN_API steradian {

/// The free flight of paths to the next surface that stops them, or to where a medium scatters them.
///
/// The optical depth at which a path is scattered is drawn once, for one channel, and used up segment by segment. The
/// channel is chosen in proportion to the throughput, and weights count all of them (the balance heuristic; Wilkie et
/// al. 2014, "Hero wavelength spectral sampling"). Media that only absorb are not sampled: what they let through is
/// known.
template <class F>
class FreeFlight {
 public:
  using Mask = MaskOf<F>;

  FreeFlight() = default;
  /// `random`: numbers in [0, 1).
  FreeFlight(const Spectrum<F>& throughput, const Vec2<F>& random);

  /// One segment of the active paths: `ray` through `medium`, up to `distance` from the ray's origin (may be +inf).
  /// Returns the paths that the medium scatters before that, at ray.at(distance()).
  Mask sampleSegment(const Medium<F>& medium, const Ray<F>& ray, F distance, Mask active);

  const Spectrum<F>& weight() const { return weight_; }  ///< throughput of the flight up to the end of the last segment
  const Spectrum<F>& emitted() const { return emitted_; }  ///< radiance that the media so far emit towards the start
  F distance() const { return distance_; }                 ///< m; from the ray's origin to the end of the last segment

 private:
  static F sum(const Spectrum<F>& c) { return c.r + c.g + c.b; }
  static F inverse(F density) { return select(density > F(0.0f), F(1.0f) / density, F(0.0f)); }

  Spectrum<F> choice_;                  ///< probability of each channel
  Mask isRed_, isGreen_;                ///< the channel chosen; neither: blue
  F depthLeft_{kInfinity};              ///< optical depth in that channel
  Spectrum<F> left_ = grey(F(1.0f));    ///< transmittance so far, of media that scatter
  Spectrum<F> passed_ = grey(F(1.0f));  ///< transmittance so far, of media that only absorb
  Spectrum<F> weight_ = grey(F(1.0f)), emitted_;
  F distance_{0.0f};
};

template <class F>
FreeFlight<F>::FreeFlight(const Spectrum<F>& throughput, const Vec2<F>& random) {
  const F total = sum(throughput), share = inverse(total);
  choice_ = select(total > F(0.0f), throughput * share, grey(F(1.0f / 3.0f)));
  isRed_ = random.y < choice_.r;
  isGreen_ = random.y < choice_.r + choice_.g;
  depthLeft_ = ExponentialFlight<F>{F(1.0f)}.sample(random.x);
}

template <class F>
MaskOf<F> FreeFlight<F>::sampleSegment(const Medium<F>& medium, const Ray<F>& ray, F distance, Mask active) {
  const F length = distance - ray.tMin;
  if (any(active & medium.emits())) {
    const Spectrum<F> seen = passed_ * left_ * medium.emitted(length) * inverse(sum(choice_ * left_));
    emitted_ = select(active, emitted_ + seen, emitted_);
  }
  const Mask scatters = active & medium.scatters();
  const Spectrum<F>& extinction = medium.extinction;
  const F rate = select(isRed_, extinction.r, select(isGreen_, extinction.g, extinction.b));
  const Mask mayScatter = scatters & (rate > F(0.0f));
  const F way = select(mayScatter, depthLeft_ / rate, F(kInfinity));
  const Mask scattered = scatters & (way < length);
  depthLeft_ = select(mayScatter, maximum(depthLeft_ - rate * length, F(0.0f)), depthLeft_);
  const Spectrum<F> share = medium.transmittance(select(scattered, way, length));
  left_ = select(scatters, left_ * share, left_);
  passed_ = select(active & !scatters, passed_ * share, passed_);
  // Divide by the density with which a flight in any of the channels is scattered here, or gets here.
  const Spectrum<F> density = select(scattered, extinction * left_, left_);
  const Spectrum<F> value = select(scattered, medium.scattering * left_, left_);
  weight_ = select(active, passed_ * value * inverse(sum(choice_ * density)), weight_);
  distance_ = select(active, select(scattered, ray.tMin + way, distance), distance_);
  return scattered;
}

}  // namespace steradian
