#include "steradian/accel/geometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "steradian/accel/embree_scene.h"
#include "steradian/accel/embree_tree.h"
#include "steradian/accel/shapes/flat_primitives.h"
#include "steradian/accel/shapes/shape_at.h"
#include "steradian/accel/surface_point_of.h"

namespace steradian {
namespace {

/// The world, or one group: clusters with their hierarchy, and an Embree scene where there is more than clusters, or
/// where Embree places copies.
struct Hierarchy {
  std::vector<Id> meshes;  ///< shapes that are native triangles
  Bounds3 bounds;          ///< of its own shapes
  ClusterSet clusters;
  embree::ClusterGeometry forEmbree;
  /// Shapes that move: each has a hierarchy of its own, in the shape's space.
  struct Moving {
    Id shape;
    std::unique_ptr<Hierarchy> hierarchy;
  };
  std::vector<Moving> moving;
  embree::MovingGeometry copies;  ///< what moves through this one
  embree::Scene scene;

  bool isClustersAlone() const { return meshes.empty() && moving.empty(); }

  std::size_t bytes() const {
    std::size_t sum = clusters.bytes() + copies.items.capacity() * sizeof(copies.items[0]);
    for (const Moving& m : moving) sum += m.hierarchy->bytes();
    return sum;
  }
};

/// Of so many primitives points are computed for several rays at once: 80 bytes each.
constexpr std::size_t kMostFlat = 1u << 16;

/// Embree's non-robust box test, ours of nodes and the kernels differ in rounding; with bounds this much wider all that
/// may hold a hit is passed, also what is exactly as far as the nearest one.
float paddingFor(float magnitude) { return 4.0f * 0x1p-23f * magnitude; }

Vec3f cameraPosition(const CameraDescription& camera) {
  return std::visit([](const auto& c) { return c.lookFrom; }, camera);
}

bool areFinite(const Bounds3& b) {
  return isFinite(b.low.x + b.low.y + b.low.z) && isFinite(b.high.x + b.high.y + b.high.z);
}

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

struct Geometry::Implementation {
  std::shared_ptr<const SceneDescription> description;
  std::vector<Matrix> transforms, inverses;  ///< of instances; of those that move at time 0
  /// What shapes and instances move by; the numbers of theirs, or kNone. No numbers: none moves.
  std::vector<MovingTransform> motions;
  std::vector<std::uint32_t> motionOfShape, motionOfInstance;
  /// By shape: where a large set is in its clusters (see ClusterSet::placesOf); null for others.
  struct Places {
    const ClusterSet* clusters = nullptr;
    const std::uint32_t* of = nullptr;
  };
  std::vector<Places> places;
  Bounds3 bounds;
  GeometryStatistics statistics;
  Isa isa = Isa::Baseline;
  std::uint32_t mostWithoutTree = 0;
  bool dependsOnTime = false;
  bool hasNativeTriangles = false;
  // Destroyed in reverse order: scenes before their device.
  std::unique_ptr<embree::Device> device_;  ///< see device(); none if Embree has nothing left to do
  std::optional<FlatPrimitives> flat;       ///< see Geometry::flat
  std::vector<std::unique_ptr<Hierarchy>> groups;
  Hierarchy world;

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

  void findMotions();
  void gather(Hierarchy& hierarchy, std::span<const Id> shapes, bool clusterMeshes);
  /// The same without regard to how the shapes move.
  void gatherStill(Hierarchy& hierarchy, std::span<const Id> shapes, bool clusterMeshes);
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
  Bounds3 origins() const {
    Bounds3 all = bounds;
    all.include(cameraPosition(description->camera));
    return all;
  }
  embree::Device& device() {
    if (!device_) device_ = std::make_unique<embree::Device>();
    return *device_;
  }
  void buildHierarchies();
  /// What a hierarchy needs before its Embree scene; rays come from points whose coordinates are at most `magnitude`.
  void build(Hierarchy& hierarchy, float magnitude);
  /// All but instances; to be committed.
  void makeScene(Hierarchy& hierarchy, bool withClusters);
  void addCopy(Hierarchy& around, const MovingTransform& motion, const Hierarchy& of, std::uint32_t instance) const;
};

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
  for (const Id shape : clustered) {
    if (const std::uint32_t* of = hierarchy.clusters.placesOf(shape)) places[shape] = {&hierarchy.clusters, of};
  }
  hierarchy.bounds.include(hierarchy.clusters.bounds());
  statistics.clusters += hierarchy.clusters.size();
}

SurfacePoint<float> Geometry::Implementation::localPoint(const Ray<float>& ray, const Hit<float>& hit) const {
  const Places& place = places[hit.shape];
  if (place.of) return localSurfacePoint(place.clusters->leafShape(place.of[hit.primitive]), ray, hit);
  return localSurfacePoint(description->shapes[hit.shape], ray, hit);
}

SurfacePoint<float> Geometry::Implementation::groupPoint(const Ray<float>& ray, const Hit<float>& hit) const {
  const MovingTransform* motion = motionOf(motionOfShape, hit.shape);
  if (!motion) return localPoint(ray, hit);
  // As in the query, to the bit.
  const Matrix matrix = motion->at(ray.time), inverse = affineInverse(matrix);
  return transformed(localPoint(transformed(ray, inverse), hit), matrix, inverse);
}

SurfacePoint<float> Geometry::Implementation::worldPoint(const Ray<float>& ray, const Hit<float>& hit) const {
  if (hit.instance == kNone) return groupPoint(ray, hit);
  if (const MovingTransform* motion = motionOf(motionOfInstance, hit.instance)) {
    const Matrix matrix = motion->at(ray.time), inverse = affineInverse(matrix);
    return transformed(groupPoint(transformed(ray, inverse), hit), matrix, inverse);
  }
  const Matrix& inverse = inverses[hit.instance];
  return transformed(groupPoint(transformed(ray, inverse), hit), transforms[hit.instance], inverse);
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

std::string_view embreeVersion() { return embree::kVersion; }

Geometry::Geometry(std::shared_ptr<const SceneDescription> scene, GeometrySettings settings)
    : implementation_(std::make_unique<Implementation>()) {
  const auto start = std::chrono::steady_clock::now();
  Implementation& self = *implementation_;
  self.description = std::move(scene);
  requireUsable(settings.isa);
  self.isa = settings.isa;
  self.mostWithoutTree = settings.mostWithoutTree;
  const SceneDescription& description = *self.description;
  self.places.resize(description.shapes.size());
  std::vector<bool> grouped(description.shapes.size(), false);
  for (const Group& group : description.groups) {
    for (const Id shape : group.shapes) grouped[shape] = true;
  }
  std::vector<Id> placed;
  for (std::size_t i = 0; i < description.shapes.size(); ++i) {
    count(description.shapes[i].geometry, self.statistics);
    if (!grouped[i]) placed.push_back(static_cast<Id>(i));
  }
  self.findMotions();
  const bool clusterMeshes = self.statistics.triangles <= settings.clusteredTriangles;
  for (const Group& group : description.groups) {
    self.groups.push_back(std::make_unique<Hierarchy>());
    self.gather(*self.groups.back(), group.shapes, clusterMeshes);
  }
  self.gather(self.world, placed, clusterMeshes);
  self.placeInstances();
  self.buildHierarchies();
  if (self.transforms.empty() && self.motions.empty() && !self.hasNativeTriangles &&
      FlatPrimitives::holds(description, placed) && self.statistics.primitives() <= kMostFlat)
    self.flat.emplace(description, placed, self.mostWithoutTree > 0);
  self.statistics.bytes = self.world.bytes() + (self.device_ ? self.device_->bytes() : 0) +
                          (self.transforms.capacity() + self.inverses.capacity()) * sizeof(Matrix) +
                          self.motions.capacity() * sizeof(MovingTransform);
  for (const auto& group : self.groups) self.statistics.bytes += group->bytes();
  if (self.flat) self.statistics.bytes += self.flat->bytes();
  self.statistics.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Geometry::~Geometry() = default;
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;

Hit<float> Geometry::intersectUsable(const Ray<float>& ray) const {
  const Implementation& self = *implementation_;
  LeafHit best;
  self.world.clusters.nearest(ray, kNone, best);
  if (self.world.scene) {
    Ray<float> toBest = self.forEmbree(ray);
    if (best.found()) toBest.tMax = justBeyond(best.t);
    LeafHit other = embree::intersect(self.world.scene, toBest);
    if (other.instance != kNone) other.instance -= self.firstInstanceId();
    keepFirst(other, best);
  }
  if (!best.found()) return {};
  return {true, best.t, best.u, best.v, best.shape, best.primitive, best.instance};
}

bool Geometry::occludedUsable(const Ray<float>& ray) const {
  const Implementation& self = *implementation_;
  return self.world.clusters.any(ray) || (self.world.scene && embree::occluded(self.world.scene, self.forEmbree(ray)));
}

SurfacePoint<float> Geometry::surfacePoint(const Ray<float>& ray, const Hit<float>& hit) const {
  if (!hit.valid) return {};
  const Implementation& self = *implementation_;
  const ShapeDescription& shape = self.description->shapes[hit.shape];
  // Most scenes are at rest, and without instances.
  const bool local = hit.instance == kNone && self.motionOfShape.empty();
  SurfacePoint<float> point = local ? self.localPoint(ray, hit) : self.worldPoint(ray, hit);
  point.distance = hit.t;
  point.shape = hit.shape;
  point.primitive = hit.primitive;
  point.instance = hit.instance;
  point.material = shape.primitiveMaterials.empty() ? shape.material : shape.primitiveMaterials[hit.primitive];
  return point;
}

const FlatPrimitives* Geometry::flat() const { return implementation_->flat ? &*implementation_->flat : nullptr; }
Bounds3 Geometry::bounds() const { return implementation_->bounds; }
std::span<const Matrix> Geometry::instanceTransforms() const { return implementation_->transforms; }
bool Geometry::dependsOnTime() const { return implementation_->dependsOnTime; }
Isa Geometry::isa() const { return implementation_->isa; }
GeometryStatistics Geometry::statistics() const { return implementation_->statistics; }

}  // namespace steradian
