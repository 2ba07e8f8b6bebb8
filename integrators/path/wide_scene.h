#pragma once
/// What the wide path integrator asks of a scene, for several rays at once.
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "steradian/accel/shapes/clusters/flat_primitives.h"
#include "steradian/integrators/scene/scene.h"
#include "steradian/materials/material_table.h"

namespace STERADIAN_API steradian {

/// Answers are those of Scene, lane by lane and to the bit. The few primitives of small scenes are met with all lanes
/// at once; larger scenes are asked ray by ray, and points are found with all lanes unless there are instances or
/// motion.
class WideScene {
 public:
  /// The scene must outlive this.
  explicit WideScene(const Scene& scene)
      : scene_(&scene),
        flat_(scene.geometry().flat()),
        materials_(scene.materials()),
        records_(scene.geometry().keptRecords()),
        usesRecords_(scene.geometry().hasRecords() && (scene.geometry().recordsKnowUv() || !materials_.readsUv())),
        hasSky_(scene.lights().hasSky()) {
    for (const PointRecord& record : records_) keptKinds_ |= record.shape != kNone ? bitOf(record) : 0u;
    for (const ShapeDescription& shape : scene.description().shapes)
      emits_.push_back(shape.emission != kNone ? 1u : 0u);
    emits_.push_back(0u);  // of no shape
  }

  const Scene& scene() const { return *scene_; }
  const MaterialTable& materials() const { return materials_; }

  /// The points that the active rays meet first; others, and those of rays that meet nothing, are not valid.
  template <class F>
  SurfacePoint<F> intersect(const Ray<F>& ray, MaskOf<F> active) const;
  /// Which of the active rays meet anything.
  template <class F>
  MaskOf<F> occluded(const Ray<F>& ray, MaskOf<F> active) const;
  /// Which of the active rays find light where they end.
  template <class F>
  MaskOf<F> findsLight(const SurfacePoint<F>& point, MaskOf<F> active) const {
    const UintOf<F> shape = select(point.valid, point.shape, UintOf<F>(static_cast<std::uint32_t>(emits_.size() - 1)));
    const MaskOf<F> emits = gather(emits_.data(), shape) != UintOf<F>(0u);
    return active & select(point.valid, emits, MaskOf<F>(hasSky_));
  }

 private:
  const Scene* scene_;
  const FlatPrimitives* flat_;
  MaterialTable materials_;
  std::span<const PointRecord> records_;  ///< all, or none
  PointKinds keptKinds_ = 0;              ///< of them
  bool usesRecords_;                      ///< for points
  std::vector<std::uint32_t> emits_;      ///< per shape
  bool hasSky_;
};

namespace detail {
/// Rays of lanes, to be asked for one by one.
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
SurfacePoint<F> WideScene::intersect(const Ray<F>& ray, MaskOf<F> active) const {
  const Geometry& geometry = scene_->geometry();
  const bool withUv = materials_.readsUv();
  const MaskOf<F> usable = active & isUsable(ray);
  if (usesRecords_ && flat_ != nullptr) {
    return flat_->surfacePoint(ray, withUv ? flat_->nearest<F, true>(ray, usable) : flat_->nearest(ray, usable),
                               withUv);
  }
  const detail::SingleRays<F> rays(ray);
  if (!usesRecords_) {
    SurfacePoint<F> points;
    for (std::uint32_t left = laneBits(usable); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      setLane(points, i, geometry.surfacePoint(rays[i], geometry.intersectUsable(rays[i])));
    }
    return points;
  }
  RecordHit<F> hits;
  PointRecord filled[widthOf<F>];
  std::uint32_t count = 0;
  PointKinds kinds = 0;
  for (std::uint32_t left = laneBits(usable); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const Hit<float> hit = geometry.intersectUsable(rays[i]);
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
MaskOf<F> WideScene::occluded(const Ray<F>& ray, MaskOf<F> active) const {
  const MaskOf<F> usable = active & isUsable(ray);
  if (flat_ != nullptr) return flat_->any(ray, usable);
  const detail::SingleRays<F> rays(ray);
  MaskOf<F> hit(false);
  for (std::uint32_t left = laneBits(usable); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    if (scene_->geometry().occludedUsable(rays[i])) setLane(hit, i, true);
  }
  return hit;
}

}  // namespace steradian
