#pragma once
/// How fast rays can be traced if nothing else is done.
#include <cstddef>
#include <cstdint>
#include <span>

#include "steradian/accel/geometry.h"
#include "steradian/integrators/path/record_rays.h"

namespace steradian::bench {

/// Asks the geometry about all rays in their order, cut into runs that the caller's arena shares out as a render does
/// its tiles; `several`: several rays at once where the geometry can, as the wide path integrator does. Returns the
/// number of hits, so that no query is in vain.
std::uint64_t replay(const Geometry& geometry, std::span<const RecordedRay> rays, bool several);

}  // namespace steradian::bench
