#pragma once
/// What Embree did for the queries of one thread.
#include <cstdint>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

struct EmbreeCounts {
  std::uint64_t rays = 0;       ///< that Embree traversed a hierarchy for, those inside of instances included
  std::uint64_t callbacks = 0;  ///< calls of our code by it: clusters, custom shapes, what moves

  EmbreeCounts& operator+=(const EmbreeCounts& other) {
    rays += other.rays;
    callbacks += other.callbacks;
    return *this;
  }
};

}  // namespace steradian
