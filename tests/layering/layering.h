#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace steradian::layering {

/// The result of an inspection of the sources.
struct Findings {
  int files = 0;
  int includes = 0;
  /// One line per broken rule: "path:line: what is wrong".
  std::vector<std::string> violations;
};

/// Reads every source file of the rooms below `root` (core, accel, materials, lights, integrators, apps, tests) and
/// reports violations of these rules:
/// - a room includes only the rooms that it may depend on, and nothing includes tests;
/// - a sub-room includes only itself and those before it in the order of its room, and every file has its place;
/// - our includes are written "steradian/room/file.h" and exist;
/// - only accel/embree_* uses Embree, and only sources of accel and its tests include accel/embree_*, which is not
/// installed;
/// - only core/math/lanes* uses SIMD types and intrinsics;
/// - only core/base/parallel.h uses oneTBB, so that ThreadSanitizer can be given other threads;
/// - public headers do not include what users need not install: OpenImageIO, OpenColorIO, fmt, Embree;
/// - installed headers open their namespace with STERADIAN_API, but for tables of kernels (core/base/api.h);
/// - headers start with #pragma once, and no file is longer than 450 lines.
Findings inspect(const std::filesystem::path& root);

}  // namespace steradian::layering
