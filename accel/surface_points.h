#pragma once
/// The surface points of several rays at once, on primitives of any kind.
#include <bit>
#include <cstdint>

#include "steradian/accel/geometry.h"
#include "steradian/accel/shapes/clusters/point_record.h"
#include "steradian/accel/surface_point_of.h"
#include "steradian/accel/transformed_point.h"
#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// Collects the hits of the lanes, then finds their points: those of Geometry::surfacePoint, to the bit. Primitives of
/// all kinds, in instances and in motion, are computed in lanes; vertex normals, uv of meshes and custom shapes one ray
/// at a time.
template <class F>
class SurfacePoints {
 public:
  /// `withUv`: points have uv. The geometry must outlive this.
  SurfacePoints(const Geometry& geometry, bool withUv) : geometry_(geometry), withUv_(withUv) {}

  /// Adds the hit, which must be valid, of lane i's ray. `record`: the primitive's record, if the caller has it.
  void add(int i, const Ray<float>& ray, const Hit<float>& hit, const PointRecord* record = nullptr) {
    const std::uint32_t bit = 1u << i;
    PointRecord& own = records_[i];
    if (record == nullptr) record = geometry_.keptRecord(hit);
    if (record != nullptr) own = *record;
    if (record == nullptr && !geometry_.fillRecord(own, hit)) return addAlone(i, ray, hit);
    const Geometry::Placement placement = geometry_.placementOf(hit, ray.time, toWorld_[i], toLocal_[i]);
    if (placement == Geometry::Placement::TransformedTwice) return addAlone(i, ray, hit);
    if (placement == Geometry::Placement::Transformed) setLane(transformed_, i, true);
    if (geometry_.vertexData(hit) != nullptr) vertexData_ |= bit;
    if (kinds_ == 0) hit_.record = UintOf<F>(static_cast<std::uint32_t>(i));  // what lanes without a hit read, too
    kinds_ |= bitOf(own);
    hits_[i] = hit;
    setLane(hit_.valid, i, true);
    setLane(hit_.t, i, hit.t);
    setLane(hit_.u, i, hit.u);
    setLane(hit_.v, i, hit.v);
    setLane(hit_.record, i, static_cast<std::uint32_t>(i));
    setLane(instance_, i, hit.instance);
  }

  /// The points of all lanes with hits, for the same `rays`; those of other lanes are not valid.
  SurfacePoint<F> find(const Ray<F>& rays) const {
    SurfacePoint<F> points;
    if (kinds_ != 0) points = inWorld(rays);
    for (std::uint32_t left = alone_; left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      setLane(points, i, geometry_.surfacePoint(rays_[i], hits_[i]));
    }
    return points;
  }

 private:
  static constexpr int width = widthOf<F>;

  void addAlone(int i, const Ray<float>& ray, const Hit<float>& hit) {
    alone_ |= 1u << i;
    rays_[i] = ray;
    hits_[i] = hit;
  }

  SurfacePoint<F> inWorld(const Ray<F>& rays) const {
    RecordHit<F> hit = hit_;
    hit.parametersKnown = true;
    const bool withUv = withUv_ || vertexData_ != 0;
    if (!any(transformed_)) {
      SurfacePoint<F> points = surfacePoint(records_, kinds_, rays, hit, withUv);
      addVertexData(points);
      return points;
    }
    const auto toLocal = affineLanes<F>(toLocal_), toWorld = affineLanes<F>(toWorld_);
    const Ray<F> moved = transformed(rays, toLocal);
    Ray<F> local = rays;
    local.origin = select(transformed_, moved.origin, rays.origin);
    local.direction = select(transformed_, moved.direction, rays.direction);
    SurfacePoint<F> points = surfacePoint(records_, kinds_, local, hit, withUv);
    addVertexData(points);
    const SurfacePoint<F> there = transformed(points, toWorld, toLocal);
    points.position = select(transformed_, there.position, points.position);
    points.positionError = select(transformed_, there.positionError, points.positionError);
    points.geometricNormal = select(transformed_, there.geometricNormal, points.geometricNormal);
    points.shadingNormal = select(transformed_, there.shadingNormal, points.shadingNormal);
    points.instance = instance_;
    return points;
  }

  /// In the space of the meshes.
  void addVertexData(SurfacePoint<F>& points) const {
    for (std::uint32_t left = vertexData_; left != 0; left &= left - 1) {
      const int i = std::countr_zero(left);
      SurfacePoint<float> point = lane(points, i);
      steradian::addVertexData(*geometry_.vertexData(hits_[i]), hits_[i].primitive, point);
      setLane(points.uv, i, point.uv);
      setLane(points.shadingNormal, i, point.shadingNormal);
    }
  }

  const Geometry& geometry_;
  bool withUv_;
  RecordHit<F> hit_;
  UintOf<F> instance_{kNone};
  MaskOf<F> transformed_{false};
  PointKinds kinds_ = 0;
  std::uint32_t vertexData_ = 0, alone_ = 0;  ///< lanes, as bits
  // By lane.
  PointRecord records_[width];
  Matrix toWorld_[width], toLocal_[width];
  Hit<float> hits_[width];
  Ray<float> rays_[width];
};

}  // namespace steradian
