#pragma once
/// All clusters of one hierarchy, ready for rays: the shapes placed directly in a scene, or those of one group.
#include "steradian/accel/shapes/clusters/leaf_kernels.h"
#include "steradian/accel/shapes/clusters/point_record.h"
#include "steradian/core/base/isa.h"

namespace STERADIAN_API steradian {

/// Immutable. Queries go through the tree of the clusters if they have one, and otherwise over each in turn; hits are
/// the same either way.
class ClusterSet {
 public:
  /// No clusters.
  ClusterSet() = default;
  /// The tree's bounds must be wide enough for rounding. Queries run on the kernels of `isa`, which must be usable.
  ClusterSet(Clusters clusters, Isa isa) : kernels_(&leafKernels(isa)), clusters_(std::move(clusters)) {}

  /// Number of clusters.
  std::uint32_t size() const { return clusters_.count(); }
  bool hasTree() const { return !clusters_.tree.nodes.empty(); }
  /// Memory that the set holds.
  std::size_t bytes() const;

  /// Whether there is a primitive at a place from 0 to size() * kClusterSize - 1.
  bool isUsed(std::uint32_t place) const;
  /// The primitive at LeafHit::place, read from its cluster: after a hit that is in the processor's cache, while the
  /// arrays of the description are not.
  LeafShape leafShape(std::uint32_t place) const;
  /// Fills in all but the material.
  void fillRecord(PointRecord& record, std::uint32_t place) const;

  /// Nearest hit with tMin < t < tMax: updates `best` where it is nearer, or equally near with a smaller id.
  /// `instance`: the one that holds the clusters, or kNone.
  void intersect(const Ray<float>& ray, std::uint32_t instance, LeafHit& best) const {
    kernels_->intersect(clusters_, ray, instance, best);
  }
  /// Is anything hit between tMin and tMax?
  bool occluded(const Ray<float>& ray) const { return kernels_->occluded(clusters_, ray); }

  /// The same for a single cluster, when Embree traverses the hierarchy.
  void intersectOne(std::uint32_t cluster, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) const {
    kernels_->intersectOne(clusters_, cluster, ray, instance, best);
  }
  bool occludedByOne(std::uint32_t cluster, const Ray<float>& ray) const {
    return kernels_->occludedByOne(clusters_, cluster, ray);
  }

 private:
  const LeafKernels* kernels_ = &leafKernels(Isa::Baseline);
  Clusters clusters_;
};

}  // namespace steradian
