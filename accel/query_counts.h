#pragma once
/// What Embree did for the queries of one thread.
#include <cstdint>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

struct EmbreeCounts {
  std::uint64_t rays = 0;       ///< traced by Embree through a hierarchy, rays inside of instances included
  std::uint64_t callbacks = 0;  ///< from Embree to our code: clusters, custom shapes, moving copies

  EmbreeCounts& operator+=(const EmbreeCounts& other) {
    rays += other.rays;
    callbacks += other.callbacks;
    return *this;
  }
};

}  // namespace steradian
