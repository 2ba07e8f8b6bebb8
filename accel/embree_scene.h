#pragma once
/// RAII wrappers of Embree's objects, and our clusters, custom shapes and moving copies as its user geometry. Only
/// files of this folder include it.
#include <atomic>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "steradian/accel/embree_api.h"
#include "steradian/accel/shapes/clusters/cluster_set.h"
#include "steradian/core/math/motion.h"
#include "steradian/core/scene/custom_shape.h"

namespace steradian::embree {

/// A device of our own, one per Geometry, so that nothing is shared with other users of Embree in the process. Its
/// errors become exceptions, its memory is counted.
class Device {
 public:
  Device();
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  RTCDevice get() const { return device_; }
  /// Throws Error if any call has failed since.
  void check() const;
  /// What the device holds now.
  std::size_t bytes() const;

 private:
  RTCDevice device_;
  mutable std::mutex mutex_;
  RTCError error_ = RTC_ERROR_NONE;
  std::string message_;
  std::atomic<std::ptrdiff_t> bytes_{0};
};

/// A device that is created on first use: the smallest scenes need none.
class DeviceOnDemand {
 public:
  const Device& get() {
    if (!device_) device_ = std::make_unique<Device>();
    return *device_;
  }
  /// Null if it has not been created.
  const Device* made() const { return device_.get(); }
  void release() { device_ = nullptr; }

 private:
  std::unique_ptr<Device> device_;
};

/// Clusters as user geometry.
struct ClusterGeometry {
  const ClusterSet* clusters = nullptr;
  /// One per cluster: each cluster is one of Embree's primitives. Empty: all clusters together are one primitive, with
  /// our hierarchy inside of it. Read while the scene is committed.
  std::vector<Bounds3> bounds;
  Bounds3 total;
  float padding = 0.0f;  ///< bounds are this much wider on every side; scene units
};

/// Custom shapes as user geometry, each a primitive.
struct CustomGeometry {
  struct Item {
    const CustomShape* implementation;
    std::uint32_t shape, primitive;
  };
  std::vector<Item> items;
  float padding = 0.0f;  ///< see ClusterGeometry
};

struct Hierarchy;

/// Moving copies, each a primitive of user geometry: a ray is transformed to the copy's own space at the ray's time.
/// (Embree's own interpolation of transforms would round differently from that of surface points.)
struct MovingGeometry {
  struct Item {
    const MovingTransform* localToWorld;
    Bounds3 bounds;          ///< at all times
    const Hierarchy* of;     ///< the hierarchy that is copied
    std::uint32_t instance;  ///< reported with hits; kNone: that of the copy itself
  };
  std::vector<Item> items;
  float padding = 0.0f;  ///< see ClusterGeometry
};

/// One hierarchy.
class Scene {
 public:
  Scene() = default;
  /// `robust` for scenes with native triangles: their test then leaves no cracks between neighbours.
  Scene(const Device& device, bool robust);

  RTCScene get() const { return scene_.get(); }
  explicit operator bool() const { return scene_ != nullptr; }
  // As a user geometry of this id. Hits carry the shape as geomID, its primitive as primID. `geometry` must be complete
  // and outlive the scene.
  void attach(const Device& device, const ClusterGeometry& geometry, std::uint32_t id);
  void attach(const Device& device, const CustomGeometry& geometry, std::uint32_t id);
  void attach(const Device& device, const MovingGeometry& geometry, std::uint32_t id);
  void attachTriangles(const Device& device, const TriangleMesh& mesh, std::uint32_t id);
  void attachInstance(const Device& device, const Scene& group, const Matrix& localToWorld, std::uint32_t id);
  /// Builds the hierarchy with the threads of the caller's arena.
  void commit();

 private:
  struct Release {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  };
  void attachUser(const Device& device, std::size_t count, const void* data, RTCBoundsFunction bounds,
                  RTCIntersectFunctionN intersect, RTCOccludedFunctionN occluded, std::uint32_t id);

  std::unique_ptr<RTCSceneTy, Release> scene_;
};

/// Nearest hit; instance ids are those given to attachInstance(). `place` is meaningless for native triangles.
LeafHit intersect(const Scene& scene, const Ray<float>& ray, EmbreeCounts* counts);
bool occluded(const Scene& scene, const Ray<float>& ray, EmbreeCounts* counts);
/// The same for up to 8 rays as one of Embree's packets.
void intersectPacket(const Scene& scene, std::span<const Ray<float>> rays, std::span<LeafHit> hits,
                     EmbreeCounts* counts);

}  // namespace steradian::embree
