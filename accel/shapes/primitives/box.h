#pragma once
/// Box in any orientation and its leaf kernel.
#include "steradian/accel/shapes/primitives/shape_hit.h"
#include "steradian/core/math/frame.h"

namespace STERADIAN_API steradian {

/// The points center + x axes.x + y axes.y + z axes.z with |x| <= half.x and so on.
template <class F, class Axes>
struct OrientedBox {
  Vec3<F> center;
  Vec3<F> half;  ///< half edge lengths, > 0; scene units
  Axes axes;     ///< orthonormal and right-handed
};
template <class F>
using Box = OrientedBox<F, Frame<F>>;

/// Faces of a box are numbered 0 to 5: -x, +x, -y, +y, -z, +z of its own axes.
inline constexpr int kBoxFaces = 6;

/// The axes that the unit quaternion w + x i + y j + z k turns x, y and z into.
template <class F>
Frame<F> axesOfQuaternion(F w, F x, F y, F z) {
  const F one(1.0f), two(2.0f);
  return {{one - two * (y * y + z * z), two * (x * y + w * z), two * (x * z - w * y)},
          {two * (x * y - w * z), one - two * (x * x + z * z), two * (y * z + w * x)},
          {two * (x * z + w * y), two * (y * z - w * x), one - two * (x * x + y * y)}};
}

/// Axes turned about y alone, for half the work: x becomes (cosine, 0, -sine), z becomes (sine, 0, cosine).
template <class F>
struct AxesAboutY {
  F cosine, sine;

  Vec3<F> toLocal(Vec3<F> v) const { return {cosine * v.x - sine * v.z, v.y, sine * v.x + cosine * v.z}; }
  Vec3<F> toWorld(Vec3<F> v) const { return {cosine * v.x + sine * v.z, v.y, cosine * v.z - sine * v.x}; }
};
template <class F>
using UprightBox = OrientedBox<F, AxesAboutY<F>>;

/// Half the extent of a box along the world's axes.
template <class F>
Vec3<F> reachOf(const Frame<F>& axes, Vec3<F> half) {
  return absolute(axes.x) * half.x + absolute(axes.y) * half.y + absolute(axes.z) * half.z;
}
template <class F>
Vec3<F> reachOf(const AxesAboutY<F>& axes, Vec3<F> half) {
  const F c = absolute(axes.cosine), s = absolute(axes.sine);
  return {c * half.x + s * half.z, half.y, s * half.x + c * half.z};
}

/// A box in any orientation, as clusters keep it.
struct TurnedBox {
  Vec3f center, half;
  float w, x, y, z;  ///< unit quaternion
};

/// A ray against the slabs of a box in its own frame (Kay & Kajiya 1986).
template <class F>
struct BoxCrossing {
  Vec3<F> enter, leave;   ///< per axis: distances to the face that the ray enters by, and to the one it leaves by
  Vec3<F> direction;      ///< the ray's, in the box's frame
  MaskOf<F> fromOutside;  ///< else the ray starts inside, and leaves
  MaskOf<F> valid;
  F t;

  /// The face that is hit, 0 to 5, as a float.
  F face() const {
    const Vec3<F> candidate = select(fromOutside, enter, leave);
    const auto number = [&](float negative, F d) {
      const F outward = select(fromOutside, -d, d);
      return F(negative) + select(outward > F(0.0f), F(1.0f), F(0.0f));
    };
    return select(t == candidate.x, number(0.0f, direction.x),
                  select(t == candidate.y, number(2.0f, direction.y), number(4.0f, direction.z)));
  }
};

template <class F, class Axes>
BoxCrossing<F> crossBox(const OrientedBox<F, Axes>& box, const Ray<F>& ray) {
  const Vec3<F> o = box.axes.toLocal(ray.origin - box.center);
  Vec3<F> d = box.axes.toLocal(ray.direction);
  // A component of 0 would give 0 * infinity on a face's plane; this changes no other that matters.
  const F tiny(1e-20f);
  d = {d.x + tiny, d.y + tiny, d.z + tiny};
  const Vec3<F> r = {F(1.0f) / d.x, F(1.0f) / d.y, F(1.0f) / d.z};
  const Vec3<F> h = box.half, side = {copySign(h.x, d.x), copySign(h.y, d.y), copySign(h.z, d.z)};
  BoxCrossing<F> crossing;
  crossing.enter = {(-side.x - o.x) * r.x, (-side.y - o.y) * r.y, (-side.z - o.z) * r.z};
  crossing.leave = {(side.x - o.x) * r.x, (side.y - o.y) * r.y, (side.z - o.z) * r.z};
  crossing.direction = d;
  const F near = maximum(maximum(crossing.enter.x, crossing.enter.y), crossing.enter.z);
  const F far = minimum(minimum(crossing.leave.x, crossing.leave.y), crossing.leave.z);
  crossing.fromOutside = near > ray.tMin;
  crossing.t = select(crossing.fromOutside, near, far);
  crossing.valid = (near <= far) & (crossing.t > ray.tMin) & (crossing.t < ray.tMax);
  return crossing;
}

/// Nearest hit beyond tMin; from inside, where the ray leaves. `u` is the number of the face that is hit, as a float; v
/// is 0. (Clusters do without the face: the surface point finds it again.)
template <class F, class Axes>
ShapeHit<F> intersect(const OrientedBox<F, Axes>& box, const Ray<F>& ray) {
  const BoxCrossing<F> crossing = crossBox(box, ray);
  return {crossing.valid, crossing.t, crossing.face(), F(0.0f)};
}

}  // namespace steradian
