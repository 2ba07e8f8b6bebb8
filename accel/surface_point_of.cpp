#include "steradian/accel/surface_point_of.h"

#include "steradian/accel/shapes/shape_at.h"

namespace steradian {
namespace {

/// Roundings that a coordinate of a shape's corner or centre goes through, and one that an edge or radius does, in this
/// file and in the next query's kernel together. (With 2 and 8 one ray in 5000 still meets the box that it leaves.)
constexpr float kPlaceError = gammaBound(3);
constexpr float kReachError = gammaBound(12);

SurfacePoint<float> flatPoint(Vec3f position, Vec3f error, Vec3f normal, Vec2f uv) {
  SurfacePoint<float> point;
  point.valid = true;
  point.position = position;
  point.positionError = error;
  point.geometricNormal = normal;
  point.shadingNormal = normal;
  point.uv = uv;
  return point;
}

struct LocalPoint {
  const Ray<float>& ray;
  const Hit<float>& hit;

  /// The query's kernel once more. In an instance this ray is not Embree's to the last bit: whether it enters or leaves
  /// is decided half-way.
  int faceOf(const Box<float>& box) const {
    Ray<float> again = ray;
    again.tMin = maximum(ray.tMin, 0.5f * hit.t);
    return static_cast<int>(crossBox(box.center, box.half, box.axes, again).face());
  }

  SurfacePoint<float> operator()(const SphereSet& set) const { return (*this)(sphereAt(set, hit.primitive)); }
  SurfacePoint<float> operator()(const QuadSet& set) const { return (*this)(quadAt(set, hit.primitive)); }
  SurfacePoint<float> operator()(const DiskSet& set) const { return (*this)(diskAt(set, hit.primitive)); }
  SurfacePoint<float> operator()(const BoxSet& set) const { return (*this)(boxAt(set, hit.primitive)); }
  SurfacePoint<float> operator()(const UprightBox& box) const { return (*this)(boxOf(box)); }
  SurfacePoint<float> operator()(const TurnedBox& box) const { return (*this)(boxOf(box)); }

  SurfacePoint<float> operator()(const Sphere<float>& sphere) const {
    const Vec3f normal = normalize(ray.origin - sphere.center + ray.direction * hit.t);
    const Vec3f reach = normal * sphere.radius;
    const Vec3f error = absolute(sphere.center) * kPlaceError + absolute(reach) * (kPlaceError + kReachError);
    const float phi = arcTan2(-normal.z, normal.x) + kPi;
    return flatPoint(sphere.center + reach, error, normal,
                     {clamp(phi * kInvTwoPi, 0.0f, 1.0f), arcCos(-normal.y) * kInvPi});
  }

  SurfacePoint<float> operator()(const Quad<float>& quad) const {
    const Vec2f uv{clamp(hit.u, 0.0f, 1.0f), clamp(hit.v, 0.0f, 1.0f)};
    const Vec3f along = quad.u * uv.x, across = quad.v * uv.y;
    const Vec3f error = absolute(quad.corner) * kPlaceError + (absolute(quad.u) + absolute(quad.v)) * kReachError;
    return flatPoint(quad.corner + along + across, error, normalize(cross(quad.u, quad.v)), uv);
  }

  SurfacePoint<float> operator()(const Disk<float>& disk) const {
    Vec3f offset = ray.origin - disk.center + ray.direction * hit.t;
    offset -= disk.normal * dot(offset, disk.normal);
    const float reach = disk.radius * kReachError;
    const Vec3f error = absolute(disk.center) * kPlaceError + Vec3f{reach, reach, reach};
    const Vec3f local = Frame<float>::fromZ(disk.normal).toLocal(offset);
    const float angle = arcTan2(local.y, local.x) * kInvTwoPi;
    const Vec2f uv{angle < 0.0f ? angle + 1.0f : angle, minimum(length(offset) / disk.radius, 1.0f)};
    return flatPoint(disk.center + offset, error, disk.normal, uv);
  }

  SurfacePoint<float> operator()(const Box<float>& box) const {
    const Vec3f h = box.half;
    const Vec3f p = box.axes.toLocal(ray.origin - box.center) + box.axes.toLocal(ray.direction) * hit.t;
    Vec3f local{clamp(p.x, -h.x, h.x), clamp(p.y, -h.y, h.y), clamp(p.z, -h.z, h.z)};
    const float x = (local.x + h.x) / (2.0f * h.x), y = (local.y + h.y) / (2.0f * h.y),
                z = (local.z + h.z) / (2.0f * h.z);
    const int face = faceOf(box);
    const float side = face % 2 == 0 ? -1.0f : 1.0f;
    Vec3f normal;
    Vec2f uv;
    if (face < 2) {
      local.x = side * h.x;
      normal = box.axes.x * side;
      uv = {side > 0.0f ? 1.0f - z : z, y};
    } else if (face < 4) {
      local.y = side * h.y;
      normal = box.axes.y * side;
      uv = {x, side > 0.0f ? 1.0f - z : z};
    } else {
      local.z = side * h.z;
      normal = box.axes.z * side;
      uv = {side > 0.0f ? x : 1.0f - x, y};
    }
    const Vec3f reach = absolute(box.axes.x) * h.x + absolute(box.axes.y) * h.y + absolute(box.axes.z) * h.z;
    const Vec3f error = absolute(box.center) * kPlaceError + reach * kReachError;
    return flatPoint(box.center + box.axes.toWorld(local), error, normalize(normal), uv);
  }

  SurfacePoint<float> operator()(const Triangle<float>& t) const {
    const float u = clamp(hit.u, 0.0f, 1.0f), v = clamp(hit.v, 0.0f, 1.0f - u), w = 1.0f - u - v;
    const Vec3f ab = t.b - t.a, ac = t.c - t.a;
    const Vec3f error = (absolute(t.a) + absolute(t.b) + absolute(t.c)) * (0.5f * kPlaceError) +
                        (absolute(ab) + absolute(ac)) * kReachError;
    const Vec3f normal = normalize(cross(ab, ac));
    return flatPoint(t.a * w + t.b * u + t.c * v, error, normal, {u, v});
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
    // Nothing is known about the shape's arithmetic: as much as the longest chain above, over all that went in.
    const Vec3f error = (absolute(ray.origin) + absolute(ray.direction * hit.t)) * (kPlaceError + kReachError);
    const auto again = set.shapes[hit.primitive]->intersect(ray);
    const Vec3f normal = again ? again->normal : normalize(-ray.direction);
    return flatPoint(position, error, normal, {hit.u, hit.v});
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
