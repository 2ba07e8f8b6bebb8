#pragma once
/// All primitives of a scene in a row: several rays at once against each of them in turn, and the points that they hit.
///
/// A ray per lane and one primitive in all of them wastes no lane, however the rays scatter: up to kMost primitives
/// nothing else is as fast. Of more primitives this class knows the points only. Kernels and surface points are those
/// of single rays, so hits are the same to the bit.
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

#include "steradian/accel/shapes/aligned_quad.h"
#include "steradian/accel/shapes/in_lanes.h"
#include "steradian/accel/shapes/shape_point.h"
#include "steradian/core/description.h"
#include "steradian/core/surface_point.h"

namespace steradian {

class FlatPrimitives {
 public:
  /// Whether there is a primitive, and the shapes are of the kinds that this class knows: all but custom ones and
  /// meshes with normals of their own.
  static bool holds(const SceneDescription& scene, std::span<const Id> shapes);

  /// The description must be valid and `holds` true. `toMeet`: few primitives shall be met, not only have points.
  FlatPrimitives(const SceneDescription& scene, std::span<const Id> shapes, bool toMeet = true);

  /// So many primitives are met one after the other faster than by way of the bounds of their clusters.
  static constexpr std::size_t kMost = 64;
  /// Whether `nearest` and `any` may be called.
  bool few() const { return few_; }
  /// Whether points can have uv: no mesh has uv of its own.
  bool knowsUv() const { return knowsUv_; }
  /// Memory of the records for points; that of the few for the kernels is small.
  std::size_t bytes() const { return numbers_.capacity() * sizeof(float) + ids_.capacity() * sizeof(Ids); }

  /// Nearest hits; lanes of rays that are not active, or hit nothing, are not valid.
  template <class F>
  struct LaneHit {
    MaskOf<F> valid{false};
    F t{kInfinity};
    UintOf<F> entry{0u};  ///< which primitive
    F u{0.0f}, v{0.0f};   ///< as in Hit; for points with uv
  };
  /// `withUv`: with u and v.
  template <class F, bool withUv = false>
  LaneHit<F> nearest(const Ray<F>& ray, MaskOf<F> active) const;
  /// LaneHit::entry of a primitive.
  std::uint32_t entryOf(Id shape, std::uint32_t primitive) const { return firstOf_[shape] + primitive; }

  /// Is anything hit between tMin and tMax?
  template <class F>
  MaskOf<F> any(const Ray<F>& ray, MaskOf<F> active) const;

  /// The points that these rays hit, without instance; lanes without a hit are not valid. `withUv`: they have uv.
  template <class F>
  SurfacePoint<F> surfacePoint(const Ray<F>& ray, const LaneHit<F>& hit, bool withUv = false) const;

 private:
  enum class Kind : std::uint32_t { Quad, AlignedQuad, Sphere, MovingSphere, UprightBox, TurnedBox, Disk, Triangle };

  /// Entries that follow one another and are of one kind.
  struct Run {
    Kind kind;
    std::uint32_t first, end;  ///< entries
    std::uint32_t index;       ///< of the first, in the vector of its kind
  };
  /// What a surface point needs of an entry, in records to gather: the numbers of the shape, and behind those of quads
  /// and triangles the error and the normal of all their points. Aligned quads have their lowest and highest corner.
  static constexpr std::size_t kNumbers = 16;
  struct Ids {
    std::uint32_t pointKind;  ///< Kind; that of the kernel is the run's
    std::uint32_t shape, primitive, material;
  };

  /// `special`: through the kernel of aligned quads, upright boxes, moving spheres.
  void add(const ShapeGeometry& geometry, std::size_t primitive, bool special);
  /// For the kernels, if there are few.
  template <class Shape>
  void add(Kind kind, std::vector<Shape>& shapes, const Shape& shape);
  void describe(Kind pointKind, std::initializer_list<Vec3f> numbers);

  /// Puts the rays to each entry of a run: visit(entry, hit). tMax may change from one entry to the next.
  template <class F, class Visit>
  void meetRun(const Run& run, const Ray<F>& ray, const RayByAxis<F>& byAxis, const Visit& visit) const;

  /// `uv`: where to put it, or null.
  template <class F>
  ShapePoint<F> pointOf(Kind kind, const Ray<F>& ray, const LaneHit<F>& hit, Vec2<F>* uv) const;

  std::vector<Run> runs_;  ///< in order of (shape, primitive): of equally near hits the first one wins
  std::vector<Quad<float>> quads_;
  std::vector<AlignedQuad> alignedQuads_;
  std::vector<Sphere<float>> spheres_;
  std::vector<MovingSphere<float>> movingSpheres_;
  std::vector<UprightBox<float>> uprightBoxes_;
  std::vector<Box<float>> turnedBoxes_;
  std::vector<Disk<float>> disks_;
  std::vector<Triangle<float>> triangles_;
  std::vector<Kind> present_;
  std::vector<float> numbers_;          ///< kNumbers per entry
  std::vector<Ids> ids_;                ///< per entry
  std::vector<std::uint32_t> firstOf_;  ///< per shape
  bool few_ = false, knowsUv_ = true;
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
    case Kind::Quad:
      return meetAll(quads_, meetShape);
    case Kind::AlignedQuad:
      return meetAll(alignedQuads_, [&](const AlignedQuad& q) { return intersect(q, byAxis, ray.tMin, ray.tMax); });
    case Kind::Sphere:
      return meetAll(spheres_, meetShape);
    case Kind::MovingSphere:
      return meetAll(movingSpheres_, meetShape);
    case Kind::UprightBox:
      return meetAll(uprightBoxes_, meetBox);
    case Kind::TurnedBox:
      return meetAll(turnedBoxes_, meetBox);
    case Kind::Disk:
      return meetAll(disks_, meetShape);
    case Kind::Triangle:
      return meetAll(triangles_, meetShape);
  }
}

template <class F, bool withUv>
FlatPrimitives::LaneHit<F> FlatPrimitives::nearest(const Ray<F>& ray, MaskOf<F> active) const {
  const RayByAxis<F> byAxis(ray);
  Ray<F> shortened = ray;  // to the nearest hit so far
  LaneHit<F> best;
  for (const Run& run : runs_) {
    meetRun(run, shortened, byAxis, [&](std::uint32_t entry, const ShapeHit<F>& hit) {
      shortened.tMax = select(hit.valid, hit.t, shortened.tMax);
      best.entry = select(hit.valid, UintOf<F>(entry), best.entry);
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

template <class F>
ShapePoint<F> FlatPrimitives::pointOf(Kind kind, const Ray<F>& ray, const LaneHit<F>& hit, Vec2<F>* uv) const {
  const UintOf<F> record = hit.entry * UintOf<F>(static_cast<std::uint32_t>(kNumbers));
  const auto numbers = [&](int i) { return gather4(numbers_.data() + i, record); };
  const ShapeHit<F> found{hit.valid, hit.t, hit.u, hit.v};
  const auto ball = [&](const Sphere<F>& sphere) {
    const ShapePoint<F> on = shapePoint(sphere, ray, found);
    if (uv) *uv = sphereUv(on.normal);
    return on;
  };
  const auto box = [&](const auto& turned) {
    const BoxPlace<F> place = boxPlace(turned, ray, hit.t);
    if (uv) *uv = uvOf(turned, place);
    return shapePoint(turned, place);
  };
  const auto a = numbers(0);
  const Vec3<F> first{a[0], a[1], a[2]};
  if (kind == Kind::Sphere) return ball({first, a[3]});
  const auto b = numbers(4);
  const Vec3<F> second{a[3], b[0], b[1]};
  if (kind == Kind::UprightBox) return box(UprightBox<F>{first, second, {b[2], b[3]}});
  if (kind == Kind::MovingSphere) return ball(MovingSphere<F>{first, second, b[2]}.at(ray.time));
  if (kind == Kind::Disk) {
    const Disk<F> disk{first, second, b[2]};
    const ShapePoint<F> on = shapePoint(disk, ray, found);
    if (uv) *uv = uvOf(disk, on.position);
    return on;
  }
  const auto c = numbers(8);
  const Vec3<F> third{b[2], b[3], c[0]}, fourth{c[1], c[2], c[3]};
  if (kind == Kind::AlignedQuad) {
    if (uv) *uv = quadUv(found);
    return {positionBetween(first, second, ray, hit.t), third, fourth};
  }
  const auto d = numbers(12);
  const Vec3<F> fifth{d[0], d[1], d[2]};
  if (kind == Kind::TurnedBox) return box(Box<F>{first, second, {third, fourth, fifth}});
  // The kernel once more, for the parameters.
  if (kind == Kind::Triangle) {
    const Triangle<F> triangle{first, second, third};
    const ShapeHit<F> again = intersect(triangle, ray);
    if (uv) *uv = triangleUv(again);
    return {positionOf(triangle, again), fourth, fifth};
  }
  const Quad<F> quad{first, second, third};
  const ShapeHit<F> again = intersect(quad, ray);
  if (uv) *uv = quadUv(again);
  return {positionOf(quad, again), fourth, fifth};
}

template <class F>
SurfacePoint<F> FlatPrimitives::surfacePoint(const Ray<F>& ray, const LaneHit<F>& hit, bool withUv) const {
  const auto ids = gather4(&ids_.data()->pointKind, hit.entry * UintOf<F>(4u));
  SurfacePoint<F> point;
  point.valid = hit.valid;
  point.distance = hit.t;
  for (const Kind present : present_) {
    const MaskOf<F> mine = hit.valid & (ids[0] == UintOf<F>(static_cast<std::uint32_t>(present)));
    if (!steradian::any(mine)) continue;
    Vec2<F> uv;
    const ShapePoint<F> on = pointOf(present, ray, hit, withUv ? &uv : nullptr);
    point.position = select(mine, on.position, point.position);
    point.positionError = select(mine, on.error, point.positionError);
    point.geometricNormal = select(mine, on.normal, point.geometricNormal);
    if (withUv) point.uv = select(mine, uv, point.uv);
  }
  point.shadingNormal = point.geometricNormal;
  point.shape = ids[1];
  point.primitive = ids[2];
  point.material = ids[3];
  return point;
}

}  // namespace steradian
