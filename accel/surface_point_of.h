#pragma once
/// Where exactly a ray hit a primitive: from the nearest hit to a point with normals, parameters and error bounds.
#include "steradian/accel/shapes/clusters/leaf_kinds.h"
#include "steradian/core/math/ray.h"
#include "steradian/core/scene/description.h"
#include "steradian/core/transport/surface_point.h"

namespace STERADIAN_API steradian {

/// The point in the shape's own space: position on the surface, its error, normals, uv; no ids. `ray` is in that space.
/// The error covers the position's rounding and that of the next query from there, so that rays spawned by
/// core/transport/ray_offset.h do not hit the primitive they leave.
///
/// uv: sphere as in "The Next Week", 4.4; quad and box along the edges, box faces as in 8.1 there; disk: angle about
/// the normal over 2 pi, and distance from the centre over the radius; mesh: its own, or barycentric; custom: the
/// hit's.
SurfacePoint<float> localSurfacePoint(const ShapeDescription& shape, const Ray<float>& ray, const Hit<float>& hit);

/// The same for a primitive that the caller already has.
SurfacePoint<float> localSurfacePoint(const LeafShape& shape, const Ray<float>& ray, const Hit<float>& hit);

/// Interpolates a mesh's vertex data at a point of one of its triangles: the barycentric uv of `point` becomes that of
/// the mesh, and the shading normal is set. Both in the mesh's own space.
void addVertexData(const TriangleMesh& mesh, std::uint32_t triangle, SurfacePoint<float>& point);

}  // namespace steradian
