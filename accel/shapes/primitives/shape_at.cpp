#include "steradian/accel/shapes/primitives/shape_at.h"

#include <algorithm>
#include <cmath>

namespace steradian {

Sphere<float> sphereAt(const SphereSet& set, std::size_t i) {
  return {{set.centerX[i], set.centerY[i], set.centerZ[i]}, set.radius[i]};
}

MovingSphere<float> movingSphereAt(const SphereSet& set, std::size_t i) {
  const Sphere<float> start = sphereAt(set, i);
  if (set.moveX.empty()) return {start.center, {}, start.radius};
  return {start.center, {set.moveX[i], set.moveY[i], set.moveZ[i]}, start.radius};
}

bool areMoving(const SphereSet& set) {
  const auto moves = [](float x) { return x != 0.0f; };
  return std::any_of(set.moveX.begin(), set.moveX.end(), moves) ||
         std::any_of(set.moveY.begin(), set.moveY.end(), moves) ||
         std::any_of(set.moveZ.begin(), set.moveZ.end(), moves);
}

Quad<float> quadAt(const QuadSet& set, std::size_t i) {
  return {{set.cornerX[i], set.cornerY[i], set.cornerZ[i]},
          {set.uX[i], set.uY[i], set.uZ[i]},
          {set.vX[i], set.vY[i], set.vZ[i]}};
}

Disk<float> diskAt(const DiskSet& set, std::size_t i) {
  return {{set.centerX[i], set.centerY[i], set.centerZ[i]},
          {set.normalX[i], set.normalY[i], set.normalZ[i]},
          set.radius[i]};
}

Triangle<float> triangleAt(const TriangleMesh& mesh, std::size_t i) {
  return {mesh.positions[mesh.indices[3 * i]], mesh.positions[mesh.indices[3 * i + 1]],
          mesh.positions[mesh.indices[3 * i + 2]]};
}

TurnedBox turnedBoxAt(const BoxSet& set, std::size_t i) {
  TurnedBox box{
      {set.centerX[i], set.centerY[i], set.centerZ[i]}, {set.halfX[i], set.halfY[i], set.halfZ[i]}, 1, 0, 0, 0};
  if (set.rotationW.empty()) return box;
  const float w = set.rotationW[i], x = set.rotationX[i], y = set.rotationY[i], z = set.rotationZ[i];
  // Unit length to the last bits: the error bounds of surface points rely on orthonormal axes.
  const float scale = 1.0f / std::sqrt(w * w + x * x + y * y + z * z);
  box.w = w * scale;
  box.x = x * scale;
  box.y = y * scale;
  box.z = z * scale;
  return box;
}

bool isUpright(const BoxSet& set, std::size_t i) {
  return set.rotationW.empty() || (set.rotationX[i] == 0.0f && set.rotationZ[i] == 0.0f);
}

bool areUpright(const BoxSet& set) {
  const auto isZero = [](float x) { return x == 0.0f; };
  return std::all_of(set.rotationX.begin(), set.rotationX.end(), isZero) &&
         std::all_of(set.rotationZ.begin(), set.rotationZ.end(), isZero);
}

bool areAligned(const QuadSet& set) {
  for (std::size_t i = 0; i < set.cornerX.size(); ++i) {
    if (!AlignedQuad::of(quadAt(set, i))) return false;
  }
  return true;
}

UprightBox<float> uprightBoxAt(const BoxSet& set, std::size_t i) {
  const TurnedBox box = turnedBoxAt(set, i);
  const Frame<float> axes = axesOfQuaternion(box.w, 0.0f, box.y, 0.0f);
  return {box.center, box.half, {axes.x.x, axes.z.x}};
}

Box<float> boxOf(const UprightBox<float>& box) {
  const float c = box.axes.cosine, s = box.axes.sine;
  return {box.center, box.half, {{c, 0.0f, -s}, {0.0f, 1.0f, 0.0f}, {s, 0.0f, c}}};
}

Box<float> boxOf(const TurnedBox& box) { return {box.center, box.half, axesOfQuaternion(box.w, box.x, box.y, box.z)}; }

Box<float> boxAt(const BoxSet& set, std::size_t i) { return boxOf(turnedBoxAt(set, i)); }

Bounds3 boundsOf(const Sphere<float>& sphere) {
  const Vec3f reach{sphere.radius, sphere.radius, sphere.radius};
  return {sphere.center - reach, sphere.center + reach};
}

Bounds3 boundsOf(const MovingSphere<float>& sphere) {
  // Rounding is monotonic: no centre at a time in between is computed beyond these two.
  Bounds3 bounds = boundsOf(sphere.at(0.0f));
  bounds.include(boundsOf(sphere.at(1.0f)));
  return bounds;
}

Bounds3 boundsOf(const Quad<float>& quad) {
  Bounds3 bounds;
  bounds.include(quad.corner);
  bounds.include(quad.corner + quad.u);
  bounds.include(quad.corner + quad.v);
  bounds.include(quad.corner + quad.u + quad.v);
  // The kernel extends the quad by a rim.
  const Vec3f rim = (absolute(quad.u) + absolute(quad.v)) * (2.0f * kQuadRim);
  return {bounds.low - rim, bounds.high + rim};
}

Bounds3 boundsOf(const AlignedQuad& quad) { return boundsOf(quad.quad()); }

Bounds3 boundsOf(const Disk<float>& disk) {
  const auto reach = [&](float n) { return disk.radius * safeSqrt(1.0f - n * n + 0x1p-20f); };
  const Vec3f r{reach(disk.normal.x), reach(disk.normal.y), reach(disk.normal.z)};
  return {disk.center - r, disk.center + r};
}

Bounds3 boundsOf(const Triangle<float>& triangle) {
  Bounds3 bounds;
  bounds.include(triangle.a);
  bounds.include(triangle.b);
  bounds.include(triangle.c);
  return bounds;
}

Bounds3 boundsOf(const Box<float>& box) {
  const Vec3f reach = reachOf(box.axes, box.half);
  const Vec3f rim = reach * 0x1p-20f;
  return {box.center - reach - rim, box.center + reach + rim};
}

Bounds3 boundsOf(const UprightBox<float>& box) { return boundsOf(boxOf(box)); }
Bounds3 boundsOf(const TurnedBox& box) { return boundsOf(boxOf(box)); }

Bounds3 boundsOf(const ShapeGeometry& geometry, std::size_t i) {
  struct Visitor {
    std::size_t i;
    Bounds3 operator()(const SphereSet& set) const { return boundsOf(movingSphereAt(set, i)); }
    Bounds3 operator()(const QuadSet& set) const { return boundsOf(quadAt(set, i)); }
    Bounds3 operator()(const BoxSet& set) const { return boundsOf(boxAt(set, i)); }
    Bounds3 operator()(const DiskSet& set) const { return boundsOf(diskAt(set, i)); }
    Bounds3 operator()(const TriangleMesh& mesh) const { return boundsOf(triangleAt(mesh, i)); }
    Bounds3 operator()(const CustomShapeSet& set) const { return set.shapes[i]->bounds(); }
  };
  return std::visit(Visitor{i}, geometry);
}

}  // namespace steradian
