#pragma once
/// The few primitives of a small scene in a row: several rays at once against each of them in turn.
///
/// A ray per lane and one primitive in all of them wastes no lane, however the rays scatter: up to kMaxCount primitives
/// this is the fastest way. Kernels and surface points are those of single rays, so hits are the same to the bit.
#include <cstdint>
#include <span>
#include <vector>

#include "steradian/accel/shapes/clusters/point_record.h"

namespace STERADIAN_API steradian {

class FlatPrimitives {
 public:
  /// Up to this many primitives, testing each in turn is faster than testing the bounds of their clusters first.
  static constexpr std::size_t kMaxCount = 64;
  /// Whether there are between 1 and kMaxCount primitives, and no custom shapes.
  static bool fits(const SceneDescription& scene, std::span<const Id> shapes);

  /// The description must be valid and `fits` true.
  FlatPrimitives(const SceneDescription& scene, std::span<const Id> shapes);

  /// Nearest hits; lanes of rays that are not active, or hit nothing, are not valid. `withUv`: u and v are set.
  template <class F, bool withUv = false>
  RecordHit<F> intersect(const Ray<F>& ray, MaskOf<F> active) const;

  /// Is anything hit between tMin and tMax?
  template <class F>
  MaskOf<F> occluded(const Ray<F>& ray, MaskOf<F> active) const;

  /// The points that these rays hit, without instance; lanes without a hit are not valid. `withUv`: they have uv.
  template <class F>
  SurfacePoint<F> surfacePoint(const Ray<F>& ray, const RecordHit<F>& hit, bool withUv = false) const {
    return steradian::surfacePoint(records_.data(), kinds_, ray, hit, withUv);
  }

  /// By RecordHit::record.
  std::span<const PointRecord> records() const { return records_; }

 private:
  /// Entries that follow one another and are of one kind.
  struct Run {
    std::uint32_t kind;        ///< leaf kind whose kernel is used: records may have another
    std::uint32_t first, end;  ///< entries
    std::uint32_t index;       ///< of the first, in the vector of its kind
  };
  template <class Leaf>
  using Of = std::vector<typename Leaf::Flat>;
  /// One member per kind: two kinds may have the same type of primitive here, which a tuple could not tell apart.
  template <class Leaf>
  struct Member {
    Of<Leaf> shapes;
  };

  template <class Leaf>
  void add(const typename Leaf::Shape& shape);

  /// Intersects the rays with each entry of a run: visit(entry, hit). tMax may change from one entry to the next.
  template <class F, class Visit>
  void intersectRun(const Run& run, const Ray<F>& ray, const RayByAxis<F>& byAxis, const Visit& visit) const;

  std::vector<Run> runs_;  ///< in order of (shape, primitive): of equally near hits the first one is kept
  LeafKinds::TupleOf<Member> shapes_;
  std::vector<PointRecord> records_;  ///< of all entries
  PointKinds kinds_ = 0;
};

template <class F, class Visit>
void FlatPrimitives::intersectRun(const Run& run, const Ray<F>& ray, const RayByAxis<F>& byAxis,
                                  const Visit& visit) const {
  LeafKinds::dispatch(run.kind, [&]<class Leaf>() {
    const Of<Leaf>& shapes = std::get<Member<Leaf>>(shapes_).shapes;
    for (std::uint32_t i = run.first; i < run.end; ++i)
      visit(i, Leaf::intersectFlat(shapes[run.index + i - run.first], ray, byAxis));
  });
}

template <class F, bool withUv>
RecordHit<F> FlatPrimitives::intersect(const Ray<F>& ray, MaskOf<F> active) const {
  const RayByAxis<F> byAxis(ray);
  Ray<F> shortened = ray;  // to the nearest hit so far
  RecordHit<F> best;
  best.parametersKnown = withUv;
  for (const Run& run : runs_) {
    intersectRun(run, shortened, byAxis, [&](std::uint32_t entry, const ShapeHit<F>& hit) {
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
MaskOf<F> FlatPrimitives::occluded(const Ray<F>& ray, MaskOf<F> active) const {
  const RayByAxis<F> byAxis(ray);
  MaskOf<F> hit(false);
  for (const Run& run : runs_) {
    intersectRun(run, ray, byAxis, [&](std::uint32_t, const ShapeHit<F>& found) { hit = hit | found.valid; });
    if (!any(active & !hit)) break;
  }
  return hit & active;
}

}  // namespace steradian
