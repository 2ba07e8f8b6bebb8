#include "steradian/accel/geometry.h"

#include "steradian/accel/embree_geometry.h"
#include "steradian/accel/surface_point_of.h"

namespace steradian {

SurfacePoint<float> Geometry::Implementation::localPoint(const Ray<float>& ray, const Hit<float>& hit) const {
  const ShapeDescription& shape = description->shapes[hit.shape];
  if (hit.place == kNone || std::holds_alternative<TriangleMesh>(shape.geometry))
    return localSurfacePoint(shape, ray, hit);
  return localSurfacePoint(clustersOf[hit.shape]->leafShape(hit.place), ray, hit);
}

SurfacePoint<float> Geometry::Implementation::groupPoint(const Ray<float>& ray, const Hit<float>& hit) const {
  const MovingTransform* motion = motionOf(motionOfShape, hit.shape);
  if (!motion) return localPoint(ray, hit);
  // As in the query, to the bit.
  const Matrix matrix = motion->at(ray.time), inverse = affineInverse(matrix);
  return transformed(localPoint(transformed(ray, inverse), hit), matrix, inverse);
}

SurfacePoint<float> Geometry::Implementation::worldPoint(const Ray<float>& ray, const Hit<float>& hit) const {
  if (hit.instance == kNone) return groupPoint(ray, hit);
  if (const MovingTransform* motion = motionOf(motionOfInstance, hit.instance)) {
    const Matrix matrix = motion->at(ray.time), inverse = affineInverse(matrix);
    return transformed(groupPoint(transformed(ray, inverse), hit), matrix, inverse);
  }
  const Matrix& inverse = inverses[hit.instance];
  return transformed(groupPoint(transformed(ray, inverse), hit), transforms[hit.instance], inverse);
}

std::string_view embreeVersion() { return embree::kVersion; }

Geometry::Geometry(std::shared_ptr<const SceneDescription> scene, GeometrySettings settings)
    : implementation_(std::make_unique<Implementation>(std::move(scene), settings)) {}
Geometry::~Geometry() = default;
Geometry::Geometry(Geometry&&) noexcept = default;
Geometry& Geometry::operator=(Geometry&&) noexcept = default;

Hit<float> Geometry::intersectUsable(const Ray<float>& ray) const {
  const Implementation& self = *implementation_;
  LeafHit best;
  self.world.clusters.nearest(ray, kNone, best);
  if (self.world.scene) {
    Ray<float> toBest = self.forEmbree(ray);
    if (best.found()) toBest.tMax = justBeyond(best.t);
    LeafHit other = embree::intersect(self.world.scene, toBest);
    if (other.instance != kNone) other.instance -= self.firstInstanceId();
    keepFirst(other, best);
  }
  if (!best.found()) return {};
  return {true, best.t, best.u, best.v, best.shape, best.primitive, best.instance, best.place};
}

bool Geometry::occludedUsable(const Ray<float>& ray) const {
  const Implementation& self = *implementation_;
  return self.world.clusters.any(ray) || (self.world.scene && embree::occluded(self.world.scene, self.forEmbree(ray)));
}

SurfacePoint<float> Geometry::surfacePoint(const Ray<float>& ray, const Hit<float>& hit) const {
  if (!hit.valid) return {};
  const Implementation& self = *implementation_;
  // Most scenes are at rest, and without instances.
  const bool local = hit.instance == kNone && self.motionOfShape.empty();
  SurfacePoint<float> point = local ? self.localPoint(ray, hit) : self.worldPoint(ray, hit);
  point.distance = hit.t;
  point.shape = hit.shape;
  point.primitive = hit.primitive;
  point.instance = hit.instance;
  point.material = self.materialOf(hit.shape, hit.primitive);
  return point;
}

void Geometry::fillRecord(PointRecord& record, const Hit<float>& hit) const {
  implementation_->fillRecord(record, hit.place);
}
std::span<const PointRecord> Geometry::keptRecords() const { return implementation_->keptRecords; }

bool Geometry::hasRecords() const { return implementation_->hasRecords; }
bool Geometry::recordsKnowUv() const { return implementation_->recordsKnowUv; }
const FlatPrimitives* Geometry::flat() const { return implementation_->flat ? &*implementation_->flat : nullptr; }
Bounds3 Geometry::bounds() const { return implementation_->bounds; }
std::span<const Matrix> Geometry::instanceTransforms() const { return implementation_->transforms; }
bool Geometry::dependsOnTime() const { return implementation_->dependsOnTime; }
Isa Geometry::isa() const { return implementation_->isa; }
GeometryStatistics Geometry::statistics() const { return implementation_->statistics; }

}  // namespace steradian
