#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace steradian::layering {

/// What one look at the sources found.
struct Findings {
  int files = 0;
  int includes = 0;
  /// One line per broken rule: "path:line: what is wrong".
  std::vector<std::string> violations;
};

/// Reads every source file of the rooms below `root` (core, accel, materials, lights, integrators, apps, tests) and
/// reports what breaks the rules of the house:
/// - a room includes only the rooms that it may know, and nothing includes tests;
/// - a sub-room includes only itself and those before it in the order of its room, and every file has its place;
/// - our includes are written "steradian/room/file.h" and exist;
/// - only accel/embree_* knows Embree, and only sources of accel and its tests know accel/embree_*, which is not
///   installed;
/// - only core/math/lanes* knows SIMD types and intrinsics;
/// - only core/base/parallel.h knows oneTBB, so that ThreadSanitizer can be given other threads;
/// - public headers keep private what users need not have: OpenImageIO, OpenColorIO, fmt, Embree;
/// - installed headers open their namespace with STERADIAN_API, but for tables of kernels (core/base/api.h);
/// - headers start with #pragma once, and no file is longer than 450 lines.
Findings inspect(const std::filesystem::path& root);

}  // namespace steradian::layering
