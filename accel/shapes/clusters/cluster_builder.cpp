#include "steradian/accel/shapes/clusters/cluster_builder.h"

#include <algorithm>

#include "steradian/accel/shapes/clusters/cluster_partition.h"
#include "steradian/core/base/parallel.h"

namespace steradian {
namespace {

/// The sets of one kind in a row: numbers their primitives 0, 1, 2, ...
template <class Leaf>
class PrimitivesOfKind {
 public:
  struct Primitive {
    typename Leaf::Shape value;
    std::uint32_t shape, primitive;
  };

  PrimitivesOfKind(const SceneDescription& scene, std::span<const Id> shapes) {
    for (const Id shape : shapes) {
      const ShapeGeometry& geometry = scene.shapes[shape].geometry;
      if (const auto* set = setOf<Leaf>(geometry)) {
        parts_.push_back({count_, set, shape});
        count_ += static_cast<std::uint32_t>(primitiveCount(geometry));
      }
    }
  }
  std::uint32_t count() const { return count_; }
  Primitive operator[](std::uint32_t ordinal) const {
    const auto after = std::upper_bound(parts_.begin(), parts_.end(), ordinal,
                                        [](std::uint32_t o, const Part& part) { return o < part.first; });
    const Part& part = *(after - 1);
    return {Leaf::at(*part.set, ordinal - part.first), part.shape, ordinal - part.first};
  }

 private:
  struct Part {
    std::uint32_t first;
    const typename Leaf::Set* set;
    Id shape;
  };
  std::vector<Part> parts_;
  std::uint32_t count_ = 0;
};

template <class Leaf>
void addKind(const SceneDescription& scene, std::span<const Id> shapes, BuiltClusters& built) {
  const PrimitivesOfKind<Leaf> all(scene, shapes);
  const ClusterPartition partition =
      partitionIntoClusters(all.count(), [&](std::uint32_t ordinal) { return boundsOf(all[ordinal].value); });
  auto& clusters = std::get<Clusters::Of<Leaf>>(built.clusters.kinds);
  clusters.resize(partition.ranges.size());
  const std::size_t firstCluster = built.bounds.size();
  built.bounds.resize(firstCluster + clusters.size());
  parallelForRanges(clusters.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c != end; ++c) {
      const ClusterRange range = partition.ranges[c];
      for (std::uint32_t i = 0; i < range.count; ++i) {
        const auto one = all[partition.items[range.begin + i].ordinal];
        clusters[c].put(static_cast<int>(i), one.value, one.shape, one.primitive);
        built.bounds[firstCluster + c].include(boundsOf(one.value));
      }
    }
  });
  built.clusters.end[LeafKinds::indexOf<Leaf>()] = static_cast<std::uint32_t>(built.bounds.size());
  built.primitives += all.count();
}

}  // namespace

BuiltClusters buildClusters(const SceneDescription& scene, std::span<const Id> shapes) {
  // By ascending id, not in the order of a group: lanes of a cluster are ordered by id.
  std::vector<Id> sorted(shapes.begin(), shapes.end());
  std::sort(sorted.begin(), sorted.end());
  BuiltClusters built;
  LeafKinds::forEach([&]<class Leaf>() { addKind<Leaf>(scene, sorted, built); });
  for (const Bounds3& bounds : built.bounds) built.total.include(bounds);
  return built;
}

}  // namespace steradian
