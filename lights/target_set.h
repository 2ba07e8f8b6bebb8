#pragma once
/// What the strategy `mixture` samples towards: lights, but also windows, glass spheres, boxes ("The Rest of Your
/// Life", chapters 10 and 12).
#include <span>
#include <string>

#include "steradian/accel/shapes/sampling/hittable_pdf.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

/// A set of objects, each with the same probability, as in the book's list of hittables. An object is
/// - all area lights together, chosen among in proportion to the luminance of their power; or
/// - a shape of the description, with all primitives of its set and all its instances, in proportion to their area.
///
/// The density is the marginal one: the probability-weighted sum over all members that the line meets, hit first or
/// not, from whichever side.
class TargetSet {
 public:
  /// What to aim at where no names are given: what the description flags as a target.
  enum class Unnamed {
    FlaggedOrLights,  ///< or else the lights
    FlaggedButLights  ///< of that what does not emit: lights are sampled otherwise
  };
  /// The objects that have these names: shapes, or "lights". Throws Error: Usage for a name that nothing has, with a
  /// suggestion; Scene for custom shapes.
  explicit TargetSet(const SceneDescription& scene, std::span<const std::string> names = {},
                     Unnamed unnamed = Unnamed::FlaggedOrLights);

  /// Without a distance, as a direction may meet several members. Lanes that are not active have no sample.
  template <class F>
  DirectionSample<F> sampleDirection(const ScatterPoint<F>& from, const LightRandom<F>& random,
                                     MaskOf<F> active = MaskOf<F>(true)) const;
  /// The density of that, per sr; of lanes that are not active any. It takes time in proportion to the number of
  /// members.
  template <class F>
  F pdfDirection(const ScatterPoint<F>& from, Vec3<F> wi, MaskOf<F> active = MaskOf<F>(true)) const;

  /// Nothing to sample: no targets, no lights, or lights without power.
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
