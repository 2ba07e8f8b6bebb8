#pragma once
/// What a Geometry is made of: built by embree_geometry.cpp, asked by geometry.cpp.
#include <memory>
#include <optional>
#include <vector>

#include "steradian/accel/embree_scene.h"
#include "steradian/accel/geometry.h"
#include "steradian/accel/shapes/clusters/flat_primitives.h"

namespace steradian {

namespace embree {

/// The world, or one group: clusters with their hierarchy, and an Embree scene where there is more than clusters, or
/// where Embree places copies.
struct Hierarchy {
  std::vector<Id> meshes;  ///< shapes that are native triangles
  Bounds3 bounds;          ///< of its own shapes
  ClusterSet clusters;
  ClusterGeometry forEmbree;
  /// Shapes that move: each has a hierarchy of its own, in the shape's space.
  struct Moving {
    Id shape;
    std::unique_ptr<Hierarchy> hierarchy;
  };
  std::vector<Moving> moving;
  MovingGeometry copies;  ///< what moves through this one
  Scene scene;

  bool isClustersAlone() const { return meshes.empty() && moving.empty(); }

  std::size_t bytes() const {
    std::size_t sum = clusters.bytes() + copies.items.capacity() * sizeof(copies.items[0]);
    for (const Moving& m : moving) sum += m.hierarchy->bytes();
    return sum;
  }
};

}  // namespace embree

struct Geometry::Implementation {
  Implementation(std::shared_ptr<const SceneDescription> scene, const GeometrySettings& settings);

  std::shared_ptr<const SceneDescription> description;
  std::vector<Matrix> transforms, inverses;  ///< of instances; of those that move at time 0
  /// What shapes and instances move by; the numbers of theirs, or kNone. No numbers: none moves.
  std::vector<MovingTransform> motions;
  std::vector<std::uint32_t> motionOfShape, motionOfInstance;
  /// By shape: the clusters that it is in; null for native triangles.
  std::vector<const ClusterSet*> clustersOf;
  Bounds3 bounds;
  GeometryStatistics statistics;
  Isa isa = Isa::Baseline;
  std::uint32_t mostWithoutTree = 0;
  bool dependsOnTime = false;
  bool hasNativeTriangles = false;
  bool hasRecords = false, recordsKnowUv = false;  ///< see Geometry::hasRecords
  std::vector<PointRecord> keptRecords;
  // Destroyed in reverse order: scenes before their device.
  std::unique_ptr<embree::Device> device_;  ///< see device(); none if Embree has nothing left to do
  std::optional<FlatPrimitives> flat;       ///< see Geometry::flat
  std::vector<std::unique_ptr<embree::Hierarchy>> groups;
  embree::Hierarchy world;

  std::uint32_t clustersId() const { return static_cast<std::uint32_t>(description->shapes.size()); }
  std::uint32_t movingId() const { return clustersId() + 1; }
  std::uint32_t firstInstanceId() const { return clustersId() + 2; }

  /// Null if the shape, or the instance, does not move.
  const MovingTransform* motionOf(const std::vector<std::uint32_t>& numbers, std::uint32_t i) const {
    return numbers.empty() || numbers[i] == kNone ? nullptr : &motions[numbers[i]];
  }
  void addMotion(const Motion& motion, std::vector<std::uint32_t>& numbers, std::size_t i) {
    numbers.resize(std::max(numbers.size(), i + 1), kNone);
    numbers[i] = static_cast<std::uint32_t>(motions.size());
    motions.emplace_back(motion);
  }

  Id materialOf(std::uint32_t shape, std::uint32_t primitive) const {
    const ShapeDescription& s = description->shapes[shape];
    return s.primitiveMaterials.empty() ? s.material : s.primitiveMaterials[primitive];
  }
  void fillRecord(PointRecord& record, std::uint32_t place) const {
    world.clusters.fillRecord(record, place);
    record.material = materialOf(record.shape, record.primitive);
  }
  void keepRecords();
  void findMotions();
  void gather(embree::Hierarchy& hierarchy, std::span<const Id> shapes, bool clusterMeshes);
  /// The same without regard to how the shapes move.
  void gatherStill(embree::Hierarchy& hierarchy, std::span<const Id> shapes, bool clusterMeshes);
  /// The point in the space of the shape, of the group, of the world.
  SurfacePoint<float> localPoint(const Ray<float>& ray, const Hit<float>& hit) const;
  SurfacePoint<float> groupPoint(const Ray<float>& ray, const Hit<float>& hit) const;
  SurfacePoint<float> worldPoint(const Ray<float>& ray, const Hit<float>& hit) const;
  /// Embree takes triangles at tMin itself, give or take its rounding: a ray that goes on behind one would meet it
  /// again.
  Ray<float> forEmbree(Ray<float> ray) const {
    if (hasNativeTriangles) ray.tMin *= 1.0f + 0x1p-20f;
    return ray;
  }
  void placeInstances();
  /// Whatever rays start from: the camera, and the surfaces.
  Bounds3 origins() const;
  embree::Device& device() {
    if (!device_) device_ = std::make_unique<embree::Device>();
    return *device_;
  }
  void buildHierarchies();
  /// What a hierarchy needs before its Embree scene; rays come from points whose coordinates are at most `magnitude`.
  void build(embree::Hierarchy& hierarchy, float magnitude);
  /// All but instances; to be committed.
  void makeScene(embree::Hierarchy& hierarchy, bool withClusters);
  void addCopy(embree::Hierarchy& around, const MovingTransform& motion, const embree::Hierarchy& of,
               std::uint32_t instance) const;
};

}  // namespace steradian
