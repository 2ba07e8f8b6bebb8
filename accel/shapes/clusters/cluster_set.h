#pragma once
/// All clusters of one hierarchy: the shapes placed directly in a scene, or those of one group.
#include <span>
#include <vector>

#include "steradian/accel/shapes/clusters/leaf_kernels.h"
#include "steradian/accel/shapes/clusters/leaf_shape.h"
#include "steradian/accel/shapes/clusters/point_record.h"
#include "steradian/core/math/bounds.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

class ClusterSet {
 public:
  ClusterSet() = default;
  /// Clusters of the given shapes; built by the threads of the caller's arena. The description must outlive the set if
  /// it has custom shapes; of all others the set keeps what it needs. Queries run on the kernels of `isa`.
  ClusterSet(const SceneDescription& scene, std::span<const Id> shapes, Isa isa = bestIsa());

  /// Number of clusters.
  std::uint32_t size() const { return clusters_.end.back(); }
  /// Bounds of the clusters, until dropBounds().
  std::span<const Bounds3> clusterBounds() const { return bounds_; }
  /// Bounds of everything.
  const Bounds3& bounds() const { return total_; }
  /// From now on queries go through this hierarchy over clusterBounds(), wide enough for rounding.
  void setTree(ClusterTree tree) { clusters_.tree = std::move(tree); }
  /// Frees the bounds of clusters, once a hierarchy has been built over them.
  void dropBounds() { bounds_ = {}; }
  /// Memory that the set holds.
  std::size_t bytes() const;

  /// Whether there is a primitive at a place from 0 to size() * kClusterSize - 1; of custom shapes never.
  bool isUsed(std::uint32_t place) const;
  /// What is at LeafHit::place, which is not kNone. A ray that has hit a primitive has its cluster in the cache, but
  /// not its ten numbers in the arrays of the description.
  LeafShape leafShape(std::uint32_t place) const;
  /// All but the material.
  void fillRecord(PointRecord& record, std::uint32_t place) const;

  /// Nearest hit with tMin < t < tMax: updates `best` where it is nearer, or equally near with a smaller id.
  /// `instance`: the one met in, or kNone.
  void nearest(const Ray<float>& ray, std::uint32_t instance, LeafHit& best) const {
    kernels_->nearest(clusters_, ray, instance, best);
  }
  /// Is anything hit between tMin and tMax?
  bool any(const Ray<float>& ray) const { return kernels_->any(clusters_, ray); }

 private:
  template <class Leaf>
  void add(const SceneDescription& scene, std::span<const Id> shapes);
  void addCustom(const SceneDescription& scene, std::span<const Id> shapes);

  const LeafKernels* kernels_ = &leafKernels(Isa::Baseline);
  Clusters clusters_;
  std::vector<Bounds3> bounds_;
  Bounds3 total_;
};

}  // namespace steradian
