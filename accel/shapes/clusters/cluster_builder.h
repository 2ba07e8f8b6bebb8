#pragma once
/// From the shapes of a description to clusters.
#include <span>
#include <vector>

#include "steradian/accel/shapes/clusters/leaf_kernels.h"
#include "steradian/core/base/api.h"
#include "steradian/core/math/bounds.h"

namespace STERADIAN_API steradian {

struct BuiltClusters {
  Clusters clusters;            ///< without a tree
  std::vector<Bounds3> bounds;  ///< of each cluster
  Bounds3 total;                ///< of all
  std::size_t primitives = 0;
};

/// Clusters of these shapes, which are no custom ones; neighbours share a cluster (cluster_partition.h). Built by the
/// threads of the caller's arena; the result does not depend on their number. Nothing of the description is kept.
BuiltClusters buildClusters(const SceneDescription& scene, std::span<const Id> shapes);

}  // namespace steradian
