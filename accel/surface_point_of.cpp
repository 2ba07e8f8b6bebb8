#include "steradian/accel/surface_point_of.h"

#include "steradian/accel/shapes/primitives/shape_at.h"
#include "steradian/accel/shapes/primitives/shape_point.h"

namespace steradian {
namespace {

SurfacePoint<float> surfacePoint(const ShapePoint<float>& on, Vec2f uv) {
  SurfacePoint<float> point;
  point.valid = true;
  point.position = on.position;
  point.positionError = on.error;
  point.geometricNormal = on.normal;
  point.shadingNormal = on.normal;
  point.uv = uv;
  return point;
}

struct LocalPoint {
  const Ray<float>& ray;
  const Hit<float>& hit;

  ShapeHit<float> shapeHit() const { return {true, hit.t, hit.u, hit.v}; }

  SurfacePoint<float> operator()(const SphereSet& set) const { return (*this)(movingSphereAt(set, hit.primitive)); }
  SurfacePoint<float> operator()(const QuadSet& set) const { return (*this)(quadAt(set, hit.primitive)); }
  SurfacePoint<float> operator()(const DiskSet& set) const { return (*this)(diskAt(set, hit.primitive)); }
  SurfacePoint<float> operator()(const BoxSet& set) const { return (*this)(boxAt(set, hit.primitive)); }
  SurfacePoint<float> operator()(const TurnedBox& box) const { return (*this)(boxOf(box)); }

  SurfacePoint<float> operator()(const Sphere<float>& sphere) const {
    const ShapePoint<float> on = shapePoint(sphere, ray, shapeHit());
    return surfacePoint(on, sphereUv(on.normal));
  }

  SurfacePoint<float> operator()(const MovingSphere<float>& sphere) const { return (*this)(sphere.at(ray.time)); }

  SurfacePoint<float> operator()(const Quad<float>& quad) const {
    ShapePoint<float> on = shapePoint(quad, ray, shapeHit());
    if (AlignedQuad::of(quad)) {
      const Vec3f opposite = quad.corner + quad.u + quad.v;
      on.position = positionBetween(minimum(quad.corner, opposite), maximum(quad.corner, opposite), ray, hit.t);
    }
    return surfacePoint(on, quadUv(shapeHit()));
  }

  SurfacePoint<float> operator()(const Disk<float>& disk) const {
    const ShapePoint<float> on = shapePoint(disk, ray, shapeHit());
    return surfacePoint(on, uvOf(disk, on.position));
  }

  SurfacePoint<float> operator()(const AlignedQuad& quad) const { return (*this)(quad.quad()); }
  template <class Axes>
  SurfacePoint<float> operator()(const OrientedBox<float, Axes>& box) const {
    const BoxPlace<float> place = boxPlace(box, ray, hit.t);
    return surfacePoint(shapePoint(box, place), uvOf(box, place));
  }

  SurfacePoint<float> operator()(const Triangle<float>& t) const {
    return surfacePoint(shapePoint(t, ray, shapeHit()), triangleUv(shapeHit()));
  }

  SurfacePoint<float> operator()(const TriangleMesh& mesh) const {
    SurfacePoint<float> point = (*this)(triangleAt(mesh, hit.primitive));
    addVertexData(mesh, hit.primitive, point);
    return point;
  }

  SurfacePoint<float> operator()(const CustomShapeSet& set) const {
    const Vec3f position = ray.at(hit.t);
    // The shape's arithmetic is unknown: assume the longest chain of roundings of our own shapes, scaled by the inputs.
    const Vec3f error = (absolute(ray.origin) + absolute(ray.direction * hit.t)) * (kPlaceError + kReachError);
    const auto again = set.shapes[hit.primitive]->intersect(ray);
    const Vec3f normal = again ? again->normal : normalize(-ray.direction);
    return surfacePoint({position, error, normal}, {hit.u, hit.v});
  }
};

}  // namespace

SurfacePoint<float> localSurfacePoint(const ShapeDescription& shape, const Ray<float>& ray, const Hit<float>& hit) {
  return std::visit(LocalPoint{ray, hit}, shape.geometry);
}

SurfacePoint<float> localSurfacePoint(const LeafShape& shape, const Ray<float>& ray, const Hit<float>& hit) {
  return std::visit(LocalPoint{ray, hit}, shape);
}

void addVertexData(const TriangleMesh& mesh, std::uint32_t triangle, SurfacePoint<float>& point) {
  const float u = point.uv.x, v = point.uv.y, w = 1.0f - u - v;
  const std::uint32_t* corner = &mesh.indices[3 * std::size_t{triangle}];
  if (!mesh.uvs.empty()) {
    const Vec2f a = mesh.uvs[corner[0]], b = mesh.uvs[corner[1]], c = mesh.uvs[corner[2]];
    point.uv = {a.x * w + b.x * u + c.x * v, a.y * w + b.y * u + c.y * v};
  }
  if (!mesh.normals.empty()) {
    const Vec3f n = mesh.normals[corner[0]] * w + mesh.normals[corner[1]] * u + mesh.normals[corner[2]] * v;
    if (lengthSquared(n) > 0.0f) point.shadingNormal = faceForward(normalize(n), point.geometricNormal);
  }
}

}  // namespace steradian
