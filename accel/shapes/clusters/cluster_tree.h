#pragma once
/// An eight-wide bounding volume hierarchy over clusters: a ray is tested against eight bounds at once.
#include <cstdint>
#include <vector>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

struct ClusterTree {
  static constexpr std::uint32_t kWidth = 8;
  /// The largest number of nodes above a leaf.
  static constexpr std::uint32_t kMaxDepth = 48;
  /// Set in the children that are leaves.
  static constexpr std::uint32_t kLeaf = 0x80000000u;

  struct alignas(64) Node {
    float side[2][3][kWidth];     ///< low and high, by axis, of each child; unused children: bounds no ray hits
    std::uint32_t child[kWidth];  ///< number of a node, or of a cluster and kLeaf
  };
  std::vector<Node> nodes;  ///< the root first; empty: no hierarchy
};

}  // namespace steradian
