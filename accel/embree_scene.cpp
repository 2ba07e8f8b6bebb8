#include "steradian/accel/embree_scene.h"

#include <fmt/format.h>

#include <cstring>

#include "steradian/accel/embree_hierarchy.h"
#include "steradian/accel/transformed_point.h"
#include "steradian/core/base/diagnostics.h"

namespace steradian::embree {
namespace {

ErrorKind kindOf(RTCError error) { return error == RTC_ERROR_OUT_OF_MEMORY ? ErrorKind::Memory : ErrorKind::Other; }

RTCRay toEmbree(const Ray<float>& ray) {
  RTCRay r;
  r.org_x = ray.origin.x;
  r.org_y = ray.origin.y;
  r.org_z = ray.origin.z;
  r.tnear = ray.tMin;
  r.dir_x = ray.direction.x;
  r.dir_y = ray.direction.y;
  r.dir_z = ray.direction.z;
  r.time = ray.time;
  r.tfar = ray.tMax;
  r.mask = 0xffffffffu;
  r.id = 0;
  r.flags = 0;
  return r;
}

Ray<float> fromEmbree(const RTCRay& r) {
  return {{r.org_x, r.org_y, r.org_z}, {r.dir_x, r.dir_y, r.dir_z}, r.tfar, r.time, r.tnear};
}

void storeBounds(const Bounds3& b, float padding, RTCBounds& out) {
  out.lower_x = b.low.x - padding;
  out.lower_y = b.low.y - padding;
  out.lower_z = b.low.z - padding;
  out.upper_x = b.high.x + padding;
  out.upper_y = b.high.y + padding;
  out.upper_z = b.high.z + padding;
}

LeafHit leafHit(const RTCRayHit& rayHit) {
  const RTCHit& hit = rayHit.hit;
  if (hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {rayHit.ray.tfar, hit.u, hit.v, hit.geomID, hit.primID, hit.instID[0], bitsOf(hit.Ng_x)};
}

/// Calls intersect(ray, instance, best) for Embree's ray and nearest hit so far. Returns whether there is a better one,
/// which is then in rayHit.
template <class Intersect>
bool updateHit(RTCRayHit& rayHit, std::uint32_t instance, const Intersect& intersect) {
  Ray<float> ray = fromEmbree(rayHit.ray);
  LeafHit best = leafHit(rayHit);
  if (best.found()) ray.tMax = justBeyond(ray.tMax);  // hits at the same distance compete by their ids
  const LeafHit before = best;
  intersect(ray, instance, best);
  if (best.t == before.t && best.shape == before.shape && best.primitive == before.primitive &&
      best.instance == before.instance) {
    return false;
  }
  rayHit.ray.tfar = best.t;
  RTCHit& hit = rayHit.hit;
  hit.u = best.u;
  hit.v = best.v;
  hit.geomID = best.shape;
  hit.primID = best.primitive;
  hit.instID[0] = best.instance;
  hit.Ng_x = floatOf(best.place);  // the normal of user geometry is not used
  return true;
}

/// The same for all rays of a callback: one, or those of a packet.
template <class Intersect>
void updateHits(const RTCIntersectFunctionNArguments* args, const Intersect& intersect) {
  const std::uint32_t instance = args->context->instID[0];
  if (args->N == 1) {  // RTCRayHitN of one ray has the layout of RTCRayHit
    if (args->valid[0]) updateHit(*reinterpret_cast<RTCRayHit*>(args->rayhit), instance, intersect);
    return;
  }
  for (unsigned int i = 0; i < args->N; ++i) {
    if (!args->valid[i]) continue;
    RTCRayHit one = rtcGetRayHitFromRayHitN(args->rayhit, args->N, i);
    if (!updateHit(one, instance, intersect)) continue;
    RTCRayN_tfar(RTCRayHitN_RayN(args->rayhit, args->N), args->N, i) = one.ray.tfar;
    rtcCopyHitToHitN(RTCRayHitN_HitN(args->rayhit, args->N), &one.hit, args->N, i);
  }
}

/// Marks Embree's ray as occluded if occluded(ray) is true. Occlusion queries are of single rays.
template <class Occluded>
void updateOcclusion(const RTCOccludedFunctionNArguments* args, const Occluded& occluded) {
  if (!args->valid[0]) return;
  RTCRay& ray = *reinterpret_cast<RTCRay*>(args->ray);
  if (occluded(fromEmbree(ray))) ray.tfar = -kInfinity;
}

// --- Clusters

void boundsOfClusters(const RTCBoundsFunctionArguments* args) {
  const auto& geometry = *static_cast<const ClusterGeometry*>(args->geometryUserPtr);
  storeBounds(geometry.total, geometry.padding, *args->bounds_o);
}
void intersectClusters(const RTCIntersectFunctionNArguments* args) {
  const auto& geometry = *static_cast<const ClusterGeometry*>(args->geometryUserPtr);
  countCallback(args);
  updateHits(args, [&](const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
    geometry.clusters->intersect(ray, instance, best);
  });
}
void occludedByClusters(const RTCOccludedFunctionNArguments* args) {
  const auto& geometry = *static_cast<const ClusterGeometry*>(args->geometryUserPtr);
  countCallback(args);
  updateOcclusion(args, [&](const Ray<float>& ray) { return geometry.clusters->occluded(ray); });
}

void boundsOfOneCluster(const RTCBoundsFunctionArguments* args) {
  const auto& geometry = *static_cast<const ClusterGeometry*>(args->geometryUserPtr);
  storeBounds(geometry.bounds[args->primID], geometry.padding, *args->bounds_o);
}
void intersectOneCluster(const RTCIntersectFunctionNArguments* args) {
  const auto& geometry = *static_cast<const ClusterGeometry*>(args->geometryUserPtr);
  countCallback(args);
  updateHits(args, [&](const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
    geometry.clusters->intersectOne(args->primID, ray, instance, best);
  });
}
void occludedByOneCluster(const RTCOccludedFunctionNArguments* args) {
  const auto& geometry = *static_cast<const ClusterGeometry*>(args->geometryUserPtr);
  countCallback(args);
  updateOcclusion(args, [&](const Ray<float>& ray) { return geometry.clusters->occludedByOne(args->primID, ray); });
}

// --- Custom shapes

void intersectShape(const CustomGeometry::Item& item, const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
  const auto hit = item.implementation->intersect(ray);
  // User code: its hits may break the contract.
  if (!hit || !(hit->t > ray.tMin && hit->t < ray.tMax)) return;
  keepFirst({hit->t, hit->uv.x, hit->uv.y, item.shape, item.primitive, instance, kNone}, best);
}

void boundsOfCustom(const RTCBoundsFunctionArguments* args) {
  const auto& geometry = *static_cast<const CustomGeometry*>(args->geometryUserPtr);
  storeBounds(geometry.items[args->primID].implementation->bounds(), geometry.padding, *args->bounds_o);
}
void intersectCustom(const RTCIntersectFunctionNArguments* args) {
  const auto& geometry = *static_cast<const CustomGeometry*>(args->geometryUserPtr);
  countCallback(args);
  updateHits(args, [&](const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
    intersectShape(geometry.items[args->primID], ray, instance, best);
  });
}
void occludedByCustom(const RTCOccludedFunctionNArguments* args) {
  const auto& geometry = *static_cast<const CustomGeometry*>(args->geometryUserPtr);
  countCallback(args);
  updateOcclusion(args, [&](const Ray<float>& ray) {
    LeafHit hit;
    intersectShape(geometry.items[args->primID], ray, kNone, hit);
    return hit.found();
  });
}

// --- Moving copies

Ray<float> localRay(const MovingGeometry::Item& item, const Ray<float>& ray) {
  return transformed(ray, affineInverse(item.localToWorld->at(ray.time)));
}

void boundsOfMoving(const RTCBoundsFunctionArguments* args) {
  const auto& geometry = *static_cast<const MovingGeometry*>(args->geometryUserPtr);
  storeBounds(geometry.items[args->primID].bounds, geometry.padding, *args->bounds_o);
}
void intersectMoving(const RTCIntersectFunctionNArguments* args) {
  const MovingGeometry::Item& item = static_cast<const MovingGeometry*>(args->geometryUserPtr)->items[args->primID];
  EmbreeCounts* counts = countCallback(args);
  updateHits(args, [&](const Ray<float>& ray, std::uint32_t around, LeafHit& best) {
    item.of->intersect(localRay(item, ray), item.instance != kNone ? item.instance : around, best, counts);
  });
}
void occludedByMoving(const RTCOccludedFunctionNArguments* args) {
  const MovingGeometry::Item& item = static_cast<const MovingGeometry*>(args->geometryUserPtr)->items[args->primID];
  EmbreeCounts* counts = countCallback(args);
  updateOcclusion(args, [&](const Ray<float>& ray) { return item.of->occluded(localRay(item, ray), counts); });
}

/// A geometry under construction; the scene keeps it alive once attached.
class NewGeometry {
 public:
  NewGeometry(const Device& device, RTCGeometryType type) : geometry_(rtcNewGeometry(device.get(), type)) {
    if (!geometry_) device.check();
  }
  ~NewGeometry() { rtcReleaseGeometry(geometry_); }
  NewGeometry(const NewGeometry&) = delete;
  NewGeometry& operator=(const NewGeometry&) = delete;

  RTCGeometry get() const { return geometry_; }
  void attach(RTCScene scene, std::uint32_t id) {
    rtcCommitGeometry(geometry_);
    rtcAttachGeometryByID(scene, geometry_, id);
  }

 private:
  RTCGeometry geometry_;
};

}  // namespace

Device::Device() : device_(rtcNewDevice(nullptr)) {
  if (!device_) {
    const RTCError error = rtcGetDeviceError(nullptr);
    throw Error(kindOf(error), fmt::format("Embree does not start (its error {})", static_cast<int>(error)));
  }
  rtcSetDeviceErrorFunction(
      device_,
      [](void* self, RTCError error, const char* text) {
        auto& device = *static_cast<Device*>(self);
        const std::lock_guard lock(device.mutex_);
        if (device.error_ != RTC_ERROR_NONE) return;
        device.error_ = error;
        device.message_ = text ? text : "";
      },
      this);
  rtcSetDeviceMemoryMonitorFunction(
      device_,
      [](void* self, ssize_t bytes, bool) {
        static_cast<Device*>(self)->bytes_ += bytes;
        return true;
      },
      this);
}

Device::~Device() { rtcReleaseDevice(device_); }

void Device::check() const {
  const std::lock_guard lock(mutex_);
  if (error_ == RTC_ERROR_NONE) return;
  throw Error(kindOf(error_), fmt::format("Embree cannot build the scene: {}", message_));
}

std::size_t Device::bytes() const { return static_cast<std::size_t>(std::max<std::ptrdiff_t>(bytes_.load(), 0)); }

Scene::Scene(const Device& device, bool robust) : scene_(rtcNewScene(device.get())) {
  if (!scene_) device.check();
  rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);
  rtcSetSceneFlags(scene_.get(), robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
}

void Scene::attach(const Device& device, const ClusterGeometry& geometry, std::uint32_t id) {
  if (geometry.bounds.empty()) {
    attachUser(device, 1, &geometry, boundsOfClusters, intersectClusters, occludedByClusters, id);
  } else {
    attachUser(device, geometry.bounds.size(), &geometry, boundsOfOneCluster, intersectOneCluster, occludedByOneCluster,
               id);
  }
}

void Scene::attach(const Device& device, const CustomGeometry& geometry, std::uint32_t id) {
  attachUser(device, geometry.items.size(), &geometry, boundsOfCustom, intersectCustom, occludedByCustom, id);
}

void Scene::attach(const Device& device, const MovingGeometry& geometry, std::uint32_t id) {
  attachUser(device, geometry.items.size(), &geometry, boundsOfMoving, intersectMoving, occludedByMoving, id);
}

void Scene::attachUser(const Device& device, std::size_t count, const void* data, RTCBoundsFunction bounds,
                       RTCIntersectFunctionN intersect, RTCOccludedFunctionN occluded, std::uint32_t id) {
  NewGeometry user(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(user.get(), static_cast<unsigned int>(count));
  rtcSetGeometryUserData(user.get(), const_cast<void*>(data));
  rtcSetGeometryBoundsFunction(user.get(), bounds, nullptr);
  rtcSetGeometryIntersectFunction(user.get(), intersect);
  rtcSetGeometryOccludedFunction(user.get(), occluded);
  user.attach(scene_.get(), id);
}

void Scene::attachTriangles(const Device& device, const TriangleMesh& mesh, std::uint32_t id) {
  NewGeometry triangles(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  // Embree reads 16 bytes of each position, beyond the end of our vector: it gets a copy. Indices are shared.
  void* positions = rtcSetNewGeometryBuffer(triangles.get(), RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                            sizeof(Vec3f), mesh.positions.size());
  if (!positions) device.check();
  std::memcpy(positions, mesh.positions.data(), mesh.positions.size() * sizeof(Vec3f));
  rtcSetSharedGeometryBuffer(triangles.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.indices.data(), 0,
                             3 * sizeof(std::uint32_t), mesh.indices.size() / 3);
  triangles.attach(scene_.get(), id);
}

void Scene::attachInstance(const Device& device, const Scene& group, const Matrix& m, std::uint32_t id) {
  NewGeometry instance(device, RTC_GEOMETRY_TYPE_INSTANCE);
  rtcSetGeometryInstancedScene(instance.get(), group.get());
  // Imath's rows are Embree's columns.
  rtcSetGeometryTransform(instance.get(), 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, &m[0][0]);
  instance.attach(scene_.get(), id);
}

void Scene::commit() { rtcCommitScene(scene_.get()); }

LeafHit intersect(const Scene& scene, const Ray<float>& ray, EmbreeCounts* counts) {
  RTCRayHit rayHit;
  rayHit.ray = toEmbree(ray);
  rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersect(scene.get(), rayHit, counts);
  return leafHit(rayHit);
}

void intersectPacket(const Scene& scene, std::span<const Ray<float>> rays, std::span<LeafHit> hits,
                     EmbreeCounts* counts) {
  constexpr unsigned int width = 8;
  RTCRayHit8 packet;
  alignas(32) int valid[width] = {};
  auto* rayN = reinterpret_cast<RTCRayN*>(&packet.ray);
  const auto count = static_cast<unsigned int>(rays.size());
  for (unsigned int i = 0; i < count; ++i) {
    valid[i] = -1;
    const RTCRay ray = toEmbree(rays[i]);
    RTCRayN_org_x(rayN, width, i) = ray.org_x;
    RTCRayN_org_y(rayN, width, i) = ray.org_y;
    RTCRayN_org_z(rayN, width, i) = ray.org_z;
    RTCRayN_tnear(rayN, width, i) = ray.tnear;
    RTCRayN_dir_x(rayN, width, i) = ray.dir_x;
    RTCRayN_dir_y(rayN, width, i) = ray.dir_y;
    RTCRayN_dir_z(rayN, width, i) = ray.dir_z;
    RTCRayN_time(rayN, width, i) = ray.time;
    RTCRayN_tfar(rayN, width, i) = ray.tfar;
    RTCRayN_mask(rayN, width, i) = ray.mask;
    RTCRayN_id(rayN, width, i) = i;
    RTCRayN_flags(rayN, width, i) = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
  if (counts != nullptr && count > 0) counts->rays += count - 1;
  intersect8(valid, scene.get(), packet, counts);
  for (unsigned int i = 0; i < count; ++i)
    hits[i] = leafHit(rtcGetRayHitFromRayHitN(reinterpret_cast<RTCRayHitN*>(&packet), width, i));
}

bool occluded(const Scene& scene, const Ray<float>& ray, EmbreeCounts* counts) {
  RTCRay r = toEmbree(ray);
  occluded(scene.get(), r, counts);
  return r.tfar < 0.0f;
}

}  // namespace steradian::embree
