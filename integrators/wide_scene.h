#pragma once
/// What the wide path integrator asks of a scene, for several rays at once.
#include <cstdint>
#include <vector>

#include "steradian/accel/shapes/flat_primitives.h"
#include "steradian/integrators/scene.h"
#include "steradian/materials/material_table.h"

namespace steradian {

/// Answers are those of Scene, lane by lane and to the bit. Small scenes are tested with all lanes at once, others ray
/// by ray: there the hierarchy takes the time.
class WideScene {
 public:
  /// The scene must outlive this.
  explicit WideScene(const Scene& scene)
      : scene_(&scene), flat_(scene.geometry().flat()), materials_(scene.materials()), hasSky_(false) {
    for (const ShapeDescription& shape : scene.description().shapes)
      emits_.push_back(shape.emission != kNone ? 1u : 0u);
    emits_.push_back(0u);  // of no shape
    for (const LightDescription& light : scene.description().lights) {
      hasSky_ = hasSky_ || std::holds_alternative<ConstantSky>(light.model) ||
                std::holds_alternative<GradientSky>(light.model);
    }
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
  std::vector<std::uint32_t> emits_;  ///< per shape
  bool hasSky_;
};

template <class F>
SurfacePoint<F> WideScene::intersect(const Ray<F>& ray, MaskOf<F> active) const {
  const Geometry& geometry = scene_->geometry();
  // Textures need parameters of the surface, which flat primitives leave out.
  if (flat_ != nullptr && !materials_.textured()) {
    return flat_->surfacePoint(ray, flat_->nearest(ray, active & isUsable(ray)));
  }
  SurfacePoint<F> points;
  for (int i = 0; i < widthOf<F>; ++i) {
    if (!lane(active, i)) continue;
    const Ray<float> one = lane(ray, i);
    setLane(points, i, geometry.surfacePoint(one, geometry.intersect(one)));
  }
  return points;
}

template <class F>
MaskOf<F> WideScene::occluded(const Ray<F>& ray, MaskOf<F> active) const {
  if (flat_ != nullptr) return flat_->any(ray, active & isUsable(ray));
  MaskOf<F> hit(false);
  for (int i = 0; i < widthOf<F>; ++i) {
    if (lane(active, i)) setLane(hit, i, scene_->geometry().occluded(lane(ray, i)));
  }
  return hit;
}

}  // namespace steradian
