#pragma once
/// One ray against clusters: the hot functions of ClusterSet, once per instruction set (core/base/isa.h).
#include <array>
#include <vector>

#include "steradian/accel/shapes/clusters/cluster.h"
#include "steradian/accel/shapes/clusters/cluster_tree.h"
#include "steradian/accel/shapes/clusters/leaf_kinds.h"
#include "steradian/core/base/isa.h"

namespace steradian {

/// Clusters of all kinds, numbered through: 0 to count() - 1.
struct STERADIAN_API Clusters {
  template <class Leaf>
  using Of = std::vector<Cluster<Leaf>>;

  LeafKinds::TupleOf<Of> kinds;
  std::array<std::uint32_t, LeafKinds::count> end{};  ///< one past the last cluster of each kind

  ClusterTree tree;  ///< over all clusters; empty: each is tested in turn

  std::uint32_t count() const { return end.back(); }
  /// Calls visit(cluster) for the cluster of this number.
  template <class Visit>
  void visit(std::uint32_t cluster, const Visit& visit) const {
    visitFrom<0>(cluster, visit);
  }

 private:
  template <std::size_t kind, class Visit>
  void visitFrom(std::uint32_t cluster, const Visit& visit) const {
    if constexpr (kind + 1 < LeafKinds::count) {
      if (cluster >= end[kind]) return visitFrom<kind + 1>(cluster, visit);
    }
    visit(std::get<kind>(kinds)[kind == 0 ? cluster : cluster - end[kind - 1]]);
  }
};

/// See ClusterSet for what they do.
struct STERADIAN_API LeafKernels {
  void (*intersect)(const Clusters&, const Ray<float>&, std::uint32_t instance, LeafHit& best);
  bool (*occluded)(const Clusters&, const Ray<float>&);
  void (*intersectOne)(const Clusters&, std::uint32_t cluster, const Ray<float>&, std::uint32_t instance,
                       LeafHit& best);
  bool (*occludedByOne)(const Clusters&, std::uint32_t cluster, const Ray<float>&);
};

/// `isa` must be usable.
STERADIAN_API const LeafKernels& leafKernels(Isa isa);

namespace baseline {
extern const LeafKernels leafKernels;
}
namespace avx2 {
extern const LeafKernels leafKernels;
}
namespace avx512 {
extern const LeafKernels leafKernels;
}

}  // namespace steradian
