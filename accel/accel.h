#pragma once
/// Which code intersects rays with the primitives of a scene.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "steradian/core/base/api.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

enum class Accel {
  Auto,   ///< the fastest, by measurement (BENCHMARKS.md, "Acceleration structures")
  Flat,   ///< several rays at once against each primitive in turn, without a hierarchy
  Bvh8,   ///< our own walk through an eight-wide hierarchy over clusters of primitives, which Embree builds
  Embree  ///< Embree's traversal of its own hierarchy, each cluster a user primitive of it
};

inline constexpr std::string_view kAccelNames[] = {"auto", "flat", "bvh8", "embree"};
std::string_view nameOf(Accel accel);
/// Throws Error (Usage) for other names.
Accel accelOf(std::string_view name);

/// Which code intersects the rays of one scene. With each choice, Embree also traverses instances, shapes that move by
/// a Motion, custom shapes, and meshes that are kept as its native triangles.
struct AccelPlan {
  Accel accel = Accel::Bvh8;   ///< for primitives in clusters; never Auto
  bool clusterMeshes = false;  ///< false: meshes are Embree's native triangles
  /// Numbers of what Embree traverses in addition: native triangles, custom shapes, instances, shapes that move by a
  /// Motion.
  std::size_t triangles = 0, customShapes = 0, instances = 0, movingShapes = 0;

  bool needsEmbree() const { return triangles + customShapes + instances + movingShapes > 0; }
};

struct AccelSettings {
  Accel accel = Accel::Auto;
  /// Up to this many clusters a single ray tests each in turn, without a hierarchy, which is faster (BENCHMARKS.md). 0:
  /// always a hierarchy, and Flat only if chosen by name.
  std::uint32_t maxClustersWithoutTree = 3;
  /// Meshes are in clusters if a scene has at most this many triangles in all: one hierarchy in place of two. Otherwise
  /// they are Embree's native triangles. With Bvh8 and Flat they always are in clusters.
  std::size_t maxClusteredTriangles = 256;
};

/// Throws Error (Usage) for a choice that does not support the scene: Flat for more than 64 primitives, instances,
/// motion or custom shapes; Bvh8 for custom shapes.
AccelPlan planAccel(const SceneDescription& scene, const AccelSettings& settings = {});

/// Text for a report: "bvh8; Embree: 1000 instances, 1 custom shape".
std::string describe(const AccelPlan& plan);

}  // namespace steradian
