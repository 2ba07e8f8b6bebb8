#pragma once
/// What this library was built by and runs with, for reports of faults and measurements.
#include <string>
#include <vector>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// "g++ 12.2.0"
std::string compilerVersion();

struct LibraryVersion {
  std::string name, version;
};
/// The shared libraries that `core` runs with; Embree's is embreeVersion() (accel/geometry.h).
std::vector<LibraryVersion> libraryVersions();

}  // namespace steradian
