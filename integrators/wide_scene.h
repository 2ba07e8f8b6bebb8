#pragma once
/// What the wide path integrator asks of a scene, for several rays at once.
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "steradian/accel/shapes/flat_primitives.h"
#include "steradian/integrators/scene.h"
#include "steradian/materials/material_table.h"

namespace steradian {

/// Answers are those of Scene, lane by lane and to the bit. The few primitives of small scenes are met with all lanes
/// at once; larger scenes are asked ray by ray, and all but the largest find the points hit with all lanes.
class WideScene {
 public:
  /// The scene must outlive this.
  explicit WideScene(const Scene& scene)
      : scene_(&scene),
        flat_(scene.geometry().flat()),
        materials_(scene.materials()),
        usesFlat_(flat_ != nullptr && (flat_->knowsUv() || !materials_.readsUv())),
        hasSky_(scene.lights().hasSky()) {
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
  bool usesFlat_;                     ///< for points
  std::vector<std::uint32_t> emits_;  ///< per shape
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
  if (usesFlat_ && flat_->few()) {
    return flat_->surfacePoint(ray, withUv ? flat_->nearest<F, true>(ray, usable) : flat_->nearest(ray, usable),
                               withUv);
  }
  const detail::SingleRays<F> rays(ray);
  if (!usesFlat_) {
    SurfacePoint<F> points;
    for (std::uint32_t left = laneBits(usable); left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      setLane(points, i, geometry.surfacePoint(rays[i], geometry.intersectUsable(rays[i])));
    }
    return points;
  }
  FlatPrimitives::LaneHit<F> hits;
  for (std::uint32_t left = laneBits(usable); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const Hit<float> hit = geometry.intersectUsable(rays[i]);
    if (!hit.valid) continue;
    setLane(hits.valid, i, true);
    setLane(hits.t, i, hit.t);
    setLane(hits.u, i, hit.u);
    setLane(hits.v, i, hit.v);
    setLane(hits.entry, i, flat_->entryOf(hit.shape, hit.primitive));
  }
  return flat_->surfacePoint(ray, hits, withUv);
}

template <class F>
MaskOf<F> WideScene::occluded(const Ray<F>& ray, MaskOf<F> active) const {
  const MaskOf<F> usable = active & isUsable(ray);
  if (flat_ != nullptr && flat_->few()) return flat_->any(ray, usable);
  const detail::SingleRays<F> rays(ray);
  MaskOf<F> hit(false);
  for (std::uint32_t left = laneBits(usable); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    if (scene_->geometry().occludedUsable(rays[i])) setLane(hit, i, true);
  }
  return hit;
}

}  // namespace steradian
