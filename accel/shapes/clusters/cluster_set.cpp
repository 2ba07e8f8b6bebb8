#include "steradian/accel/shapes/clusters/cluster_set.h"

#include <algorithm>

#include "steradian/accel/shapes/clusters/cluster_partition.h"
#include "steradian/accel/shapes/primitives/shape_at.h"
#include "steradian/core/base/parallel.h"

namespace steradian {
namespace {

/// The set that holds primitives of a leaf kind, if the geometry is one, and its primitives in the leaf's form.
template <class Leaf>
struct SetOf;
/// A set of spheres moves as a whole or not at all.
const SphereSet* sphereSet(const ShapeGeometry& g, bool moving) {
  const SphereSet* set = std::get_if<SphereSet>(&g);
  return set && areMoving(*set) == moving ? set : nullptr;
}
template <>
struct SetOf<SphereLeaf> {
  static const SphereSet* of(const ShapeGeometry& g) { return sphereSet(g, false); }
  static Sphere<float> at(const SphereSet& set, std::size_t i) { return sphereAt(set, i); }
};
template <>
struct SetOf<MovingSphereLeaf> {
  static const SphereSet* of(const ShapeGeometry& g) { return sphereSet(g, true); }
  static MovingSphere<float> at(const SphereSet& set, std::size_t i) { return movingSphereAt(set, i); }
};
/// A set of quads is aligned as a whole or not at all.
const QuadSet* quadSet(const ShapeGeometry& g, bool aligned) {
  const QuadSet* set = std::get_if<QuadSet>(&g);
  return set && areAligned(*set) == aligned ? set : nullptr;
}
template <>
struct SetOf<QuadLeaf> {
  static const QuadSet* of(const ShapeGeometry& g) { return quadSet(g, false); }
  static Quad<float> at(const QuadSet& set, std::size_t i) { return quadAt(set, i); }
};
template <>
struct SetOf<AlignedQuadLeaf> {
  static const QuadSet* of(const ShapeGeometry& g) { return quadSet(g, true); }
  static AlignedQuad at(const QuadSet& set, std::size_t i) { return *AlignedQuad::of(quadAt(set, i)); }
};
template <>
struct SetOf<DiskLeaf> {
  static const DiskSet* of(const ShapeGeometry& g) { return std::get_if<DiskSet>(&g); }
  static Disk<float> at(const DiskSet& set, std::size_t i) { return diskAt(set, i); }
};
template <>
struct SetOf<TriangleLeaf> {
  static const TriangleMesh* of(const ShapeGeometry& g) { return std::get_if<TriangleMesh>(&g); }
  static Triangle<float> at(const TriangleMesh& set, std::size_t i) { return triangleAt(set, i); }
};

/// A set of boxes is upright as a whole or not at all.
const BoxSet* boxSet(const ShapeGeometry& g, bool upright) {
  const BoxSet* set = std::get_if<BoxSet>(&g);
  return set && areUpright(*set) == upright ? set : nullptr;
}
template <>
struct SetOf<UprightBoxLeaf> {
  static const BoxSet* of(const ShapeGeometry& g) { return boxSet(g, true); }
  static UprightBox<float> at(const BoxSet& set, std::size_t i) { return uprightBoxAt(set, i); }
};
template <>
struct SetOf<TurnedBoxLeaf> {
  static const BoxSet* of(const ShapeGeometry& g) { return boxSet(g, false); }
  static TurnedBox at(const BoxSet& set, std::size_t i) { return turnedBoxAt(set, i); }
};

/// The sets of one kind in a row: numbers their primitives 0, 1, 2, ...
template <class Leaf>
class Concatenation {
 public:
  using Set = std::remove_pointer_t<decltype(SetOf<Leaf>::of(std::declval<const ShapeGeometry&>()))>;
  struct Place {
    Set* set;
    std::uint32_t shape, primitive;
  };

  Concatenation(const SceneDescription& scene, std::span<const Id> shapes) {
    for (const Id shape : shapes) {
      const ShapeGeometry& geometry = scene.shapes[shape].geometry;
      if (Set* set = SetOf<Leaf>::of(geometry)) {
        parts_.push_back({count_, set, shape});
        count_ += static_cast<std::uint32_t>(primitiveCount(geometry));
      }
    }
  }
  std::uint32_t count() const { return count_; }
  Place place(std::uint32_t ordinal) const {
    const auto after = std::upper_bound(parts_.begin(), parts_.end(), ordinal,
                                        [](std::uint32_t o, const Part& part) { return o < part.first; });
    const Part& part = *(after - 1);
    return {part.set, part.shape, ordinal - part.first};
  }

 private:
  struct Part {
    std::uint32_t first;
    Set* set;
    Id shape;
  };
  std::vector<Part> parts_;
  std::uint32_t count_ = 0;
};

template <class Leaf>
typename Leaf::Shape leafOf(const Cluster<Leaf>& cluster, int lane) {
  return Leaf::get(cluster.row, lane);
}

}  // namespace

const LeafKernels& leafKernels(Isa isa) {
  if constexpr (STERADIAN_DISPATCH) {
    if (isa == Isa::Avx2) return avx2::leafKernels;
    if (isa == Isa::Avx512) return avx512::leafKernels;
  }
  return baseline::leafKernels;
}

ClusterSet::ClusterSet(const SceneDescription& scene, std::span<const Id> shapes, Isa isa)
    : kernels_(&leafKernels(isa)) {
  // By ascending id, whatever the order in a group: lanes of a cluster are ordered by id.
  std::vector<Id> sorted(shapes.begin(), shapes.end());
  std::sort(sorted.begin(), sorted.end());
  std::size_t kind = 0;
  const auto close = [&] { clusters_.end[kind++] = static_cast<std::uint32_t>(bounds_.size()); };
  add<QuadLeaf>(scene, sorted), close();
  add<AlignedQuadLeaf>(scene, sorted), close();
  add<UprightBoxLeaf>(scene, sorted), close();
  add<SphereLeaf>(scene, sorted), close();
  add<MovingSphereLeaf>(scene, sorted), close();
  add<TriangleLeaf>(scene, sorted), close();
  add<DiskLeaf>(scene, sorted), close();
  add<TurnedBoxLeaf>(scene, sorted), close();
  addCustom(scene, sorted), close();
  for (const Bounds3& bounds : bounds_) total_.include(bounds);
}

template <class Leaf>
void ClusterSet::add(const SceneDescription& scene, std::span<const Id> shapes) {
  const Concatenation<Leaf> all(scene, shapes);
  const auto boundsOfOrdinal = [&](std::uint32_t ordinal) {
    const auto place = all.place(ordinal);
    return boundsOf(SetOf<Leaf>::at(*place.set, place.primitive));
  };
  const ClusterPartition partition = partitionIntoClusters(all.count(), boundsOfOrdinal);
  auto& clusters = std::get<Clusters::Of<Leaf>>(clusters_.kinds);
  clusters.resize(partition.ranges.size());
  const std::size_t firstCluster = bounds_.size();
  bounds_.resize(firstCluster + clusters.size());
  parallelForRanges(clusters.size(), 256, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c != end; ++c) {
      const ClusterRange range = partition.ranges[c];
      for (std::uint32_t i = 0; i < range.count; ++i) {
        const auto place = all.place(partition.items[range.begin + i].ordinal);
        const typename Leaf::Shape value = SetOf<Leaf>::at(*place.set, place.primitive);
        clusters[c].put(static_cast<int>(i), value, place.shape, place.primitive);
        bounds_[firstCluster + c].include(boundsOf(value));
      }
    }
  });
}

void ClusterSet::addCustom(const SceneDescription& scene, std::span<const Id> shapes) {
  for (const Id shape : shapes) {
    const auto* set = std::get_if<CustomShapeSet>(&scene.shapes[shape].geometry);
    if (!set) continue;
    for (std::size_t i = 0; i < set->shapes.size(); ++i) {
      clusters_.custom.push_back({set->shapes[i].get(), shape, static_cast<std::uint32_t>(i)});
      bounds_.push_back(set->shapes[i]->bounds());
    }
  }
}

bool ClusterSet::isUsed(std::uint32_t place) const {
  bool used = false;
  clusters_.visit(place / kClusterSize,
                  [&](const auto& cluster) { used = cluster.shape[place % kClusterSize] != kNone; });
  return used;
}

LeafShape ClusterSet::leafShape(std::uint32_t place) const {
  const auto lane = static_cast<int>(place % kClusterSize);
  LeafShape shape;
  clusters_.visit(place / kClusterSize, [&](const auto& cluster) { shape = leafOf(cluster, lane); });
  return shape;
}

void ClusterSet::fillRecord(PointRecord& record, std::uint32_t place) const {
  const auto lane = static_cast<int>(place % kClusterSize);
  clusters_.visit(place / kClusterSize, [&](const auto& cluster) {
    steradian::fillRecord(record, leafOf(cluster, lane));
    record.shape = cluster.shape[lane];
    record.primitive = cluster.primitive[lane];
  });
}

std::size_t ClusterSet::bytes() const {
  const std::size_t clusters =
      std::apply([](const auto&... kind) { return ((kind.capacity() * sizeof(kind[0])) + ... + 0u); }, clusters_.kinds);
  return clusters + clusters_.custom.capacity() * sizeof(Clusters::Custom) +
         clusters_.tree.nodes.capacity() * sizeof(ClusterTree::Node) + bounds_.capacity() * sizeof(Bounds3);
}

}  // namespace steradian
