#include "steradian/accel/shapes/clusters/cluster_set.h"

namespace steradian {

bool ClusterSet::isUsed(std::uint32_t place) const {
  bool used = false;
  clusters_.visit(place / kClusterSize,
                  [&](const auto& cluster) { used = cluster.shape[place % kClusterSize] != kNone; });
  return used;
}

LeafShape ClusterSet::leafShape(std::uint32_t place) const {
  const auto lane = static_cast<int>(place % kClusterSize);
  LeafShape shape;
  clusters_.visit(place / kClusterSize,
                  [&]<class Leaf>(const Cluster<Leaf>& cluster) { shape = Leaf::get(cluster.row, lane); });
  return shape;
}

void ClusterSet::fillRecord(PointRecord& record, std::uint32_t place) const {
  const auto lane = static_cast<int>(place % kClusterSize);
  clusters_.visit(place / kClusterSize, [&]<class Leaf>(const Cluster<Leaf>& cluster) {
    steradian::fillRecord<Leaf>(record, Leaf::get(cluster.row, lane));
    record.shape = cluster.shape[lane];
    record.primitive = cluster.primitive[lane];
  });
}

std::size_t ClusterSet::bytes() const {
  const std::size_t clusters =
      std::apply([](const auto&... kind) { return ((kind.capacity() * sizeof(kind[0])) + ... + 0u); }, clusters_.kinds);
  return clusters + clusters_.tree.nodes.capacity() * sizeof(ClusterTree::Node);
}

}  // namespace steradian
