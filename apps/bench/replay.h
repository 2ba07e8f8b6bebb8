#pragma once
/// The speed of tracing rays alone.
#include <cstddef>
#include <cstdint>
#include <span>

#include "steradian/accel/geometry.h"
#include "steradian/integrators/path/record_rays.h"

namespace steradian::bench {

/// Traces all rays in their order, cut into runs that are distributed in the caller's arena as tiles are in a render;
/// `several`: several rays at once where the geometry can, as the wide path integrator does. Returns the number of
/// hits, so that no query can be optimised away.
std::uint64_t replay(const Geometry& geometry, std::span<const RecordedRay> rays, bool several);

}  // namespace steradian::bench
