#pragma once
/// One ray against clusters: the hot functions of ClusterSet, once per instruction set (core/base/isa.h).
#include <array>
#include <tuple>
#include <vector>

#include "steradian/accel/shapes/clusters/cluster.h"
#include "steradian/accel/shapes/clusters/cluster_tree.h"
#include "steradian/core/base/isa.h"
#include "steradian/core/scene/custom_shape.h"

namespace steradian {

/// Clusters of all kinds, numbered through: 0 to end.back() - 1.
struct STERADIAN_API Clusters {
  /// A custom shape is a cluster of one.
  struct Custom {
    const CustomShape* implementation;
    std::uint32_t shape, primitive;
  };
  template <class Leaf>
  using Of = std::vector<Cluster<Leaf>>;

  std::tuple<Of<QuadLeaf>, Of<AlignedQuadLeaf>, Of<UprightBoxLeaf>, Of<SphereLeaf>, Of<MovingSphereLeaf>,
             Of<TriangleLeaf>, Of<DiskLeaf>, Of<TurnedBoxLeaf>>
      kinds;
  std::vector<Custom> custom;
  std::array<std::uint32_t, 9> end{};  ///< one past the last cluster of each kind, in order; custom shapes last

  ClusterTree tree;  ///< over all clusters; empty: a ray meets one after the other

  /// Calls visit(cluster) for the cluster of this number; false if it is a custom shape.
  template <class Visit>
  bool visit(std::uint32_t cluster, const Visit& visit) const {
    return visitFrom<0>(cluster, visit);
  }
  const Custom& customOf(std::uint32_t cluster) const { return custom[cluster - end[end.size() - 2]]; }

 private:
  template <std::size_t kind, class Visit>
  bool visitFrom(std::uint32_t cluster, const Visit& visit) const {
    if constexpr (kind == std::tuple_size_v<decltype(kinds)>) {
      return false;
    } else {
      if (cluster >= end[kind]) return visitFrom<kind + 1>(cluster, visit);
      visit(std::get<kind>(kinds)[kind == 0 ? cluster : cluster - end[kind - 1]]);
      return true;
    }
  }
};

/// See ClusterSet for what they do.
struct STERADIAN_API LeafKernels {
  void (*nearest)(const Clusters&, const Ray<float>&, std::uint32_t instance, LeafHit& best);
  bool (*any)(const Clusters&, const Ray<float>&);
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
