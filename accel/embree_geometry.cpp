#include "steradian/accel/embree_geometry.h"

#include <algorithm>
#include <chrono>

#include "steradian/core/base/diagnostics.h"

namespace steradian {
namespace {

using embree::Hierarchy;
using embree::HierarchyPlan;

/// Records are kept for at most this many primitives: 80 bytes each.
constexpr std::size_t kMaxKeptRecords = 1u << 16;

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

Geometry::Implementation::Implementation(std::shared_ptr<const SceneDescription> scene,
                                         const GeometrySettings& settings)
    : description(std::move(scene)), isa(settings.isa) {
  const auto start = std::chrono::steady_clock::now();
  requireUsable(settings.isa);
  statistics.accel = planAccel(*description, settings.accel);
  sources.resize(description->shapes.size());
  for (const ShapeDescription& shape : description->shapes) count(shape.geometry, statistics);
  const Placements placements(*description);
  const std::span<const Id> placed = placements.directShapes();
  findMotions(placements);
  std::vector<HierarchyPlan> groupPlans;
  for (const Group& group : description->groups) groupPlans.push_back(planOf(group.shapes));
  HierarchyPlan worldPlan = planOf(placed);
  buildHierarchies(settings, std::move(groupPlans), std::move(worldPlan));
  if (statistics.accel.accel == Accel::Flat) {
    std::vector<Id> clustered;
    for (const Id shape : placed) {
      if (sources[shape].clusters && !motionOf(motionOfShape, shape)) clustered.push_back(shape);
    }
    if (!clustered.empty()) flat.emplace(*description, clustered);
  }
  keepRecords();
  statistics.bytes = world->bytes() + (device.made() ? device.made()->bytes() : 0) +
                     (transforms.capacity() + inverses.capacity()) * sizeof(Matrix) +
                     motions.capacity() * sizeof(MovingTransform) + keptRecords.capacity() * sizeof(PointRecord);
  for (const auto& group : groups) statistics.bytes += group->bytes();
  if (!world->scene && groups.empty()) device.release();
  statistics.buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Geometry::Implementation::addMotion(const Motion& motion, std::vector<std::uint32_t>& numbers, std::size_t i) {
  numbers.resize(std::max(numbers.size(), i + 1), kNone);
  numbers[i] = static_cast<std::uint32_t>(motions.size());
  motions.emplace_back(motion);
}

void Geometry::Implementation::findMotions(const Placements& placements) {
  for (std::size_t i = 0; i < description->shapes.size(); ++i) {
    const ShapeDescription& shape = description->shapes[i];
    if (!shape.motion) continue;
    for (const Matrix& key : {shape.motion->open, shape.motion->close}) inverseOf(key, shape.where);  // may throw
    addMotion(*shape.motion, motionOfShape, i);
  }
  if (!motionOfShape.empty()) motionOfShape.resize(description->shapes.size(), kNone);
  placeInstances(placements);
  dependsOnTime = !motions.empty() || std::any_of(description->shapes.begin(), description->shapes.end(), [](auto& s) {
    const auto* spheres = std::get_if<SphereSet>(&s.geometry);
    return std::holds_alternative<CustomShapeSet>(s.geometry) || (spheres && areMoving(*spheres));
  });
}

void Geometry::Implementation::placeInstances(const Placements& placements) {
  transforms.reserve(placements.instanceCount());
  inverses.reserve(placements.instanceCount());
  groupOf.reserve(placements.instanceCount());
  placements.forEachInstance([&](const InstancePlacement& instance) {
    transforms.push_back(instance.localToWorld());
    inverses.push_back(inverseOf(instance.localToWorld(), instance.where()));
    groupOf.push_back(instance.group());
    const std::optional<Motion> motion = instance.motion();
    if (!motion) return;
    inverseOf(motion->close, instance.where());  // or an error
    addMotion(*motion, motionOfInstance, instance.index);
  });
  if (!motionOfInstance.empty()) motionOfInstance.resize(transforms.size(), kNone);
  statistics.instances = transforms.size();
}

void Geometry::Implementation::addAtRest(Id id, HierarchyPlan& plan) {
  const ShapeDescription& shape = description->shapes[id];
  ShapeSource& source = sources[id];
  if (const auto* mesh = std::get_if<TriangleMesh>(&shape.geometry)) {
    if (!mesh->normals.empty() || !mesh->uvs.empty()) source.vertexData = mesh;
    allRecords = allRecords && mesh->normals.empty();
    recordsKnowUv = recordsKnowUv && mesh->uvs.empty();
    if (!statistics.accel.clusterMeshes) {
      plan.meshes.push_back(id);
      for (const std::uint32_t i : mesh->indices) plan.bounds.include(mesh->positions[i]);
      return;
    }
  }
  if (const auto* custom = std::get_if<CustomShapeSet>(&shape.geometry)) {
    source.isCustom = true;
    plan.custom.push_back(id);
    for (const auto& implementation : custom->shapes) {
      const Bounds3 own = implementation->bounds();
      plan.bounds.include(own);
      if (areFinite(own)) continue;
      throw Error(ErrorKind::Scene,
                  Diagnostic{Severity::Error, shape.where, "the bounds of a custom shape are not finite", ""});
    }
    return;
  }
  plan.clustered.push_back(id);
}

HierarchyPlan Geometry::Implementation::planOf(std::span<const Id> shapes) {
  HierarchyPlan plan;
  for (const Id shape : shapes) {
    const MovingTransform* motion = motionOf(motionOfShape, shape);
    if (!motion) {
      addAtRest(shape, plan);
      continue;
    }
    plan.moving.push_back({shape, motion, std::make_unique<HierarchyPlan>()});
    HierarchyPlan& own = *plan.moving.back().plan;
    addAtRest(shape, own);
    cluster(own);
    plan.bounds.include(motion->bounds(own.bounds));
  }
  cluster(plan);
  return plan;
}

void Geometry::Implementation::cluster(HierarchyPlan& plan) {
  plan.built = buildClusters(*description, plan.clustered);
  plan.bounds.include(plan.built.total);
  statistics.clusters += plan.built.clusters.count();
}

Bounds3 Geometry::Implementation::origins() const {
  Bounds3 all = bounds;
  all.include(cameraPosition(description->camera));
  return all;
}

void Geometry::Implementation::buildHierarchies(const GeometrySettings& settings, std::vector<HierarchyPlan> groupPlans,
                                                HierarchyPlan worldPlan) {
  bounds = worldPlan.bounds;
  for (std::uint32_t i = 0; i < groupOf.size(); ++i) {
    const MovingTransform* motion = motionOf(motionOfInstance, i);
    const Bounds3& local = groupPlans[groupOf[i]].bounds;
    bounds.include(motion ? motion->bounds(local) : transformedBounds(local, transforms[i]));
  }
  // How far from the origin rays start, in the world and in the space of each group.
  const Bounds3 origins = this->origins();
  const float magnitude = origins.magnitude();
  std::vector<float> magnitudes(groupPlans.size(), 0.0f);
  for (std::uint32_t i = 0; i < groupOf.size(); ++i) {
    const MovingTransform* motion = motionOf(motionOfInstance, i);
    const float inGroup =
        motion ? motion->localMagnitude(magnitude) : transformedBounds(origins, inverses[i]).magnitude();
    magnitudes[groupOf[i]] = maximum(magnitudes[groupOf[i]], inGroup);
  }
  const embree::HierarchyContext context{*description, statistics.accel, settings.accel, isa, device};
  firstInstanceId = context.firstInstanceId();
  for (std::size_t g = 0; g < groupPlans.size(); ++g) {
    groups.push_back(std::make_unique<Hierarchy>(context, std::move(groupPlans[g]), magnitudes[g], true));
    registerClusters(*groups.back());
  }
  std::vector<embree::Instance> instances;
  for (std::uint32_t i = 0; i < groupOf.size(); ++i)
    instances.push_back({groups[groupOf[i]].get(), &transforms[i], motionOf(motionOfInstance, i)});
  world = std::make_unique<Hierarchy>(context, std::move(worldPlan), magnitude, instances);
  registerClusters(*world);
  if (device.made()) device.made()->check();
}

void Geometry::Implementation::registerClusters(const Hierarchy& hierarchy) {
  hierarchy.forEachHierarchy([&](const Hierarchy& own) {
    for (const Id shape : own.clustered) {
      ShapeSource& source = sources[shape];
      source.isShared = source.isShared || source.clusters != nullptr;
      source.clusters = source.isShared ? nullptr : &own.clusters;
    }
  });
}

void Geometry::Implementation::keepRecords() {
  // Clusters of a hierarchy, or one shape: a mesh of Embree's own triangles, or what is shared between groups.
  struct Candidate {
    std::size_t primitives;
    const Hierarchy* hierarchy;
    Id shape;
  };
  std::vector<Candidate> candidates;
  const auto add = [&](const Hierarchy& own) {
    if (own.primitives > 0 && !(&own == world.get() && flat)) candidates.push_back({own.primitives, &own, kNone});
  };
  world->forEachHierarchy(add);
  if (!transforms.empty()) {
    for (const auto& group : groups) group->forEachHierarchy(add);
  }
  for (Id shape = 0; shape < sources.size(); ++shape) {
    if (!sources[shape].clusters && !sources[shape].isCustom)
      candidates.push_back({primitiveCount(description->shapes[shape].geometry), nullptr, shape});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.primitives < b.primitives; });
  std::size_t kept = 0;
  for (const Candidate& candidate : candidates) {
    kept += candidate.primitives;
    if (kept > kMaxKeptRecords) break;
    const auto first = static_cast<std::uint32_t>(keptRecords.size());
    if (candidate.hierarchy == nullptr) {
      sources[candidate.shape].firstRecord = first;
      for (std::uint32_t i = 0; i < candidate.primitives; ++i)
        fillRecord(keptRecords.emplace_back(), candidate.shape, i);
      continue;
    }
    const ClusterSet& clusters = candidate.hierarchy->clusters;
    for (const Id shape : candidate.hierarchy->clustered) {
      if (!sources[shape].isShared) sources[shape].firstRecord = first;
    }
    for (std::uint32_t place = 0; place < clusters.size() * kClusterSize; ++place) {
      PointRecord& record = keptRecords.emplace_back(PointRecord{{}, 0, kNone, kNone, kNone});
      if (!clusters.isUsed(place)) continue;
      clusters.fillRecord(record, place);
      record.material = materialOf(record.shape, record.primitive);
    }
  }
  allRecords = allRecords && !flat && !statistics.accel.needsEmbree();
}

void Geometry::Implementation::fillRecord(PointRecord& record, Id shape, std::uint32_t primitive) const {
  LeafKinds::forEach([&]<class Leaf>() {
    if (const auto* set = setOf<Leaf>(description->shapes[shape].geometry))
      steradian::fillRecord<Leaf>(record, Leaf::at(*set, primitive));
  });
  record.shape = shape;
  record.primitive = primitive;
  record.material = materialOf(shape, primitive);
}

bool Geometry::Implementation::fillRecord(PointRecord& record, const Hit<float>& hit) const {
  const ShapeSource& source = sources[hit.shape];
  if (source.isCustom) return false;
  if (!source.clusters) return fillRecord(record, hit.shape, hit.primitive), true;
  source.clusters->fillRecord(record, hit.place);
  record.material = materialOf(record.shape, record.primitive);
  return true;
}

}  // namespace steradian
