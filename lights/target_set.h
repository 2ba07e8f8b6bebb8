#pragma once
/// What the strategy `mixture` samples towards: lights, but also windows, glass spheres, boxes ("The Rest of Your
/// Life", chapters 10 and 12).
#include <span>
#include <string>

#include "steradian/accel/shapes/hittable_pdf.h"
#include "steradian/core/description.h"

namespace steradian {

/// A set of objects, each with the same probability, as in the book's list of hittables. An object is
/// - all area lights together, chosen among in proportion to the luminance of their power; or
/// - a shape of the description, with all primitives of its set and all its instances, in proportion to their area.
///
/// The density is the marginal one: the probability-weighted sum over all members that the line meets, hit first or
/// not, from whichever side.
class TargetSet {
 public:
  /// The objects that have these names: shapes, or "lights". No names: the shapes that the description flags as
  /// targets, or else the lights. Throws Error: Usage for a name that nothing has, with a suggestion; Scene for custom
  /// shapes.
  explicit TargetSet(const SceneDescription& scene, std::span<const std::string> names = {});

  /// Without a distance, as a direction may meet several members.
  DirectionSample<float> sampleDirection(const ScatterPoint<float>& from, const LightRandom<float>& random) const;
  /// The density of that, per sr. It takes time in proportion to the number of members.
  float pdfDirection(const ScatterPoint<float>& from, Vec3f wi) const;

  /// Nothing to sample: no lights, or lights without power.
  bool empty() const { return members_.empty(); }
  std::size_t size() const { return members_.shapes().size(); }

 private:
  TargetGroup members_;
};

}  // namespace steradian
