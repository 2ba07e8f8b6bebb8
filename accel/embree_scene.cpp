#include "steradian/accel/embree_scene.h"

#include <fmt/format.h>

#include <cstring>

#include "steradian/accel/surface_point_of.h"
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

// Queries are for one ray at a time, so the N of Embree's argument blocks is 1, and a block of one is a plain record.

void storeBounds(const Bounds3& b, float padding, RTCBounds& out) {
  out.lower_x = b.low.x - padding;
  out.lower_y = b.low.y - padding;
  out.lower_z = b.low.z - padding;
  out.upper_x = b.high.x + padding;
  out.upper_y = b.high.y + padding;
  out.upper_z = b.high.z + padding;
}

/// Calls nearest(ray, instance, best) for Embree's ray and nearest hit so far, and tells Embree about a better one.
template <class Nearest>
void updateHit(const RTCIntersectFunctionNArguments* args, const Nearest& nearest) {
  if (!args->valid[0]) return;
  RTCRayHit& rayHit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
  RTCHit& hit = rayHit.hit;
  Ray<float> ray = fromEmbree(rayHit.ray);
  LeafHit best;
  if (hit.geomID != RTC_INVALID_GEOMETRY_ID) {
    best = {ray.tMax, hit.u, hit.v, hit.geomID, hit.primID, hit.instID[0], bitsOf(hit.Ng_x)};
    ray.tMax = justBeyond(ray.tMax);  // equally near hits must come through
  }
  const LeafHit before = best;
  nearest(ray, args->context->instID[0], best);
  if (best.t == before.t && best.shape == before.shape && best.primitive == before.primitive &&
      best.instance == before.instance) {
    return;
  }
  rayHit.ray.tfar = best.t;
  hit.u = best.u;
  hit.v = best.v;
  hit.geomID = best.shape;
  hit.primID = best.primitive;
  hit.instID[0] = best.instance;
  hit.Ng_x = floatOf(best.place);  // of clusters and what moves nobody needs the normal
}

/// any(ray): is Embree's ray occluded?
template <class Any>
void updateOcclusion(const RTCOccludedFunctionNArguments* args, const Any& any) {
  if (!args->valid[0]) return;
  RTCRay& ray = *reinterpret_cast<RTCRay*>(args->ray);
  if (any(fromEmbree(ray))) ray.tfar = -kInfinity;
}

void boundsOfClusters(const RTCBoundsFunctionArguments* args) {
  const auto& geometry = *static_cast<const ClusterGeometry*>(args->geometryUserPtr);
  storeBounds(geometry.clusters->bounds(), geometry.padding, *args->bounds_o);
}
void intersectClusters(const RTCIntersectFunctionNArguments* args) {
  const auto& geometry = *static_cast<const ClusterGeometry*>(args->geometryUserPtr);
  updateHit(args, [&](const Ray<float>& ray, std::uint32_t instance, LeafHit& best) {
    geometry.clusters->nearest(ray, instance, best);
  });
}
void occludedByClusters(const RTCOccludedFunctionNArguments* args) {
  const auto& geometry = *static_cast<const ClusterGeometry*>(args->geometryUserPtr);
  updateOcclusion(args, [&](const Ray<float>& ray) { return geometry.clusters->any(ray); });
}

Ray<float> localRay(const MovingGeometry::Item& item, const Ray<float>& ray) {
  return transformed(ray, affineInverse(item.localToWorld->at(ray.time)));
}

void boundsOfMoving(const RTCBoundsFunctionArguments* args) {
  const auto& geometry = *static_cast<const MovingGeometry*>(args->geometryUserPtr);
  storeBounds(geometry.items[args->primID].bounds, geometry.padding, *args->bounds_o);
}
void intersectMoving(const RTCIntersectFunctionNArguments* args) {
  const MovingGeometry::Item& item = static_cast<const MovingGeometry*>(args->geometryUserPtr)->items[args->primID];
  updateHit(args, [&](const Ray<float>& ray, std::uint32_t around, LeafHit& best) {
    const std::uint32_t instance = item.instance != kNone ? item.instance : around;
    const Ray<float> local = localRay(item, ray);
    if (item.clusters) return item.clusters->nearest(local, instance, best);
    LeafHit hit = intersect(*item.scene, local);
    hit.instance = instance;
    keepFirst(hit, best);
  });
}
void occludedByMoving(const RTCOccludedFunctionNArguments* args) {
  const MovingGeometry::Item& item = static_cast<const MovingGeometry*>(args->geometryUserPtr)->items[args->primID];
  updateOcclusion(args, [&](const Ray<float>& ray) {
    const Ray<float> local = localRay(item, ray);
    return item.clusters ? item.clusters->any(local) : occluded(*item.scene, local);
  });
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

void Scene::attachClusters(const Device& device, const ClusterGeometry& geometry, std::uint32_t id) {
  attachUser(device, 1, &geometry, boundsOfClusters, intersectClusters, occludedByClusters, id);
}

void Scene::attachMoving(const Device& device, const MovingGeometry& geometry, std::uint32_t id) {
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

LeafHit intersect(const Scene& scene, const Ray<float>& ray) {
  RTCRayHit rayHit;
  rayHit.ray = toEmbree(ray);
  rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersect(scene.get(), rayHit);
  const RTCHit& hit = rayHit.hit;
  if (hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {rayHit.ray.tfar, hit.u, hit.v, hit.geomID, hit.primID, hit.instID[0], bitsOf(hit.Ng_x)};
}

bool occluded(const Scene& scene, const Ray<float>& ray) {
  RTCRay r = toEmbree(ray);
  occluded(scene.get(), r);
  return r.tfar < 0.0f;
}

}  // namespace steradian::embree
