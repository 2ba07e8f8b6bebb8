#include "steradian/accel/embree_tree.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>

namespace steradian::embree {
namespace {

/// A node as Embree's builder makes it. A child is a pointer to a node, or a leaf: the number of a cluster, tagged by
/// bit 0.
struct Built {
  RTCBounds bounds[ClusterTree::kWidth];
  void* child[ClusterTree::kWidth];
  std::uint32_t count;
};

// NOLINTNEXTLINE(performance-no-int-to-ptr): the number of a leaf is handed to Embree as if it were a pointer.
void* leafOf(std::uint32_t cluster) { return reinterpret_cast<void*>((std::uintptr_t{cluster} << 1) | 1u); }
bool isLeaf(const void* node) { return (reinterpret_cast<std::uintptr_t>(node) & 1u) != 0; }
std::uint32_t clusterOf(const void* leaf) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(leaf) >> 1);
}

using NodeCount = std::atomic<std::size_t>;

void* createNode(RTCThreadLocalAllocator allocator, unsigned int count, void* nodes) {
  ++*static_cast<NodeCount*>(nodes);
  Built* node = new (rtcThreadLocalAlloc(allocator, sizeof(Built), alignof(Built))) Built;
  node->count = count;
  return node;
}
void setChildren(void* node, void** children, unsigned int count, void*) {
  std::copy_n(children, count, static_cast<Built*>(node)->child);
}
void setBounds(void* node, const RTCBounds** bounds, unsigned int count, void*) {
  for (unsigned int i = 0; i < count; ++i) static_cast<Built*>(node)->bounds[i] = *bounds[i];
}
void* createLeaf(RTCThreadLocalAllocator, const RTCBuildPrimitive* primitives, std::size_t, void*) {
  return leafOf(primitives->primID);
}

ClusterTree::Node emptyNode() {
  ClusterTree::Node node;
  for (std::uint32_t i = 0; i < ClusterTree::kWidth; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      node.side[0][axis][i] = kInfinity;
      node.side[1][axis][i] = -kInfinity;
    }
    node.child[i] = ClusterTree::kLeaf;
  }
  return node;
}

/// Appends `from` and all below it; returns its number.
std::uint32_t append(const Built& from, ClusterTree& tree) {
  const auto number = static_cast<std::uint32_t>(tree.nodes.size());
  tree.nodes.push_back(emptyNode());
  for (std::uint32_t i = 0; i < from.count; ++i) {
    const RTCBounds& b = from.bounds[i];
    const float sides[2][3] = {{b.lower_x, b.lower_y, b.lower_z}, {b.upper_x, b.upper_y, b.upper_z}};
    const std::uint32_t child = isLeaf(from.child[i]) ? clusterOf(from.child[i]) | ClusterTree::kLeaf
                                                      : append(*static_cast<const Built*>(from.child[i]), tree);
    ClusterTree::Node& node = tree.nodes[number];
    for (int side = 0; side < 2; ++side)
      for (int axis = 0; axis < 3; ++axis) node.side[side][axis][i] = sides[side][axis];
    node.child[i] = child;
  }
  return number;
}

}  // namespace

ClusterTree buildTree(const Device& device, std::span<const Bounds3> bounds, float padding) {
  if (bounds.size() < 2) return {};
  std::vector<RTCBuildPrimitive> primitives(bounds.size());
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const Bounds3& b = bounds[i];
    RTCBuildPrimitive& p = primitives[i];
    p.lower_x = b.low.x - padding;
    p.lower_y = b.low.y - padding;
    p.lower_z = b.low.z - padding;
    p.geomID = 0;
    p.upper_x = b.high.x + padding;
    p.upper_y = b.high.y + padding;
    p.upper_z = b.high.z + padding;
    p.primID = static_cast<unsigned int>(i);
  }
  const std::unique_ptr<RTCBVHTy, decltype(&rtcReleaseBVH)> bvh(rtcNewBVH(device.get()), rtcReleaseBVH);
  if (!bvh) device.check();
  RTCBuildArguments arguments = rtcDefaultBuildArguments();
  arguments.maxBranchingFactor = ClusterTree::kWidth;
  arguments.maxDepth = ClusterTree::kMaxDepth;
  arguments.maxLeafSize = 1;
  arguments.bvh = bvh.get();
  arguments.primitives = primitives.data();
  arguments.primitiveCount = primitives.size();
  arguments.primitiveArrayCapacity = primitives.size();
  arguments.createNode = createNode;
  arguments.setNodeChildren = setChildren;
  arguments.setNodeBounds = setBounds;
  arguments.createLeaf = createLeaf;
  NodeCount nodes = 0;
  arguments.userPtr = &nodes;
  const void* root = rtcBuildBVH(&arguments);
  device.check();
  ClusterTree tree;
  tree.nodes.reserve(nodes);
  if (root) append(*static_cast<const Built*>(root), tree);
  return tree;
}

}  // namespace steradian::embree
