#include "steradian/core/scene/placements.h"

namespace steradian {

Placements::Placements(const SceneDescription& scene)
    : scene_(&scene), isDirect_(scene.shapes.size(), true), counts_(scene.shapes.size(), 0), firstOfSet_{0} {
  for (const Group& group : scene.groups) {
    for (const Id shape : group.shapes) isDirect_[shape] = false;
  }
  for (Id shape = 0; shape < scene.shapes.size(); ++shape) {
    if (!isDirect_[shape]) continue;
    direct_.push_back(shape);
    counts_[shape] = 1;
  }
  std::vector<std::uint64_t> instancesOf(scene.groups.size(), 0);
  for (const InstanceSet& set : scene.instances) {
    instancesOf[set.group] += set.transforms.size();
    firstOfSet_.push_back(firstOfSet_.back() + static_cast<std::uint32_t>(set.transforms.size()));
  }
  for (std::size_t group = 0; group < scene.groups.size(); ++group) {
    for (const Id shape : scene.groups[group].shapes) counts_[shape] += instancesOf[group];
  }
}

InstancePlacement Placements::instance(std::uint32_t index) const {
  const auto after = std::upper_bound(firstOfSet_.begin(), firstOfSet_.end(), index);
  const auto set = static_cast<std::size_t>(after - firstOfSet_.begin()) - 1;
  return {&scene_->instances[set], index - firstOfSet_[set], index};
}

bool Placements::anyInstanceMoves() const {
  return std::any_of(scene_->instances.begin(), scene_->instances.end(),
                     [](const InstanceSet& set) { return !set.closing.empty() && set.closing != set.transforms; });
}

}  // namespace steradian
