#pragma once
/// Where exactly a ray met a primitive: from the nearest hit to a point with normals, parameters and error bounds.
#include "steradian/accel/shapes/clusters/cluster_set.h"
#include "steradian/core/math/ray.h"
#include "steradian/core/scene/description.h"
#include "steradian/core/transport/surface_point.h"

namespace STERADIAN_API steradian {

/// The point in the shape's own space: position on the surface, its error, normals, uv; no ids. `ray` is in that space.
/// The error covers the position's rounding and that of the next query from there, so that rays spawned by
/// core/transport/ray_offset.h do not meet the primitive they leave.
///
/// uv: sphere as in "The Next Week", 4.4; quad and box along the edges, box faces as in 8.1 there; disk: angle about
/// the normal over 2 pi, and distance from the centre over the radius; mesh: its own, or barycentric; custom: the
/// hit's.
SurfacePoint<float> localSurfacePoint(const ShapeDescription& shape, const Ray<float>& ray, const Hit<float>& hit);

/// The same for a primitive that is at hand.
SurfacePoint<float> localSurfacePoint(const LeafShape& shape, const Ray<float>& ray, const Hit<float>& hit);

/// A point of an instance's space in the world. `inverse` is the inverse of `localToWorld`.
SurfacePoint<float> transformed(const SurfacePoint<float>& local, const Matrix& localToWorld, const Matrix& inverse);

/// The ray in an instance's space; its direction is not normalised, so that t means the same.
Ray<float> transformed(const Ray<float>& ray, const Matrix& matrix);

}  // namespace steradian
