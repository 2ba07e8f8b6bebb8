#pragma once
/// Hierarchies that Embree builds and our code traverses.
#include <span>

#include "steradian/accel/embree_scene.h"
#include "steradian/accel/shapes/clusters/cluster_tree.h"
#include "steradian/core/math/bounds.h"

namespace steradian::embree {

/// A tree over clusters 0 to bounds.size()-1 by the surface-area heuristic; empty for fewer than two. Bounds in it are
/// `padding` wider on every side (scene units). Built by the threads of the caller's arena. Throws the device's errors.
ClusterTree buildTree(const Device& device, std::span<const Bounds3> bounds, float padding);

}  // namespace steradian::embree
