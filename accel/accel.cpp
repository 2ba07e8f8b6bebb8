#include "steradian/accel/accel.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "steradian/accel/shapes/clusters/flat_primitives.h"
#include "steradian/core/base/diagnostics.h"
#include "steradian/core/scene/placements.h"

namespace steradian {
namespace {

void refuseUnless(bool possible, Accel accel, const std::string& why) {
  if (!possible) throw Error(ErrorKind::Usage, fmt::format("accel {} is not for {}", nameOf(accel), why));
}

}  // namespace

std::string_view nameOf(Accel accel) { return kAccelNames[static_cast<std::size_t>(accel)]; }

Accel accelOf(std::string_view name) {
  const auto found = std::find(std::begin(kAccelNames), std::end(kAccelNames), name);
  if (found != std::end(kAccelNames)) return static_cast<Accel>(found - std::begin(kAccelNames));
  throw Error(ErrorKind::Usage, Diagnostic{Severity::Error,
                                           {},
                                           fmt::format("unknown acceleration structure \"{}\"", name),
                                           didYouMean(name, kAccelNames)});
}

AccelPlan planAccel(const SceneDescription& scene, const AccelSettings& settings) {
  AccelPlan plan;
  std::size_t triangles = 0, primitives = 0;
  for (const ShapeDescription& shape : scene.shapes) {
    const std::size_t count = primitiveCount(shape.geometry);
    primitives += count;
    if (std::holds_alternative<TriangleMesh>(shape.geometry)) triangles += count;
    if (std::holds_alternative<CustomShapeSet>(shape.geometry)) plan.customShapes += count;
    plan.movingShapes += shape.motion ? 1 : 0;
  }
  const Placements placements(scene);
  plan.instances = placements.instanceCount();

  const Accel asked = settings.accel;
  plan.clusterMeshes = asked == Accel::Bvh8 || asked == Accel::Flat || triangles <= settings.maxClusteredTriangles;
  plan.triangles = plan.clusterMeshes ? 0 : triangles;
  if (asked == Accel::Flat || asked == Accel::Bvh8) refuseUnless(plan.customShapes == 0, asked, "custom shapes");
  if (asked == Accel::Flat) {
    refuseUnless(plan.instances == 0, asked, "instances");
    refuseUnless(plan.movingShapes == 0, asked, "shapes that move by a motion");
    refuseUnless(primitives <= FlatPrimitives::kMaxCount, asked,
                 fmt::format("more than {} primitives: the scene has {}", FlatPrimitives::kMaxCount, primitives));
  }
  if (asked != Accel::Auto) {
    plan.accel = asked;
    return plan;
  }
  std::vector<Id> direct;  // shapes that are in clusters, placed directly
  for (Id i = 0; i < scene.shapes.size(); ++i) {
    const ShapeDescription& shape = scene.shapes[i];
    const bool isLeaf = !std::holds_alternative<CustomShapeSet>(shape.geometry) &&
                        (plan.clusterMeshes || !std::holds_alternative<TriangleMesh>(shape.geometry));
    if (isLeaf && placements.isDirect(i) && !shape.motion) direct.push_back(i);
  }
  const bool flat = settings.maxClustersWithoutTree > 0 && FlatPrimitives::fits(scene, direct);
  plan.accel = flat ? Accel::Flat : Accel::Bvh8;
  return plan;
}

std::string describe(const AccelPlan& plan) {
  std::string text(nameOf(plan.accel)), more;
  const auto add = [&](std::size_t count, const char* what) {
    if (count > 0) more += fmt::format("{}{} {}{}", more.empty() ? "" : ", ", count, what, count == 1 ? "" : "s");
  };
  add(plan.triangles, "triangle");
  add(plan.customShapes, "custom shape");
  add(plan.movingShapes, "moving shape");
  add(plan.instances, "instance");
  return more.empty() ? text : text + "; Embree: " + more;
}

}  // namespace steradian
