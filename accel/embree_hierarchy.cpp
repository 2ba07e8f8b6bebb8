#include "steradian/accel/embree_hierarchy.h"

#include "steradian/accel/embree_tree.h"

namespace steradian::embree {
namespace {

/// Embree's non-robust box test, our node test and the kernels round differently. With bounds padded by this much, no
/// test culls a box that contains a hit, not even one exactly as far as the nearest hit.
float paddingFor(float magnitude) { return 4.0f * 0x1p-23f * magnitude; }

}  // namespace

Hierarchy::Hierarchy(const HierarchyContext& context, HierarchyPlan plan, float magnitude, bool isInstanced) {
  build(context, std::move(plan), magnitude, isInstanced, {});
}

Hierarchy::Hierarchy(const HierarchyContext& context, HierarchyPlan plan, float magnitude,
                     std::span<const Instance> instances) {
  build(context, std::move(plan), magnitude, false, instances);
}

void Hierarchy::build(const HierarchyContext& context, HierarchyPlan plan, float magnitude, bool isInstanced,
                      std::span<const Instance> instances) {
  const float padding = paddingFor(magnitude);
  BuiltClusters& built = plan.built;
  const bool embreeTraverses = context.plan.accel == Accel::Embree;
  if (!embreeTraverses && built.clusters.count() > context.settings.maxClustersWithoutTree)
    built.clusters.tree = buildTree(context.device.get(), built.bounds, padding);
  clusters = ClusterSet(std::move(built.clusters), context.isa);
  clustered = std::move(plan.clustered);
  primitives = built.primitives;
  clustersInScene = clusters.size() > 0 && (embreeTraverses || isInstanced);
  if (embreeTraverses) clusterGeometry.bounds = std::move(built.bounds);
  clusterGeometry.clusters = &clusters;
  clusterGeometry.total = built.total;
  for (const Id id : plan.custom) {
    const auto& shapes = std::get<CustomShapeSet>(context.scene.shapes[id].geometry).shapes;
    for (std::size_t i = 0; i < shapes.size(); ++i)
      customGeometry.items.push_back({shapes[i].get(), id, static_cast<std::uint32_t>(i)});
  }
  for (HierarchyPlan::Moving& mover : plan.moving) {
    const Bounds3 sweep = mover.motion->bounds(mover.plan->bounds);
    moving.push_back(
        std::make_unique<Hierarchy>(context, std::move(*mover.plan), mover.motion->localMagnitude(magnitude), false));
    movingGeometry.items.push_back({mover.motion, sweep, moving.back().get(), kNone});
  }
  for (std::uint32_t i = 0; i < instances.size(); ++i) {
    const Instance& instance = instances[i];
    if (instance.motion == nullptr) continue;
    movingGeometry.items.push_back({instance.motion, instance.motion->bounds(instance.group->bounds), instance.group,
                                    context.firstInstanceId() + i});
  }
  clusterGeometry.padding = customGeometry.padding = movingGeometry.padding = padding;
  bounds = plan.bounds;
  const bool hasMore =
      !plan.meshes.empty() || !customGeometry.items.empty() || !movingGeometry.items.empty() || !instances.empty();
  if (!hasMore && !clustersInScene && !isInstanced) return;
  sceneIsClusters = !hasMore && clusterGeometry.bounds.empty();
  scene = makeScene(context, plan.meshes, instances);
  scene.commit();
  clusterGeometry.bounds.clear();
  clusterGeometry.bounds.shrink_to_fit();
}

Scene Hierarchy::makeScene(const HierarchyContext& context, std::span<const Id> meshes,
                           std::span<const Instance> instances) {
  const Device& device = context.device.get();
  Scene made(device, !meshes.empty());
  if (clustersInScene) made.attach(device, clusterGeometry, context.clustersId());
  for (const Id mesh : meshes)
    made.attachTriangles(device, std::get<TriangleMesh>(context.scene.shapes[mesh].geometry), mesh);
  if (!customGeometry.items.empty()) made.attach(device, customGeometry, context.customId());
  if (!movingGeometry.items.empty()) made.attach(device, movingGeometry, context.movingId());
  for (std::uint32_t i = 0; i < instances.size(); ++i) {
    if (instances[i].motion == nullptr)
      made.attachInstance(device, instances[i].group->scene, *instances[i].localToWorld, context.firstInstanceId() + i);
  }
  return made;
}

void Hierarchy::intersect(const Ray<float>& ray, std::uint32_t instance, LeafHit& best, EmbreeCounts* counts) const {
  if (walksClusters()) clusters.intersect(ray, instance, best);
  if (!queriesScene()) return;
  LeafHit hit = embree::intersect(scene, ray, counts);
  hit.instance = instance;
  keepFirst(hit, best);
}

bool Hierarchy::occluded(const Ray<float>& ray, EmbreeCounts* counts) const {
  return (walksClusters() && clusters.occluded(ray)) || (queriesScene() && embree::occluded(scene, ray, counts));
}

std::size_t Hierarchy::bytes() const {
  std::size_t sum = clusters.bytes() + customGeometry.items.capacity() * sizeof(customGeometry.items[0]) +
                    movingGeometry.items.capacity() * sizeof(movingGeometry.items[0]);
  for (const auto& own : moving) sum += own->bytes();
  return sum;
}

}  // namespace steradian::embree
