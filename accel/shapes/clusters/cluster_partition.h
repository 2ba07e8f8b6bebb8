#pragma once
/// Which primitives share a cluster.
#include <cstdint>
#include <functional>
#include <vector>

#include "steradian/core/math/bounds.h"

namespace STERADIAN_API steradian {

struct ClusterItem {
  Bounds3 bounds;         ///< of the primitive
  std::uint32_t ordinal;  ///< the caller's number of the primitive
};

/// Items [begin, begin + count) of the partition make a cluster.
struct ClusterRange {
  std::uint32_t begin, count;
};

struct ClusterPartition {
  std::vector<ClusterItem> items;  ///< by ascending ordinal within a range
  std::vector<ClusterRange> ranges;
};

/// Groups primitives 0 to count-1 so that neighbours share a cluster. Clusters are full but for the last few, whose
/// number does not grow with `count`, and those that lost an oversized primitive: one more than 4 times as large as the
/// rest of its cluster together gets a cluster of its own. Up to kClusterSize primitives always share one cluster:
/// testing all of them costs no more than testing the oversized one alone. `boundsOf(i)` is called by many threads, all
/// of the caller's arena. The result does not depend on their number.
ClusterPartition partitionIntoClusters(std::uint32_t count, const std::function<Bounds3(std::uint32_t)>& boundsOf);

}  // namespace steradian
