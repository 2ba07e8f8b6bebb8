#pragma once
/// All surfaces of a scene, and the questions one can ask about rays and them.
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

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
  /// So few clusters are met one after the other, without a hierarchy: faster up to there (BENCHMARKS.md). With 0 all
  /// have a hierarchy, and a few primitives are not met with all lanes either. Hits are the same either way.
  std::uint32_t mostWithoutTree = 3;
  /// Meshes join the clusters if a scene has at most this many triangles in all: one hierarchy in place of two.
  /// Otherwise Embree keeps them, which is a tenth faster for twice the memory.
  std::size_t clusteredTriangles = 256;
  /// Which code answers queries about the geometry and traces the paths of a render; it must be usable.
  Isa isa = bestIsa();
};

struct GeometryStatistics {
  std::size_t spheres = 0, quads = 0, boxes = 0, disks = 0, triangles = 0, custom = 0;  ///< as described, groups once
  std::size_t instances = 0;
  std::size_t clusters = 0;
  std::size_t bytes = 0;  ///< clusters, hierarchies and records for points; without the description
  double buildSeconds = 0.0;

  std::size_t primitives() const { return spheres + quads + boxes + disks + triangles + custom; }
};

/// Immutable; queries from any number of threads at once. Render tasks hold a FlushDenormals (core/base/float_mode.h)
/// while they ask. Same bits for any number of threads; for scenes without instances and native triangles also for any
/// layout: of equally near hits the smaller (shape, primitive) wins. What moves is met where it is at the ray's time;
/// a shape that moves by itself is still placed directly, and its hits have no instance.
class Geometry {
 public:
  /// Builds with the threads of the caller's arena. The description must be valid (see validate) and is kept: surface
  /// points are computed from it. Throws Error: an instruction set that is not usable, singular transforms, custom
  /// shapes without finite bounds, no memory.
  explicit Geometry(std::shared_ptr<const SceneDescription> scene, GeometrySettings settings = {});
  ~Geometry();
  Geometry(Geometry&&) noexcept;
  Geometry& operator=(Geometry&&) noexcept;

  /// Nearest hit with tMin < t < tMax. A ray that is not finite, or has no direction, hits nothing.
  Hit<float> intersect(const Ray<float>& ray) const { return isUsable(ray) ? intersectUsable(ray) : Hit<float>{}; }
  /// Is anything hit with tMin < t < tMax?
  bool occluded(const Ray<float>& ray) const { return isUsable(ray) && occludedUsable(ray); }
  /// The same for a ray that is known to be usable (see isUsable()).
  Hit<float> intersectUsable(const Ray<float>& ray) const;
  bool occludedUsable(const Ray<float>& ray) const;
  /// The point that this ray hit; `hit` must come from intersect() with the same ray. Invalid for a miss.
  SurfacePoint<float> surfacePoint(const Ray<float>& ray, const Hit<float>& hit) const;

  /// For several rays at once: the few primitives of a small scene that has records; otherwise null.
  const FlatPrimitives* flat() const;
  /// Whether there is a record for whatever is hit: no instances, native triangles, shapes with a motion, or kinds
  /// without (see haveRecords()). And whether points by records can have uv.
  bool hasRecords() const;
  bool recordsKnowUv() const;
  /// What the points on the primitive that was hit need; `hit` as for surfacePoint(), and valid. Needs hasRecords().
  void fillRecord(PointRecord& record, const Hit<float>& hit) const;
  /// All records, by Hit::place, in scenes of at most 65536 primitives; empty in others. With kNone for a shape where
  /// there is no primitive.
  std::span<const PointRecord> keptRecords() const;

  /// Bounds of all surfaces in the world; empty for a scene without.
  Bounds3 bounds() const;
  /// Local to world, by flattened instance index: the instance sets in order, their transforms in order. Of those that
  /// move, at time 0.
  std::span<const Matrix> instanceTransforms() const;
  /// Whether a ray's time may matter: something moves, or is a custom shape, which may look at it.
  bool dependsOnTime() const;
  GeometryStatistics statistics() const;
  Isa isa() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace steradian
