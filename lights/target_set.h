#pragma once
/// What the strategy `mixture` samples towards: lights, but also windows, glass spheres, boxes ("The Rest of Your
/// Life", chapters 10 and 12).
#include <span>
#include <string>

#include "steradian/accel/shapes/sampling/hittable_pdf.h"
#include "steradian/core/scene/description.h"
#include "steradian/lights/area_lights.h"

namespace STERADIAN_API steradian {

/// A set of objects, each with the same probability, as in the book's list of hittables. An object is
/// - all area lights together, chosen among in proportion to the luminance of their power; or
/// - a shape of the description, with all primitives of its set and all its instances, in proportion to their area.
///
/// The pdf is the marginal one: the sum, weighted by their probabilities, over all primitives that the line intersects,
/// from either side and occluded or not.
class TargetSet {
 public:
  /// The targets if no names are given: those that the description flags (ShapeDescription::target).
  enum class Unnamed {
    FlaggedOrLights,    ///< if there are none, the lights
    FlaggedNonEmitters  ///< without those that emit, which are sampled as lights
  };
  /// The objects that have these names: shapes, or "lights". Throws Error: Usage for a name that nothing has, with a
  /// suggestion; Scene for custom shapes.
  explicit TargetSet(const SceneDescription& scene, std::span<const std::string> names = {},
                     Unnamed unnamed = Unnamed::FlaggedOrLights);
  /// The same, with the area lights of this scene where they exist already (LightSet::areas()).
  TargetSet(const SceneDescription& scene, const AreaLights& lights, std::span<const std::string> names,
            Unnamed unnamed);

  /// The sample has no distance, as a line may intersect several targets. Lanes that are not active have no sample.
  template <class F>
  DirectionSample<F> sampleDirection(const ScatterPoint<F>& from, const LightRandom<F>& random,
                                     MaskOf<F> active = MaskOf<F>(true)) const;
  /// The pdf of sampleDirection(), per sr; undefined in lanes that are not active. It takes time in proportion to
  /// size().
  template <class F>
  F pdfDirection(const ScatterPoint<F>& from, Vec3<F> wi, MaskOf<F> active = MaskOf<F>(true)) const;

  /// Whether there is nothing to sample: no targets, no lights, or lights without power.
  bool empty() const { return members_.empty(); }
  std::size_t size() const { return members_.shapes().size(); }

 private:
  TargetGroup members_;
};

template <class F>
DirectionSample<F> TargetSet::sampleDirection(const ScatterPoint<F>& from, const LightRandom<F>& random,
                                              MaskOf<F> active) const {
  return members_.sampleDirection(from.position, random.select, random.position, from.time, active);
}

template <class F>
F TargetSet::pdfDirection(const ScatterPoint<F>& from, Vec3<F> wi, MaskOf<F> active) const {
  return members_.pdfDirection(from.position, wi, from.time, active);
}

}  // namespace steradian
