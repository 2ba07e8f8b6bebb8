#include "steradian/accel/geometry.h"

#include "steradian/accel/embree_geometry.h"
#include "steradian/accel/surface_point_of.h"
#include "steradian/accel/transformed_point.h"
#include "steradian/core/base/diagnostics.h"

namespace steradian {

SurfacePoint<float> Geometry::Implementation::localPoint(const Ray<float>& ray, const Hit<float>& hit) const {
  const ShapeDescription& shape = description->shapes[hit.shape];
  const ShapeSource& source = sources[hit.shape];
  if (!source.clusters || std::holds_alternative<TriangleMesh>(shape.geometry))
    return localSurfacePoint(shape, ray, hit);
  return localSurfacePoint(source.clusters->leafShape(hit.place), ray, hit);
}

SurfacePoint<float> Geometry::Implementation::groupPoint(const Ray<float>& ray, const Hit<float>& hit) const {
  const MovingTransform* motion = motionOf(motionOfShape, hit.shape);
  if (!motion) return localPoint(ray, hit);
  // The same bits as in the query.
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

namespace {

Hit<float> hitOf(const LeafHit& best) {
  if (!best.found()) return {};
  return {true, best.t, best.u, best.v, best.shape, best.primitive, best.instance, best.place};
}

}  // namespace

void Geometry::Implementation::intersectScene(const Ray<float>& ray, LeafHit& best, EmbreeCounts* counts) const {
  Ray<float> toBest = forEmbree(ray);
  if (best.found()) toBest.tMax = justBeyond(best.t);
  LeafHit other = embree::intersect(world->scene, toBest, counts);
  if (other.instance != kNone) other.instance -= firstInstanceId;
  keepFirst(other, best);
}

Hit<float> Geometry::intersectUsable(const Ray<float>& ray, EmbreeCounts* counts) const {
  const Implementation& self = *implementation_;
  LeafHit best;
  if (self.world->walksClusters()) self.world->clusters.intersect(ray, kNone, best);
  if (self.world->queriesScene()) self.intersectScene(ray, best, counts);
  return hitOf(best);
}

bool Geometry::occludedUsable(const Ray<float>& ray, EmbreeCounts* counts) const {
  const Implementation& self = *implementation_;
  return (self.world->walksClusters() && self.world->clusters.occluded(ray)) || occludedBesideFlat(ray, counts);
}

Hit<float> Geometry::intersectBesideFlat(const Ray<float>& ray, const Hit<float>& hit, EmbreeCounts* counts) const {
  const Implementation& self = *implementation_;
  LeafHit best;
  if (hit.valid) best = {hit.t, hit.u, hit.v, hit.shape, hit.primitive, hit.instance, hit.place};
  if (self.world->queriesScene()) self.intersectScene(ray, best, counts);
  return hitOf(best);
}

bool Geometry::occludedBesideFlat(const Ray<float>& ray, EmbreeCounts* counts) const {
  const Implementation& self = *implementation_;
  return self.world->queriesScene() && embree::occluded(self.world->scene, self.forEmbree(ray), counts);
}

void Geometry::intersectPacket(std::span<const Ray<float>> rays, std::span<Hit<float>> hits,
                               EmbreeCounts* counts) const {
  const Implementation& self = *implementation_;
  constexpr std::size_t maxRays = 8;
  if (rays.size() > maxRays || hits.size() < rays.size())
    throw Error(ErrorKind::Usage, "a packet has at most 8 rays, and a hit for each of them");
  if (self.statistics.accel.accel != Accel::Embree || !self.world->queriesScene()) {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = intersectUsable(rays[i], counts);
    return;
  }
  if (rays.empty()) return;
  Ray<float> shifted[maxRays];
  LeafHit found[maxRays];
  for (std::size_t i = 0; i < rays.size(); ++i) shifted[i] = self.forEmbree(rays[i]);
  embree::intersectPacket(self.world->scene, std::span(shifted, rays.size()), found, counts);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (found[i].instance != kNone) found[i].instance -= self.firstInstanceId;
    hits[i] = hitOf(found[i]);
  }
}

SurfacePoint<float> Geometry::surfacePoint(const Ray<float>& ray, const Hit<float>& hit) const {
  if (!hit.valid) return {};
  const Implementation& self = *implementation_;
  // The common case: neither instances nor motion.
  const bool local = hit.instance == kNone && self.motionOfShape.empty();
  SurfacePoint<float> point = local ? self.localPoint(ray, hit) : self.worldPoint(ray, hit);
  point.distance = hit.t;
  point.shape = hit.shape;
  point.primitive = hit.primitive;
  point.instance = hit.instance;
  point.material = self.materialOf(hit.shape, hit.primitive);
  return point;
}

const FlatPrimitives* Geometry::flat() const { return implementation_->flat ? &*implementation_->flat : nullptr; }
bool Geometry::recordsByPlace(bool withUv) const {
  return implementation_->allRecords && (!withUv || implementation_->recordsKnowUv);
}
std::span<const PointRecord> Geometry::keptRecords() const { return implementation_->keptRecords; }
const PointRecord* Geometry::keptRecord(const Hit<float>& hit) const {
  const std::uint32_t record = implementation_->keptRecord(hit);
  return record == kNone ? nullptr : &implementation_->keptRecords[record];
}
bool Geometry::fillRecord(PointRecord& record, const Hit<float>& hit) const {
  return implementation_->fillRecord(record, hit);
}

Geometry::Placement Geometry::placementOf(const Hit<float>& hit, float time, Matrix& localToWorld,
                                          Matrix& worldToLocal) const {
  const Implementation& self = *implementation_;
  const MovingTransform* own = self.motionOf(self.motionOfShape, hit.shape);
  if (hit.instance == kNone && !own) return Placement::Direct;
  if (hit.instance != kNone && own) return Placement::TransformedTwice;
  const MovingTransform* motion = own ? own : self.motionOf(self.motionOfInstance, hit.instance);
  // The same bits as in the query.
  localToWorld = motion ? motion->at(time) : self.transforms[hit.instance];
  worldToLocal = motion ? affineInverse(localToWorld) : self.inverses[hit.instance];
  return Placement::Transformed;
}
const TriangleMesh* Geometry::vertexData(const Hit<float>& hit) const {
  return implementation_->sources[hit.shape].vertexData;
}

Bounds3 Geometry::bounds() const { return implementation_->bounds; }
std::span<const Matrix> Geometry::instanceTransforms() const { return implementation_->transforms; }
bool Geometry::dependsOnTime() const { return implementation_->dependsOnTime; }
Isa Geometry::isa() const { return implementation_->isa; }
GeometryStatistics Geometry::statistics() const { return implementation_->statistics; }

}  // namespace steradian
