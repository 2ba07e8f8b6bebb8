#include "steradian/accel/embree_geometry.h"

#include <algorithm>
#include <chrono>

#include "steradian/accel/embree_tree.h"
#include "steradian/accel/shapes/primitives/shape_at.h"
#include "steradian/accel/surface_point_of.h"
#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

using embree::Hierarchy;

/// Embree's non-robust box test, ours of nodes and the kernels differ in rounding; with bounds this much wider all that
/// may hold a hit is passed, also what is exactly as far as the nearest one.
float paddingFor(float magnitude) { return 4.0f * 0x1p-23f * magnitude; }

Vec3f cameraPosition(const CameraDescription& camera) {
  return std::visit([](const auto& c) { return c.lookFrom; }, camera);
}

bool areFinite(const Bounds3& b) {
  return isFinite(b.low.x + b.low.y + b.low.z) && isFinite(b.high.x + b.high.y + b.high.z);
}

/// Records of so many primitives are kept: 80 bytes each.
constexpr std::size_t kMaxKeptRecords = 1u << 16;

Matrix inverseOf(const Matrix& matrix, const SourceRange& where) {
  const Matrix result = affineInverse(matrix);
  bool finite = true;
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) finite = finite && isFinite(result[i][j]) && isFinite(matrix[i][j]);
  }
  if (!finite) throw Error(ErrorKind::Scene, Diagnostic{Severity::Error, where, "the transform has no inverse", ""});
  return result;
}

void count(const ShapeGeometry& geometry, GeometryStatistics& statistics) {
  struct Visitor {
    GeometryStatistics& s;
    std::size_t& operator()(const SphereSet&) const { return s.spheres; }
    std::size_t& operator()(const QuadSet&) const { return s.quads; }
    std::size_t& operator()(const BoxSet&) const { return s.boxes; }
    std::size_t& operator()(const DiskSet&) const { return s.disks; }
    std::size_t& operator()(const TriangleMesh&) const { return s.triangles; }
    std::size_t& operator()(const CustomShapeSet&) const { return s.custom; }
  };
  std::visit(Visitor{statistics}, geometry) += primitiveCount(geometry);
}

}  // namespace

Geometry::Implementation::Implementation(std::shared_ptr<const SceneDescription> scene,
                                         const GeometrySettings& settings)
    : description(std::move(scene)), isa(settings.isa), mostWithoutTree(settings.mostWithoutTree) {
  const auto start = std::chrono::steady_clock::now();
  requireUsable(settings.isa);
  clustersOf.resize(description->shapes.size());
  std::vector<bool> grouped(description->shapes.size(), false);
  for (const Group& group : description->groups) {
    for (const Id shape : group.shapes) grouped[shape] = true;
  }
  std::vector<Id> placed;
  for (std::size_t i = 0; i < description->shapes.size(); ++i) {
    count(description->shapes[i].geometry, statistics);
    if (!grouped[i]) placed.push_back(static_cast<Id>(i));
  }
  findMotions();
  const bool clusterMeshes = statistics.triangles <= settings.clusteredTriangles;
  for (const Group& group : description->groups) {
    groups.push_back(std::make_unique<embree::Hierarchy>());
    gather(*groups.back(), group.shapes, clusterMeshes);
  }
  gather(world, placed, clusterMeshes);
  placeInstances();
  buildHierarchies();
  hasRecords = transforms.empty() && motions.empty() && !hasNativeTriangles && haveRecords(*description, placed);
  recordsKnowUv = steradian::recordsKnowUv(*description, placed);
  if (hasRecords && mostWithoutTree > 0 && FlatPrimitives::holds(*description, placed))
    flat.emplace(*description, placed);
  else if (hasRecords && statistics.primitives() <= kMaxKeptRecords)
    keepRecords();
  statistics.bytes = world.bytes() + (device_ ? device_->bytes() : 0) +
                     (transforms.capacity() + inverses.capacity()) * sizeof(Matrix) +
                     motions.capacity() * sizeof(MovingTransform) + keptRecords.capacity() * sizeof(PointRecord);
  for (const auto& group : groups) statistics.bytes += group->bytes();
  statistics.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Geometry::Implementation::findMotions() {
  for (std::size_t i = 0; i < description->shapes.size(); ++i) {
    const ShapeDescription& shape = description->shapes[i];
    if (!shape.motion) continue;
    for (const Matrix& key : {shape.motion->open, shape.motion->close}) inverseOf(key, shape.where);  // or an error
    addMotion(*shape.motion, motionOfShape, i);
  }
  if (!motionOfShape.empty()) motionOfShape.resize(description->shapes.size(), kNone);
  std::size_t flatIndex = 0;
  for (const InstanceSet& set : description->instances) {
    for (std::size_t i = 0; i < set.transforms.size(); ++i, ++flatIndex) {
      if (set.closing.empty() || set.closing[i] == set.transforms[i]) continue;
      inverseOf(set.closing[i], set.where);  // or an error
      addMotion({set.transforms[i], set.closing[i]}, motionOfInstance, flatIndex);
    }
  }
  if (!motionOfInstance.empty()) motionOfInstance.resize(flatIndex, kNone);
  dependsOnTime = !motions.empty() || std::any_of(description->shapes.begin(), description->shapes.end(), [](auto& s) {
    const auto* spheres = std::get_if<SphereSet>(&s.geometry);
    return std::holds_alternative<CustomShapeSet>(s.geometry) || (spheres && areMoving(*spheres));
  });
}

void Geometry::Implementation::gather(Hierarchy& hierarchy, std::span<const Id> shapes, bool clusterMeshes) {
  std::vector<Id> still;
  for (const Id shape : shapes) {
    const MovingTransform* motion = motionOf(motionOfShape, shape);
    if (!motion) {
      still.push_back(shape);
      continue;
    }
    hierarchy.moving.push_back({shape, std::make_unique<Hierarchy>()});
    Hierarchy& own = *hierarchy.moving.back().hierarchy;
    gatherStill(own, std::span(&shape, 1), clusterMeshes);
    hierarchy.bounds.include(motion->bounds(own.bounds));
  }
  gatherStill(hierarchy, still, clusterMeshes);
}

void Geometry::Implementation::gatherStill(Hierarchy& hierarchy, std::span<const Id> shapes, bool clusterMeshes) {
  std::vector<Id> clustered;
  for (const Id shape : shapes) {
    const ShapeDescription& s = description->shapes[shape];
    const auto* mesh = std::get_if<TriangleMesh>(&s.geometry);
    if (mesh && !clusterMeshes) {
      hierarchy.meshes.push_back(shape);
      hasNativeTriangles = true;
      for (const std::uint32_t i : mesh->indices) hierarchy.bounds.include(mesh->positions[i]);
    } else {
      clustered.push_back(shape);
    }
    if (const auto* custom = std::get_if<CustomShapeSet>(&s.geometry)) {
      for (const auto& implementation : custom->shapes) {
        if (areFinite(implementation->bounds())) continue;
        throw Error(ErrorKind::Scene,
                    Diagnostic{Severity::Error, s.where, "the bounds of a custom shape are not finite", ""});
      }
    }
  }
  hierarchy.clusters = ClusterSet(*description, clustered, isa);
  for (const Id shape : clustered) clustersOf[shape] = &hierarchy.clusters;
  hierarchy.bounds.include(hierarchy.clusters.bounds());
  statistics.clusters += hierarchy.clusters.size();
}

Bounds3 Geometry::Implementation::origins() const {
  Bounds3 all = bounds;
  all.include(cameraPosition(description->camera));
  return all;
}

void Geometry::Implementation::placeInstances() {
  bounds = world.bounds;
  for (const InstanceSet& set : description->instances) {
    for (const Matrix& matrix : set.transforms) {
      transforms.push_back(matrix);
      inverses.push_back(inverseOf(matrix, set.where));
      const MovingTransform* motion = motionOf(motionOfInstance, static_cast<std::uint32_t>(transforms.size() - 1));
      const Bounds3& local = groups[set.group]->bounds;
      bounds.include(motion ? motion->bounds(local) : transformedBounds(local, matrix));
    }
  }
  statistics.instances = transforms.size();
}

void Geometry::Implementation::addCopy(Hierarchy& around, const MovingTransform& motion, const Hierarchy& of,
                                       std::uint32_t instance) const {
  const bool alone = of.isClustersAlone();
  around.copies.items.push_back(
      {&motion, motion.bounds(of.bounds), alone ? &of.clusters : nullptr, alone ? nullptr : &of.scene, instance});
}

void Geometry::Implementation::build(Hierarchy& hierarchy, float magnitude) {
  const float padding = paddingFor(magnitude);
  if (hierarchy.clusters.size() > mostWithoutTree)
    hierarchy.clusters.setTree(embree::buildTree(device(), hierarchy.clusters.clusterBounds(), padding));
  hierarchy.clusters.dropBounds();
  hierarchy.forEmbree = {&hierarchy.clusters, padding};
  hierarchy.copies.padding = padding;
  for (const Hierarchy::Moving& moving : hierarchy.moving) {
    const MovingTransform& motion = *motionOf(motionOfShape, moving.shape);
    Hierarchy& own = *moving.hierarchy;
    build(own, motion.localMagnitude(magnitude));
    if (!own.isClustersAlone()) {
      makeScene(own, true);
      own.scene.commit();
    }
    addCopy(hierarchy, motion, own, kNone);
  }
}

void Geometry::Implementation::makeScene(Hierarchy& hierarchy, bool withClusters) {
  hierarchy.scene = embree::Scene(device(), !hierarchy.meshes.empty());
  if (withClusters && hierarchy.clusters.size() > 0)
    hierarchy.scene.attachClusters(device(), hierarchy.forEmbree, clustersId());
  for (const Id mesh : hierarchy.meshes)
    hierarchy.scene.attachTriangles(device(), std::get<TriangleMesh>(description->shapes[mesh].geometry), mesh);
  if (!hierarchy.copies.items.empty()) hierarchy.scene.attachMoving(device(), hierarchy.copies, movingId());
}

void Geometry::Implementation::buildHierarchies() {
  const Bounds3 origins = this->origins();
  const float magnitude = origins.magnitude();
  std::vector<float> magnitudes(groups.size(), 0.0f);
  std::uint32_t flatIndex = 0;
  for (const InstanceSet& set : description->instances) {
    for (std::size_t i = 0; i < set.transforms.size(); ++i, ++flatIndex) {
      const MovingTransform* motion = motionOf(motionOfInstance, flatIndex);
      const float inGroup =
          motion ? motion->localMagnitude(magnitude) : transformedBounds(origins, inverses[flatIndex]).magnitude();
      magnitudes[set.group] = maximum(magnitudes[set.group], inGroup);
    }
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Hierarchy& group = *groups[g];
    build(group, magnitudes[g]);
    makeScene(group, true);
    group.scene.commit();
  }
  build(world, magnitude);
  flatIndex = 0;
  for (const InstanceSet& set : description->instances) {
    for (std::size_t i = 0; i < set.transforms.size(); ++i, ++flatIndex) {
      const MovingTransform* motion = motionOf(motionOfInstance, flatIndex);
      if (motion) addCopy(world, *motion, *groups[set.group], firstInstanceId() + flatIndex);
    }
  }
  if (!world.isClustersAlone() || !transforms.empty()) {
    makeScene(world, false);
    flatIndex = 0;
    for (const InstanceSet& set : description->instances) {
      for (const Matrix& matrix : set.transforms) {
        const std::uint32_t index = flatIndex++;
        if (!motionOf(motionOfInstance, index))
          world.scene.attachInstance(device(), groups[set.group]->scene, matrix, firstInstanceId() + index);
      }
    }
    world.scene.commit();
  }
  if (!device_) return;
  device_->check();
  if (!world.scene && groups.empty()) device_ = nullptr;
}

void Geometry::Implementation::keepRecords() {
  for (std::uint32_t place = 0; place < world.clusters.size() * kClusterSize; ++place) {
    PointRecord& record = keptRecords.emplace_back(PointRecord{{}, 0, kNone, kNone, kNone});
    if (world.clusters.isUsed(place)) fillRecord(record, place);
  }
}

}  // namespace steradian
