#pragma once
/// All primitives of a small scene in a row: several rays at once against each of them in turn, without a hierarchy.
///
/// A ray per lane and one primitive in all of them wastes no lane, however the rays scatter: up to some sixty
/// primitives nothing else is as fast. Kernels and surface points are those of single rays, so hits are the same to the
/// bit.
#include <cstdint>
#include <span>
#include <vector>

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

  /// The description must be valid and `holds` true.
  FlatPrimitives(const SceneDescription& scene, std::span<const Id> shapes);

  /// Nearest hits; lanes of rays that are not active, or hit nothing, are not valid.
  template <class F>
  struct LaneHit {
    MaskOf<F> valid{false};
    F t{kInfinity}, u{0.0f}, v{0.0f};
    UintOf<F> entry{0u};  ///< which primitive
  };
  template <class F>
  LaneHit<F> nearest(const Ray<F>& ray, MaskOf<F> active) const;

  /// Is anything hit between tMin and tMax?
  template <class F>
  MaskOf<F> any(const Ray<F>& ray, MaskOf<F> active) const;

  /// The points that these rays hit, without uv and instance; lanes without a hit are not valid.
  template <class F>
  SurfacePoint<F> surfacePoint(const Ray<F>& ray, const LaneHit<F>& hit) const;

 private:
  enum class Kind : std::uint32_t { Quad, Sphere, UprightBox, TurnedBox, Disk, Triangle };
  static constexpr int kRows = 15;  ///< floats of the largest primitive

  /// Entries that follow one another and are of one kind.
  struct Run {
    Kind kind;
    std::uint32_t first, end;  ///< entries
    std::uint32_t index;       ///< of the first, in the vector of its kind
  };

  void add(const ShapeGeometry& geometry, std::size_t primitive);
  void add(Kind kind, std::size_t index, std::span<const float> values);

  /// Puts the rays to each entry of a run: visit(entry, hit) says whether to go on.
  template <class F, class Visit>
  bool meetRun(const Run& run, const Ray<F>& ray, const Visit& visit) const;

  /// Row `row` of the primitives that the lanes hit.
  template <class F>
  F valueOf(int row, UintOf<F> entry) const {
    return gather(values_.data() + static_cast<std::size_t>(row) * kinds_.size(), entry);
  }
  template <class F>
  Vec3<F> vectorOf(int row, UintOf<F> entry) const {
    return {valueOf<F>(row, entry), valueOf<F>(row + 1, entry), valueOf<F>(row + 2, entry)};
  }
  template <class F>
  ShapePoint<F> pointOf(Kind kind, const Ray<F>& ray, const LaneHit<F>& hit) const;

  std::vector<Run> runs_;  ///< in order of (shape, primitive): of equally near hits the first one wins
  std::vector<Quad<float>> quads_;
  std::vector<Sphere<float>> spheres_;
  std::vector<UprightBox> uprightBoxes_;
  std::vector<Box<float>> turnedBoxes_;
  std::vector<Disk<float>> disks_;
  std::vector<Triangle<float>> triangles_;
  std::vector<std::uint32_t> kinds_, shape_, primitive_, material_;  ///< per entry
  std::vector<Kind> present_;
  std::vector<float> values_;  ///< row by row the numbers of each primitive
};

template <class F, class Visit>
bool FlatPrimitives::meetRun(const Run& run, const Ray<F>& ray, const Visit& visit) const {
  const auto meetAll = [&](const auto& shapes, const auto& meet) {
    for (std::uint32_t i = run.first; i < run.end; ++i) {
      if (!visit(i, meet(shapes[run.index + i - run.first]))) return false;
    }
    return true;
  };
  const auto meetShape = [&](const auto& shape) { return intersect(inLanes<F>(shape), ray); };
  const auto meetBox = [&](Vec3f center, Vec3f half, const auto& axes) {
    const BoxCrossing<F> c = crossBox<F>(broadcast<F>(center), broadcast<F>(half), axes, ray);
    return ShapeHit<F>{c.valid, c.t, F(0.0f), F(0.0f)};
  };
  switch (run.kind) {
    case Kind::Quad:
      return meetAll(quads_, meetShape);
    case Kind::Sphere:
      return meetAll(spheres_, meetShape);
    case Kind::UprightBox:
      return meetAll(uprightBoxes_, [&](const UprightBox& b) {
        return meetBox(b.center, b.half, AxesAboutY<F>{F(b.axes.cosine), F(b.axes.sine)});
      });
    case Kind::TurnedBox:
      return meetAll(turnedBoxes_, [&](const Box<float>& b) { return meetBox(b.center, b.half, inLanes<F>(b).axes); });
    case Kind::Disk:
      return meetAll(disks_, meetShape);
    case Kind::Triangle:
      return meetAll(triangles_, meetShape);
  }
  return true;
}

template <class F>
FlatPrimitives::LaneHit<F> FlatPrimitives::nearest(const Ray<F>& ray, MaskOf<F> active) const {
  LaneHit<F> best;
  for (const Run& run : runs_) {
    meetRun(run, ray, [&](std::uint32_t entry, const ShapeHit<F>& hit) {
      const MaskOf<F> nearer = hit.valid & (hit.t < best.t);
      best.t = select(nearer, hit.t, best.t);
      best.u = select(nearer, hit.u, best.u);
      best.v = select(nearer, hit.v, best.v);
      best.entry = select(nearer, UintOf<F>(entry), best.entry);
      best.valid = best.valid | nearer;
      return true;
    });
  }
  best.valid = best.valid & active;
  return best;
}

template <class F>
MaskOf<F> FlatPrimitives::any(const Ray<F>& ray, MaskOf<F> active) const {
  MaskOf<F> hit(false);
  for (const Run& run : runs_) {
    const bool some = meetRun(run, ray, [&](std::uint32_t, const ShapeHit<F>& found) {
      hit = hit | found.valid;
      return steradian::any(active & !hit);
    });
    if (!some) break;
  }
  return hit & active;
}

template <class F>
ShapePoint<F> FlatPrimitives::pointOf(Kind kind, const Ray<F>& ray, const LaneHit<F>& hit) const {
  const UintOf<F> e = hit.entry;
  const ShapeHit<F> found{hit.valid, hit.t, hit.u, hit.v};
  const auto vector = [&](int row) { return vectorOf<F>(row, e); };
  switch (kind) {
    case Kind::Quad:
      return shapePoint(Quad<F>{vector(0), vector(3), vector(6)}, ray, found);
    case Kind::Sphere:
      return shapePoint(Sphere<F>{vector(0), valueOf<F>(3, e)}, ray, found);
    case Kind::UprightBox:
    case Kind::TurnedBox:
      return shapePoint(Box<F>{vector(0), vector(3), {vector(6), vector(9), vector(12)}}, ray, found);
    case Kind::Disk:
      return shapePoint(Disk<F>{vector(0), vector(3), valueOf<F>(6, e)}, ray, found);
    case Kind::Triangle:
      return shapePoint(Triangle<F>{vector(0), vector(3), vector(6)}, ray, found);
  }
  return {};
}

template <class F>
SurfacePoint<F> FlatPrimitives::surfacePoint(const Ray<F>& ray, const LaneHit<F>& hit) const {
  SurfacePoint<F> point;
  point.valid = hit.valid;
  point.distance = hit.t;
  const UintOf<F> kind = gather(kinds_.data(), hit.entry);
  for (const Kind present : present_) {
    const MaskOf<F> mine = hit.valid & (kind == UintOf<F>(static_cast<std::uint32_t>(present)));
    if (!steradian::any(mine)) continue;
    const ShapePoint<F> on = pointOf(present, ray, hit);
    point.position = select(mine, on.position, point.position);
    point.positionError = select(mine, on.error, point.positionError);
    point.geometricNormal = select(mine, on.normal, point.geometricNormal);
  }
  point.shadingNormal = point.geometricNormal;
  point.shape = gather(shape_.data(), hit.entry);
  point.primitive = gather(primitive_.data(), hit.entry);
  point.material = gather(material_.data(), hit.entry);
  return point;
}

}  // namespace steradian
