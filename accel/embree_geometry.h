#pragma once
/// What a Geometry consists of: built by embree_geometry.cpp, queried by geometry.cpp.
#include <memory>
#include <optional>
#include <vector>

#include "steradian/accel/embree_hierarchy.h"
#include "steradian/accel/geometry.h"
#include "steradian/accel/shapes/clusters/flat_primitives.h"
#include "steradian/core/scene/placements.h"

namespace steradian {

struct Geometry::Implementation {
  Implementation(std::shared_ptr<const SceneDescription> scene, const GeometrySettings& settings);

  std::shared_ptr<const SceneDescription> description;
  std::vector<Matrix> transforms, inverses;  ///< of instances; of those that move at time 0
  std::vector<Id> groupOf;                   ///< of instances
  /// The motions of shapes and instances; by shape and by instance the index of its motion, or kNone. Empty: none
  /// moves.
  std::vector<MovingTransform> motions;
  std::vector<std::uint32_t> motionOfShape, motionOfInstance;
  /// What surface points on a shape are computed from.
  struct ShapeSource {
    /// The clusters that it is in; null for native triangles, custom shapes, and shapes in the clusters of several
    /// groups, where Hit::place does not say which.
    const ClusterSet* clusters = nullptr;
    std::uint32_t firstRecord = kNone;  ///< the kept record of place 0 of its clusters, or of its first primitive
    bool isCustom = false, isShared = false;
    const TriangleMesh* vertexData = nullptr;  ///< a mesh with normals or uv of its own
  };
  std::vector<ShapeSource> sources;
  Bounds3 bounds;
  GeometryStatistics statistics;
  Isa isa = Isa::Baseline;
  bool dependsOnTime = false;
  bool allRecords = true, recordsKnowUv = true;  ///< see Geometry::recordsByPlace
  std::vector<PointRecord> keptRecords;
  // Destroyed in reverse order: scenes before their device.
  embree::DeviceOnDemand device;       ///< none if Embree is not needed
  std::optional<FlatPrimitives> flat;  ///< see Geometry::flat
  std::vector<std::unique_ptr<embree::Hierarchy>> groups;
  std::unique_ptr<embree::Hierarchy> world;
  std::uint32_t firstInstanceId = 0;  ///< of Embree's geometries

  /// Null if the shape, or the instance, does not move.
  const MovingTransform* motionOf(const std::vector<std::uint32_t>& numbers, std::uint32_t i) const {
    return numbers.empty() || numbers[i] == kNone ? nullptr : &motions[numbers[i]];
  }
  Id materialOf(std::uint32_t shape, std::uint32_t primitive) const {
    const ShapeDescription& s = description->shapes[shape];
    return s.primitiveMaterials.empty() ? s.material : s.primitiveMaterials[primitive];
  }
  bool fillRecord(PointRecord& record, const Hit<float>& hit) const;
  std::uint32_t keptRecord(const Hit<float>& hit) const {
    const ShapeSource& source = sources[hit.shape];
    return source.firstRecord == kNone ? kNone : source.firstRecord + (source.clusters ? hit.place : hit.primitive);
  }
  /// The surface point in the space of the shape, of the group, of the world.
  SurfacePoint<float> localPoint(const Ray<float>& ray, const Hit<float>& hit) const;
  SurfacePoint<float> groupPoint(const Ray<float>& ray, const Hit<float>& hit) const;
  SurfacePoint<float> worldPoint(const Ray<float>& ray, const Hit<float>& hit) const;
  /// Embree accepts a triangle at t = tMin, up to its rounding: a ray that continues behind a triangle would hit it
  /// again.
  Ray<float> forEmbree(Ray<float> ray) const {
    if (statistics.accel.triangles > 0) ray.tMin *= 1.0f + 0x1p-20f;
    return ray;
  }
  /// The nearest hit in the Embree scene of the world, if it is nearer than `best`.
  void intersectScene(const Ray<float>& ray, LeafHit& best, EmbreeCounts* counts) const;

 private:
  void findMotions(const Placements& placements);
  void addMotion(const Motion& motion, std::vector<std::uint32_t>& numbers, std::size_t i);
  void placeInstances(const Placements& placements);
  /// Which shapes are in a hierarchy, and how.
  embree::HierarchyPlan planOf(std::span<const Id> shapes);
  void addAtRest(Id shape, embree::HierarchyPlan& plan);
  void cluster(embree::HierarchyPlan& plan);
  /// Bounds of all points that rays start from: the camera and the surfaces.
  Bounds3 origins() const;
  void buildHierarchies(const GeometrySettings& settings, std::vector<embree::HierarchyPlan> groupPlans,
                        embree::HierarchyPlan worldPlan);
  void registerClusters(const embree::Hierarchy& hierarchy);
  /// From the description.
  void fillRecord(PointRecord& record, Id shape, std::uint32_t primitive) const;
  /// Keeps records, of the smallest sets first, up to the limit.
  void keepRecords();
};

}  // namespace steradian
