#pragma once
/// The questions that path tracing asks a scene, for several rays at once.
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "steradian/accel/shapes/clusters/flat_primitives.h"
#include "steradian/accel/surface_points.h"
#include "steradian/integrators/scene/scene.h"
#include "steradian/materials/material_table.h"

namespace STERADIAN_API steradian {

/// Answers are those of Scene, lane by lane and to the bit. The few primitives of small scenes are tested against all
/// lanes at once; larger scenes are asked ray by ray. Surface points are found with all lanes.
class WideScene {
 public:
  /// The scene must outlive this.
  explicit WideScene(const Scene& scene)
      : scene_(&scene),
        flat_(scene.geometry().flat()),
        materials_(scene.materials()),
        records_(scene.geometry().keptRecords()),
        recordsByPlace_(scene.geometry().recordsByPlace(materials_.readsUv())),
        besideFlat_(scene.geometry().statistics().accel.needsEmbree()),
        hasSky_(scene.lights().hasSky()) {
    for (const PointRecord& record : records_) keptKinds_ |= record.shape != kNone ? bitOf(record) : 0u;
    for (const ShapeDescription& shape : scene.description().shapes)
      emits_.push_back(shape.emission != kNone ? 1u : 0u);
    emits_.push_back(0u);  // of no shape
  }

  const Scene& scene() const { return *scene_; }
  const MaterialTable& materials() const { return materials_; }

  /// The nearest points that the active rays hit; not valid in other lanes, and for rays that hit nothing. What Embree
  /// does is added to `counts`, if there are any.
  template <class F>
  SurfacePoint<F> intersect(const Ray<F>& ray, MaskOf<F> active, EmbreeCounts* counts = nullptr) const;
  /// Which of the active rays hit anything.
  template <class F>
  MaskOf<F> occluded(const Ray<F>& ray, MaskOf<F> active, EmbreeCounts* counts = nullptr) const;
  /// Which of the active rays end at an emitter: `point` on a shape that emits, or the sky if it is not valid.
  template <class F>
  MaskOf<F> findsLight(const SurfacePoint<F>& point, MaskOf<F> active) const {
    const UintOf<F> shape = select(point.valid, point.shape, UintOf<F>(static_cast<std::uint32_t>(emits_.size() - 1)));
    const MaskOf<F> emits = gather(emits_.data(), shape) != UintOf<F>(0u);
    return active & select(point.valid, emits, MaskOf<F>(hasSky_));
  }

 private:
  /// Where some of what may be hit is not among the records by place.
  template <class F>
  [[gnu::noinline]] SurfacePoint<F> intersectAny(const Ray<F>& ray, MaskOf<F> usable, bool withUv,
                                                 EmbreeCounts* counts) const;

  const Scene* scene_;
  const FlatPrimitives* flat_;
  MaterialTable materials_;
  std::span<const PointRecord> records_;  ///< those that are kept: see Geometry::keptRecords()
  PointKinds keptKinds_ = 0;              ///< the kinds of those records
  bool recordsByPlace_;                   ///< see Geometry::recordsByPlace
  bool besideFlat_;                       ///< Embree has something to traverse besides what is flat
  std::vector<std::uint32_t> emits_;      ///< per shape; 0 for none, which comes last
  bool hasSky_;
};

namespace detail {
/// The rays of all lanes in memory, where they can be read one by one.
template <class F>
class SingleRays {
 public:
  explicit SingleRays(const Ray<F>& ray) {
    const std::array<F, kRows> rows{ray.origin.x,    ray.origin.y, ray.origin.z, ray.direction.x, ray.direction.y,
                                    ray.direction.z, ray.tMax,     ray.time,     ray.tMin};
    for (std::size_t r = 0; r < kRows; ++r) store(rows_[r], rows[r]);
  }
  Ray<float> operator[](int i) const {
    const auto value = [&](int row) { return rows_[row][i]; };
    return {{value(0), value(1), value(2)}, {value(3), value(4), value(5)}, value(6), value(7), value(8)};
  }

 private:
  static constexpr std::size_t kRows = 9;
  float rows_[kRows][widthOf<F>];
};
}  // namespace detail

template <class F>
SurfacePoint<F> WideScene::intersect(const Ray<F>& ray, MaskOf<F> active, EmbreeCounts* counts) const {
  const Geometry& geometry = scene_->geometry();
  const bool withUv = materials_.readsUv();
  const MaskOf<F> usable = active & isUsable(ray);
  if (flat_ != nullptr && !besideFlat_) {
    return flat_->surfacePoint(ray, withUv ? flat_->intersect<F, true>(ray, usable) : flat_->intersect(ray, usable),
                               withUv);
  }
  if (!recordsByPlace_) return intersectAny(ray, usable, withUv, counts);
  const detail::SingleRays<F> rays(ray);
  RecordHit<F> hits;
  hits.parametersKnown = true;
  PointRecord filled[widthOf<F>];
  std::uint32_t count = 0;
  PointKinds kinds = 0;
  for (std::uint32_t left = laneBits(usable); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const Hit<float> hit = geometry.intersectUsable(rays[i], counts);
    if (!hit.valid) continue;
    setLane(hits.valid, i, true);
    setLane(hits.t, i, hit.t);
    setLane(hits.u, i, hit.u);
    setLane(hits.v, i, hit.v);
    if (!records_.empty()) {
      setLane(hits.record, i, hit.place);
    } else {
      geometry.fillRecord(filled[count], hit);
      kinds |= bitOf(filled[count]);
      setLane(hits.record, i, count++);
    }
  }
  if (!records_.empty()) return surfacePoint(records_.data(), keptKinds_, ray, hits, withUv);
  return count > 0 ? surfacePoint(filled, kinds, ray, hits, withUv) : SurfacePoint<F>{};
}

template <class F>
SurfacePoint<F> WideScene::intersectAny(const Ray<F>& ray, MaskOf<F> usable, bool withUv, EmbreeCounts* counts) const {
  const Geometry& geometry = scene_->geometry();
  const detail::SingleRays<F> rays(ray);
  SurfacePoints<F> points(geometry, withUv);
  RecordHit<F> flat;
  if (flat_ != nullptr) flat = flat_->intersect<F, true>(ray, usable);
  for (std::uint32_t left = laneBits(usable); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const Ray<float> one = rays[i];
    if (flat_ == nullptr) {
      const Hit<float> hit = geometry.intersectUsable(one, counts);
      if (hit.valid) points.add(i, one, hit);
      continue;
    }
    Hit<float> best;
    const PointRecord* record = nullptr;
    if (lane(flat.valid, i)) {
      record = &flat_->records()[lane(flat.record, i)];
      best = {true, lane(flat.t, i), lane(flat.u, i), lane(flat.v, i), record->shape, record->primitive};
    }
    if (besideFlat_) {
      const Hit<float> hit = geometry.intersectBesideFlat(one, best, counts);
      if (hit.shape != best.shape || hit.primitive != best.primitive || hit.instance != best.instance) record = nullptr;
      best = hit;
    }
    if (best.valid) points.add(i, one, best, record);
  }
  return points.find(ray);
}

template <class F>
MaskOf<F> WideScene::occluded(const Ray<F>& ray, MaskOf<F> active, EmbreeCounts* counts) const {
  const MaskOf<F> usable = active & isUsable(ray);
  MaskOf<F> hit(false);
  if (flat_ != nullptr) {
    hit = flat_->occluded(ray, usable);
    if (!besideFlat_) return hit;
  }
  const detail::SingleRays<F> rays(ray);
  for (std::uint32_t left = laneBits(usable & !hit); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const bool occluded = flat_ != nullptr ? scene_->geometry().occludedBesideFlat(rays[i], counts)
                                           : scene_->geometry().occludedUsable(rays[i], counts);
    if (occluded) setLane(hit, i, true);
  }
  return hit;
}

}  // namespace steradian
