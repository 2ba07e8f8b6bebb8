#pragma once
/// Where the shapes of a scene are: the groups and instances of a description, expanded.
///
/// A shape that belongs to no group is placed directly, once. The shapes of a group are placed once per instance of it,
/// and nowhere else. The flattened order, which ids and sums rely on: the shapes placed directly, as in
/// SceneDescription::shapes; then the instance sets in order, the transforms of each in order, and the shapes of the
/// group in order. Instances are numbered in this order through all sets; SurfacePoint::instance is that number.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "steradian/core/base/api.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

/// One instance of a group. A small value that refers to the description.
struct InstancePlacement {
  const InstanceSet* set;
  std::size_t copy;     ///< which of the set's transforms
  std::uint32_t index;  ///< in the flattened order

  Id group() const { return set->group; }
  /// From the space of the group to the world; of an instance that moves, at time 0.
  const Matrix& localToWorld() const { return set->transforms[copy]; }
  /// The transforms at time 0 and 1; none if the instance does not move, or the two are equal.
  std::optional<Motion> motion() const {
    if (set->closing.empty() || set->closing[copy] == set->transforms[copy]) return std::nullopt;
    return Motion{set->transforms[copy], set->closing[copy]};
  }
  /// Where the file says so.
  const SourceRange& where() const { return set->where; }
};

/// A shape in one of its places. Its own motion, if it has one, comes before that of the instance.
struct ShapePlacement {
  Id shape;
  std::optional<InstancePlacement> instance;  ///< none: placed directly

  /// As in SurfacePoint: kNone if placed directly.
  std::uint32_t instanceIndex() const { return instance ? instance->index : kNone; }
};

/// The expansion of one description. Building it takes time and memory in proportion to the shapes, groups and instance
/// sets, not to the instances; visiting allocates nothing.
class Placements {
 public:
  /// `scene` must be valid as to groups and instances (see validate()), and outlive this.
  explicit Placements(const SceneDescription& scene);

  /// The shapes that belong to no group, in order.
  const std::vector<Id>& directShapes() const { return direct_; }
  bool isDirect(Id shape) const { return isDirect_[shape]; }
  /// The shapes that an instance places.
  std::span<const Id> shapesOf(const InstancePlacement& instance) const {
    return scene_->groups[instance.group()].shapes;
  }

  /// In how many places a shape is: 1 if placed directly; 0 if its groups have no instances.
  std::uint64_t countOf(Id shape) const { return counts_[shape]; }

  std::size_t instanceCount() const { return firstOfSet_.back(); }
  /// The instance of this number, below instanceCount(); it takes a binary search among the sets.
  InstancePlacement instance(std::uint32_t index) const;
  /// Whether any instance moves.
  bool anyInstanceMoves() const;

  /// Calls visit(InstancePlacement) for all instances, in order.
  template <class Visit>
  void forEachInstance(const Visit& visit) const {
    std::uint32_t index = 0;
    for (const InstanceSet& set : scene_->instances) {
      for (std::size_t copy = 0; copy < set.transforms.size(); ++copy) visit(InstancePlacement{&set, copy, index++});
    }
  }
  /// Calls visit(ShapePlacement) for all places of all shapes, in the flattened order.
  template <class Visit>
  void forEachShape(const Visit& visit) const {
    for (const Id shape : direct_) visit(ShapePlacement{shape, std::nullopt});
    forEachInstance([&](const InstancePlacement& instance) {
      for (const Id shape : shapesOf(instance)) visit(ShapePlacement{shape, instance});
    });
  }
  /// Calls visit(ShapePlacement) for all places of one shape, in the flattened order. It takes time in proportion to
  /// those and to the instance sets.
  template <class Visit>
  void forEachPlaceOf(Id shape, const Visit& visit) const;

 private:
  const SceneDescription* scene_;
  std::vector<Id> direct_;
  std::vector<bool> isDirect_;             ///< per shape
  std::vector<std::uint64_t> counts_;      ///< per shape
  std::vector<std::uint32_t> firstOfSet_;  ///< per instance set, the number of its first instance; and that of all
};

template <class Visit>
void Placements::forEachPlaceOf(Id shape, const Visit& visit) const {
  if (isDirect_[shape]) return visit(ShapePlacement{shape, std::nullopt});
  for (std::size_t s = 0; s < scene_->instances.size(); ++s) {
    const InstanceSet& set = scene_->instances[s];
    const std::vector<Id>& members = scene_->groups[set.group].shapes;
    const auto times = std::count(members.begin(), members.end(), shape);
    if (times == 0) continue;
    for (std::size_t copy = 0; copy < set.transforms.size(); ++copy) {
      const InstancePlacement instance{&set, copy, firstOfSet_[s] + static_cast<std::uint32_t>(copy)};
      for (auto i = times; i > 0; --i) visit(ShapePlacement{shape, instance});
    }
  }
}

}  // namespace steradian
