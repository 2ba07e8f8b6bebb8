#pragma once
/// The hierarchy of the world, of one group, or of one shape that moves.
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "steradian/accel/accel.h"
#include "steradian/accel/embree_scene.h"
#include "steradian/accel/shapes/clusters/cluster_builder.h"

namespace steradian::embree {

/// Which shapes a hierarchy holds, and the clusters of those that are in clusters.
struct HierarchyPlan {
  std::vector<Id> meshes;  ///< as Embree's native triangles
  std::vector<Id> custom;
  std::vector<Id> clustered;
  BuiltClusters built;  ///< of `clustered`
  Bounds3 bounds;       ///< of all, at all times
  /// Shapes that move: each has a hierarchy of its own, in the shape's space.
  struct Moving {
    Id shape;
    const MovingTransform* motion;
    std::unique_ptr<HierarchyPlan> plan;
  };
  std::vector<Moving> moving;
};

struct Hierarchy;

/// A placed group, for the hierarchy of the world.
struct Instance {
  const Hierarchy* group;
  const Matrix* localToWorld;
  const MovingTransform* motion;  ///< null: at rest
};

/// What all hierarchies of one scene are built with.
struct HierarchyContext {
  const SceneDescription& scene;
  const AccelPlan& plan;
  const AccelSettings& settings;
  Isa isa;
  DeviceOnDemand& device;

  // Geometry ids in Embree's scenes: shapes have their own.
  std::uint32_t clustersId() const { return static_cast<std::uint32_t>(scene.shapes.size()); }
  std::uint32_t customId() const { return clustersId() + 1; }
  std::uint32_t movingId() const { return clustersId() + 2; }
  std::uint32_t firstInstanceId() const { return clustersId() + 3; }
};

/// Clusters with their own hierarchy, and an Embree scene for everything else: native triangles, custom shapes, moving
/// copies, instances; also for the clusters where Embree instances or traverses them. It must not move in memory:
/// Embree's scene points into it.
struct Hierarchy {
  /// A group that may be instanced, or a shape that moves. Rays start at points whose coordinates in this space are at
  /// most `magnitude`.
  Hierarchy(const HierarchyContext& context, HierarchyPlan plan, float magnitude, bool isInstanced);
  /// The world. The instances' hierarchies must outlive this.
  Hierarchy(const HierarchyContext& context, HierarchyPlan plan, float magnitude, std::span<const Instance> instances);
  Hierarchy(const Hierarchy&) = delete;
  Hierarchy& operator=(const Hierarchy&) = delete;

  /// Nearest hit: updates `best`, with `instance` as the hit's instance. Not for the world, whose hits carry the ids of
  /// the instances inside of it.
  void intersect(const Ray<float>& ray, std::uint32_t instance, LeafHit& best, EmbreeCounts* counts) const;
  bool occluded(const Ray<float>& ray, EmbreeCounts* counts) const;

  /// Whether our own code traverses the clusters, apart from Embree's scene.
  bool walksClusters() const { return clusters.size() > 0 && (!clustersInScene || sceneIsClusters); }
  /// Whether Embree traverses its scene.
  bool queriesScene() const { return scene && !sceneIsClusters; }

  std::size_t bytes() const;
  /// Calls visit(hierarchy) for this hierarchy and those of the moving shapes in it.
  template <class Visit>
  void forEachHierarchy(const Visit& visit) const {
    visit(*this);
    for (const auto& own : moving) own->forEachHierarchy(visit);
  }

  ClusterSet clusters;
  std::vector<Id> clustered;   ///< the shapes in them
  std::size_t primitives = 0;  ///< of these
  ClusterGeometry clusterGeometry;
  CustomGeometry customGeometry;
  MovingGeometry movingGeometry;
  std::vector<std::unique_ptr<Hierarchy>> moving;
  bool clustersInScene = false;
  /// The scene holds the clusters as one primitive and nothing else: queries then traverse the clusters directly.
  bool sceneIsClusters = false;
  Bounds3 bounds;  ///< of all, at all times; without instances
  Scene scene;

 private:
  void build(const HierarchyContext& context, HierarchyPlan plan, float magnitude, bool isInstanced,
             std::span<const Instance> instances);
  Scene makeScene(const HierarchyContext& context, std::span<const Id> meshes, std::span<const Instance> instances);
};

}  // namespace steradian::embree
