#pragma once
/// Environment maps: images of the whole sphere of directions, importance-sampled by their luminance.
#include <memory>

#include "steradian/core/colour/colour_image.h"
#include "steradian/core/sampling/distribution.h"
#include "steradian/core/scene/description.h"
#include "steradian/core/transport/scattering.h"

namespace STERADIAN_API steradian {

/// An ImageSky ready for lookup. Radiance is interpolated between the centres of pixels, around the seam as well;
/// values below 0 count as 0.
///
/// Directions are drawn from a density that is constant over (longitude, latitude) in each pixel: the mean of the
/// interpolated luminance there times the mean sine of the polar angle (Pharr, Jakob & Humphreys, "Physically Based
/// Rendering", 4th ed., 12.5.2). So it is positive wherever there is light, next to a lone bright pixel as well, and
/// luminance is nowhere more than 16 times the mean of its pixel.
class EnvironmentMap {
 public:
  /// The description must be valid. If `sampled`, builds the table that sample() needs, a float per pixel; without it
  /// there are no samples (pdf 0), and pdf() is 0.
  EnvironmentMap(const ImageSky& sky, bool sampled);
  /// The same map, sharing the picture and the table if there is one. If `sampled` is false, it may still be sampled.
  EnvironmentMap(const EnvironmentMap& map, bool sampled);

  /// W sr^-1 m^-2, from a unit direction.
  template <class F>
  Spectrum<F> radiance(Vec3<F> direction) const {
    return radianceAt(placeOf(direction));
  }

  /// A direction and the radiance from it.
  template <class F>
  struct Sample {
    DirectionSample<F> direction;
    Spectrum<F> radiance;
  };
  template <class F>
  Sample<F> sample(Vec2<F> u) const;
  /// The pdf of sample(), per sr; 0 if the picture is black or not sampled.
  template <class F>
  F pdf(Vec3<F> direction) const;

  /// The integral of the radiance over all directions: W m^-2 per channel.
  Rgb total() const { return total_; }

 private:
  /// Coordinates over the picture, in [0, 1): from the left and from the top; and the sine of the polar angle.
  template <class F>
  struct Place {
    Vec2<F> point;
    F sine;
  };
  template <class F>
  Place<F> placeOf(Vec3<F> direction) const;
  template <class F>
  Spectrum<F> radianceAt(const Place<F>& place) const;
  /// Converts a density over the unit square of the picture to one per sr.
  template <class F>
  static F perSteradian(F density, F sine) {
    // At the poles the sine may round to 0, where the solid angle vanishes too.
    return density / (F(2.0f * kPi * kPi) * maximum(sine, F(1e-6f)));
  }

  void makeTable();

  ColourImage picture_;
  Rgb scale_, total_;
  float turn_;                                        ///< rotation of the picture about +y, in turns, in [0, 1)
  std::shared_ptr<const PiecewiseConstant2D> table_;  ///< null: not sampled, or black
};

template <class F>
EnvironmentMap::Place<F> EnvironmentMap::placeOf(Vec3<F> direction) const {
  const F sine = squareRoot(direction.x * direction.x + direction.z * direction.z);
  const F turns = arcTan2(direction.x, -direction.z) * F(kInvTwoPi) + F(0.5f + turn_);
  const F last(kOneMinusEpsilon);
  return {{minimum(turns - floorOf(turns), last), minimum(arcTan2(sine, direction.y) * F(kInvPi), last)}, sine};
}

template <class F>
Spectrum<F> EnvironmentMap::radianceAt(const Place<F>& place) const {
  const auto width = static_cast<float>(picture_.width()), height = static_cast<float>(picture_.height());
  const F x = place.point.x * F(width) - F(0.5f), y = place.point.y * F(height) - F(0.5f);
  const F column = floorOf(x), row = floorOf(y);
  const auto index = [](F i) { return toUnsigned(toInt(i)); };
  const F left = select(column < F(0.0f), F(width - 1.0f), column);
  const F right = select(column + F(1.0f) >= F(width), F(0.0f), column + F(1.0f));
  const F upper = maximum(row, F(0.0f)), lower = minimum(row + F(1.0f), F(height - 1.0f));
  const Spectrum<F> c =
      picture_.blend<F>({index(left), index(right), x - column}, {index(upper), index(lower), y - row});
  const F zero(0.0f);
  return broadcast<F>(scale_) * Spectrum<F>{maximum(c.r, zero), maximum(c.g, zero), maximum(c.b, zero)};
}

template <class F>
EnvironmentMap::Sample<F> EnvironmentMap::sample(Vec2<F> u) const {
  if (!table_) return {};
  const auto s = table_->sample(u);
  const SinCos<F> theta = sinCosTwoPi(F(0.5f) * s.point.y);
  const SinCos<F> phi = sinCosTwoPi(s.point.x - F(0.5f + turn_));
  const F sine = maximum(theta.sin, F(0.0f));
  const Place<F> place{s.point, sine};
  return {{{phi.sin * sine, theta.cos, -phi.cos * sine}, perSteradian(s.pdf, sine), F(kInfinity)}, radianceAt(place)};
}

template <class F>
F EnvironmentMap::pdf(Vec3<F> direction) const {
  if (!table_) return F(0.0f);
  const Place<F> place = placeOf(direction);
  return perSteradian(table_->pdf(place.point), place.sine);
}

}  // namespace steradian
