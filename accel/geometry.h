#pragma once
/// All surfaces of a scene, and ray queries against them.
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "steradian/accel/accel.h"
#include "steradian/accel/query_counts.h"
#include "steradian/core/base/isa.h"
#include "steradian/core/math/bounds.h"
#include "steradian/core/math/ray.h"
#include "steradian/core/scene/description.h"
#include "steradian/core/transport/surface_point.h"

namespace STERADIAN_API steradian {

class FlatPrimitives;
struct PointRecord;

/// "3.13.5": what the library was built with.
std::string_view embreeVersion();

struct GeometrySettings {
  AccelSettings accel = {};
  /// Instruction set of the code that answers queries; must be usable (core/base/isa.h).
  Isa isa = bestIsa();
};

struct GeometryStatistics {
  std::size_t spheres = 0, quads = 0, boxes = 0, disks = 0, triangles = 0, custom = 0;  ///< groups count once
  std::size_t instances = 0;
  std::size_t clusters = 0;
  std::size_t bytes = 0;  ///< clusters, hierarchies and records for points; without the description
  double buildSeconds = 0.0;
  AccelPlan accel;  ///< which code intersects rays with the primitives

  std::size_t primitives() const { return spheres + quads + boxes + disks + triangles + custom; }
};

/// Immutable; queries from any number of threads at once. Render tasks hold a FlushDenormals (core/base/float_mode.h)
/// during queries. Same bits for any number of threads; for scenes without instances and native triangles also for any
/// acceleration structure: of equally near hits the one of smaller (shape, primitive) is reported. Moving shapes are
/// intersected at the ray's time; a shape with a motion of its own still counts as placed directly, and its hits have
/// no instance.
class Geometry {
 public:
  /// Builds with the threads of the caller's arena. The description must be valid (see validate) and is kept: surface
  /// points are computed from it. Throws Error: an instruction set that is not usable, an acceleration structure that
  /// does not support the scene (see planAccel), singular transforms, custom shapes without finite bounds, no memory.
  explicit Geometry(std::shared_ptr<const SceneDescription> scene, GeometrySettings settings = {});
  ~Geometry();
  Geometry(Geometry&&) noexcept;
  Geometry& operator=(Geometry&&) noexcept;

  /// Nearest hit with tMin < t < tMax. A ray that is not finite, or has no direction, hits nothing.
  /// `counts`, unless null: Embree's work is added to it.
  Hit<float> intersect(const Ray<float>& ray, EmbreeCounts* counts = nullptr) const {
    return isUsable(ray) ? intersectUsable(ray, counts) : Hit<float>{};
  }
  /// Is anything hit with tMin < t < tMax?
  bool occluded(const Ray<float>& ray, EmbreeCounts* counts = nullptr) const {
    return isUsable(ray) && occludedUsable(ray, counts);
  }
  /// The same for a ray that is known to be usable (see isUsable()).
  Hit<float> intersectUsable(const Ray<float>& ray, EmbreeCounts* counts = nullptr) const;
  bool occludedUsable(const Ray<float>& ray, EmbreeCounts* counts = nullptr) const;
  /// The nearest hits of up to 8 usable rays: with Accel::Embree as one of its packets, otherwise one after the other.
  void intersectPacket(std::span<const Ray<float>> rays, std::span<Hit<float>> hits,
                       EmbreeCounts* counts = nullptr) const;
  /// The point that this ray hit; `hit` must come from intersect() with the same ray. Invalid for a miss.
  SurfacePoint<float> surfacePoint(const Ray<float>& ray, const Hit<float>& hit) const;

  // For several rays at once (surface_points.h finds their points).

  /// With Accel::Flat the few primitives that are in clusters, placed directly and at rest; otherwise null.
  const FlatPrimitives* flat() const;
  /// Queries against what flat() does not hold and Embree traverses. `best`: the nearest hit of flat(), if valid; the
  /// nearer of the two is returned.
  Hit<float> intersectBesideFlat(const Ray<float>& ray, const Hit<float>& best, EmbreeCounts* counts) const;
  bool occludedBesideFlat(const Ray<float>& ray, EmbreeCounts* counts) const;
  /// Whether every hit is on a primitive that is placed directly, at rest and in a cluster, and the record of its
  /// Hit::place holds all that a surface point needs (with `withUv`, uv too).
  bool recordsByPlace(bool withUv) const;
  /// Those records, by Hit::place, in scenes of at most 65536 primitives; empty in others, where fillRecord() makes
  /// them. Unused places have the shape kNone.
  std::span<const PointRecord> keptRecords() const;
  /// The record of the primitive that was hit, in its own space; null if it is not kept. `hit`: as for surfacePoint(),
  /// and valid.
  const PointRecord* keptRecord(const Hit<float>& hit) const;
  /// Computes that record; false for custom shapes, which have none.
  bool fillRecord(PointRecord& record, const Hit<float>& hit) const;
  /// How the primitive's own space is mapped to the world.
  enum class Placement { Direct, Transformed, TransformedTwice };
  /// Sets both matrices if it is Transformed: by an instance, or by a motion of the shape. Twice: by both.
  Placement placementOf(const Hit<float>& hit, float time, Matrix& localToWorld, Matrix& worldToLocal) const;
  /// The mesh that was hit, if it has normals or uv of its own; otherwise null.
  const TriangleMesh* vertexData(const Hit<float>& hit) const;

  /// Bounds of all surfaces in the world; empty for a scene without.
  Bounds3 bounds() const;
  /// Local to world, by flattened instance index: the instance sets in order, their transforms in order. Of those that
  /// move, at time 0.
  std::span<const Matrix> instanceTransforms() const;
  /// Whether hits may depend on a ray's time: a shape or instance moves, or there is a custom shape, which may use the
  /// time.
  bool dependsOnTime() const;
  GeometryStatistics statistics() const;
  Isa isa() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace steradian
