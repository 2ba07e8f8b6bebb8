#pragma once
/// The few primitives of a small scene in a row: several rays at once against each of them in turn.
///
/// A ray per lane and one primitive in all of them wastes no lane, however the rays scatter: up to kMost primitives
/// nothing else is as fast. Kernels and surface points are those of single rays, so hits are the same to the bit.
#include <cstdint>
#include <span>
#include <vector>

#include "steradian/accel/shapes/clusters/point_record.h"
#include "steradian/accel/shapes/primitives/aligned_quad.h"
#include "steradian/accel/shapes/primitives/in_lanes.h"
#include "steradian/core/scene/description.h"
#include "steradian/core/transport/surface_point.h"

namespace STERADIAN_API steradian {

class FlatPrimitives {
 public:
  /// So many primitives are met one after the other faster than by way of the bounds of their clusters.
  static constexpr std::size_t kMost = 64;
  /// Whether there are some primitives, but few, and all of kinds that have records (see haveRecords).
  static bool holds(const SceneDescription& scene, std::span<const Id> shapes);

  /// The description must be valid and `holds` true.
  FlatPrimitives(const SceneDescription& scene, std::span<const Id> shapes);

  /// Nearest hits; lanes of rays that are not active, or hit nothing, are not valid. `withUv`: with u and v.
  template <class F, bool withUv = false>
  RecordHit<F> nearest(const Ray<F>& ray, MaskOf<F> active) const;

  /// Is anything hit between tMin and tMax?
  template <class F>
  MaskOf<F> any(const Ray<F>& ray, MaskOf<F> active) const;

  /// The points that these rays hit, without instance; lanes without a hit are not valid. `withUv`: they have uv.
  template <class F>
  SurfacePoint<F> surfacePoint(const Ray<F>& ray, const RecordHit<F>& hit, bool withUv = false) const {
    return steradian::surfacePoint(records_.data(), kinds_, ray, hit, withUv);
  }

 private:
  /// Entries that follow one another and are of one kind.
  struct Run {
    PointKind kind;            ///< whose kernel: records may have another
    std::uint32_t first, end;  ///< entries
    std::uint32_t index;       ///< of the first, in the vector of its kind
  };

  /// As clusters keep it.
  void add(const LeafShape& shape);
  template <class Shape>
  void add(PointKind kind, std::vector<Shape>& shapes, const Shape& shape);

  /// Puts the rays to each entry of a run: visit(entry, hit). tMax may change from one entry to the next.
  template <class F, class Visit>
  void meetRun(const Run& run, const Ray<F>& ray, const RayByAxis<F>& byAxis, const Visit& visit) const;

  std::vector<Run> runs_;  ///< in order of (shape, primitive): of equally near hits the first one wins
  std::vector<Quad<float>> quads_;
  std::vector<AlignedQuad> alignedQuads_;
  std::vector<Sphere<float>> spheres_;
  std::vector<MovingSphere<float>> movingSpheres_;
  std::vector<UprightBox<float>> uprightBoxes_;
  std::vector<Box<float>> turnedBoxes_;
  std::vector<Disk<float>> disks_;
  std::vector<Triangle<float>> triangles_;
  std::vector<PointRecord> records_;  ///< of all entries
  PointKinds kinds_ = 0;
};

template <class F, class Visit>
void FlatPrimitives::meetRun(const Run& run, const Ray<F>& ray, const RayByAxis<F>& byAxis, const Visit& visit) const {
  const auto meetAll = [&](const auto& shapes, const auto& meet) {
    for (std::uint32_t i = run.first; i < run.end; ++i) visit(i, meet(shapes[run.index + i - run.first]));
  };
  const auto meetShape = [&](const auto& shape) { return intersect(inLanes<F>(shape), ray); };
  const auto meetBox = [&](const auto& box) {
    const BoxCrossing<F> c = crossBox(inLanes<F>(box), ray);
    return ShapeHit<F>{c.valid, c.t, F(0.0f), F(0.0f)};
  };
  switch (run.kind) {
    case PointKind::Quad:
      return meetAll(quads_, meetShape);
    case PointKind::AlignedQuad:
      return meetAll(alignedQuads_, [&](const AlignedQuad& q) { return intersect(q, byAxis, ray.tMin, ray.tMax); });
    case PointKind::Sphere:
      return meetAll(spheres_, meetShape);
    case PointKind::MovingSphere:
      return meetAll(movingSpheres_, meetShape);
    case PointKind::UprightBox:
      return meetAll(uprightBoxes_, meetBox);
    case PointKind::TurnedBox:
      return meetAll(turnedBoxes_, meetBox);
    case PointKind::Disk:
      return meetAll(disks_, meetShape);
    case PointKind::Triangle:
      return meetAll(triangles_, meetShape);
  }
}

template <class F, bool withUv>
RecordHit<F> FlatPrimitives::nearest(const Ray<F>& ray, MaskOf<F> active) const {
  const RayByAxis<F> byAxis(ray);
  Ray<F> shortened = ray;  // to the nearest hit so far
  RecordHit<F> best;
  for (const Run& run : runs_) {
    meetRun(run, shortened, byAxis, [&](std::uint32_t entry, const ShapeHit<F>& hit) {
      shortened.tMax = select(hit.valid, hit.t, shortened.tMax);
      best.record = select(hit.valid, UintOf<F>(entry), best.record);
      if constexpr (withUv) {
        best.u = select(hit.valid, hit.u, best.u);
        best.v = select(hit.valid, hit.v, best.v);
      }
    });
  }
  best.valid = active & (shortened.tMax < ray.tMax);
  best.t = shortened.tMax;
  return best;
}

template <class F>
MaskOf<F> FlatPrimitives::any(const Ray<F>& ray, MaskOf<F> active) const {
  const RayByAxis<F> byAxis(ray);
  MaskOf<F> hit(false);
  for (const Run& run : runs_) {
    meetRun(run, ray, byAxis, [&](std::uint32_t, const ShapeHit<F>& found) { hit = hit | found.valid; });
    if (!steradian::any(active & !hit)) break;
  }
  return hit & active;
}

}  // namespace steradian
