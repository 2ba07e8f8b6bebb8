#include "steradian/apps/steradian/memory_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "steradian/core/base/diagnostics.h"

namespace steradian::app {

namespace {

/// An image has 13 float channels; writing an EXR needs it twice more at worst, pixels by plane and the file.
constexpr std::uint64_t kImageBytesPerPixel = 3 * 13 * sizeof(float);

/// Clusters, hierarchy and the memory of building them: measured with boxes, the largest of the small primitives.
constexpr std::uint64_t kBuildBytesPerPrimitive = 80;

/// The number that follows `key` in a file of lines "key number ..."; an empty key: the number that the file begins
/// with. Nothing if there is none ("max").
std::optional<std::uint64_t> numberIn(const std::filesystem::path& path, std::string_view key = {}) {
  std::ifstream file(path);
  std::uint64_t value = 0;
  if (!key.empty()) {
    std::string word;
    while (file >> word && word != key) file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  }
  if (file >> value) return value;
  return std::nullopt;
}

/// Free memory of one control group. The kernel drops cached files before it refuses memory.
std::uint64_t freeOfGroup(const std::filesystem::path& group) {
  const auto limit = numberIn(group / "memory.max"), charged = numberIn(group / "memory.current");
  if (!limit || !charged) return std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t cached = numberIn(group / "memory.stat", "file").value_or(0);
  const std::uint64_t used = *charged - std::min(*charged, cached);
  return *limit - std::min(*limit, used);
}

/// The least free memory of this process's control group and its ancestors.
std::uint64_t freeOfControlGroups(const std::filesystem::path& root) {
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  std::ifstream file(root / "proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("0::/")) continue;
    for (std::filesystem::path group = line.substr(4);; group = group.parent_path()) {
      least = std::min(least, freeOfGroup(root / "sys/fs/cgroup" / group));
      if (group.empty()) break;
    }
  }
  return least;
}

}  // namespace

std::uint64_t availableMemory(const std::filesystem::path& root) {
  const auto system = numberIn(root / "proc/meminfo", "MemAvailable:");  // in KiB
  return std::min(system ? *system << 10 : std::numeric_limits<std::uint64_t>::max(), freeOfControlGroups(root));
}

void checkMemory(const SceneDescription& scene, std::uint64_t available) {
  std::uint64_t primitives = 0;
  for (const ShapeDescription& shape : scene.shapes) primitives += primitiveCount(shape.geometry);
  const std::uint64_t bytes = primitives * kBuildBytesPerPrimitive;
  if (bytes <= available) return;
  throw Error(ErrorKind::Memory, fmt::format("{} primitives need {} MiB of memory, {} MiB are available", primitives,
                                             bytes >> 20, available >> 20));
}

void checkMemory(int width, int height, std::uint32_t replicates, std::uint64_t available) {
  const std::uint64_t perPixel = Film::bytesPerPixel(replicates) + kImageBytesPerPixel;
  const std::uint64_t bytes = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height) * perPixel;
  if (bytes <= available) return;
  throw Error(ErrorKind::Memory, fmt::format("a picture of {} x {} pixels needs {} MiB of memory, {} MiB are available",
                                             width, height, bytes >> 20, available >> 20));
}

}  // namespace steradian::app
