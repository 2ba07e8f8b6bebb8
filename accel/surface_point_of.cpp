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
    const float u = point.uv.x, v = point.uv.y, w = 1.0f - u - v;
    const std::uint32_t* corner = &mesh.indices[3 * std::size_t{hit.primitive}];
    if (!mesh.uvs.empty()) {
      const Vec2f a = mesh.uvs[corner[0]], b = mesh.uvs[corner[1]], c = mesh.uvs[corner[2]];
      point.uv = {a.x * w + b.x * u + c.x * v, a.y * w + b.y * u + c.y * v};
    }
    if (!mesh.normals.empty()) {
      const Vec3f n = mesh.normals[corner[0]] * w + mesh.normals[corner[1]] * u + mesh.normals[corner[2]] * v;
      if (lengthSquared(n) > 0.0f) point.shadingNormal = faceForward(normalize(n), point.geometricNormal);
    }
    return point;
  }

  SurfacePoint<float> operator()(const CustomShapeSet& set) const {
    const Vec3f position = ray.at(hit.t);
    // Nothing is known about the shape's arithmetic: as much as the longest chain of ours, over all that went in.
    const Vec3f error = (absolute(ray.origin) + absolute(ray.direction * hit.t)) * (kPlaceError + kReachError);
    const auto again = set.shapes[hit.primitive]->intersect(ray);
    const Vec3f normal = again ? again->normal : normalize(-ray.direction);
    return surfacePoint({position, error, normal}, {hit.u, hit.v});
  }
};

/// |m| |p| + |translation|: what the rounding errors of transformPoint scale with.
Vec3f magnitudes(const Matrix& m, Vec3f p) {
  const auto component = [&](int j) {
    return absolute(m[0][j] * p.x) + absolute(m[1][j] * p.y) + absolute(m[2][j] * p.z) + absolute(m[3][j]);
  };
  return {component(0), component(1), component(2)};
}

Vec3f spread(const Matrix& m, Vec3f error) {
  const auto component = [&](int j) {
    return absolute(m[0][j]) * error.x + absolute(m[1][j]) * error.y + absolute(m[2][j]) * error.z;
  };
  return {component(0), component(1), component(2)};
}

}  // namespace

SurfacePoint<float> localSurfacePoint(const ShapeDescription& shape, const Ray<float>& ray, const Hit<float>& hit) {
  return std::visit(LocalPoint{ray, hit}, shape.geometry);
}

SurfacePoint<float> localSurfacePoint(const LeafShape& shape, const Ray<float>& ray, const Hit<float>& hit) {
  return std::visit(LocalPoint{ray, hit}, shape);
}

SurfacePoint<float> transformed(const SurfacePoint<float>& local, const Matrix& localToWorld, const Matrix& inverse) {
  SurfacePoint<float> world = local;
  world.position = transformPoint(localToWorld, local.position);
  // The way here, and the way back that the next query takes with an inverse rounded by itself.
  const Vec3f back = magnitudes(inverse, world.position) * kReachError;
  world.positionError =
      spread(localToWorld, local.positionError + back) + magnitudes(localToWorld, local.position) * kPlaceError;
  world.geometricNormal = normalize(transformNormal(inverse, local.geometricNormal));
  world.shadingNormal = faceForward(normalize(transformNormal(inverse, local.shadingNormal)), world.geometricNormal);
  return world;
}

Ray<float> transformed(const Ray<float>& ray, const Matrix& matrix) {
  Ray<float> local = ray;
  local.origin = transformPoint(matrix, ray.origin);
  local.direction = transformVector(matrix, ray.direction);
  return local;
}

}  // namespace steradian
