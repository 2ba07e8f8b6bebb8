#include "steradian/tests/layering/layering.h"

#include <algorithm>
#include <fstream>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace steradian::layering {
namespace {

namespace fs = std::filesystem;

constexpr int kLongestFile = 450;

/// A top-level folder. Its sub-rooms are listed in the order in which they may include each other: each may include
/// itself and those before it. Files in the room itself may include all of them.
struct Room {
  std::string_view folder;
  std::vector<std::string_view> mayKnow;
  std::vector<std::string_view> subRooms = {};
  bool holdsFiles = true;  ///< false: every file lies in a sub-room
};

const std::vector<Room>& rooms() {
  static const std::vector<Room> all = {
      {"core/",
       {},
       {"base/", "math/", "statistics/", "transport/", "samplers/", "sampling/", "image/", "colour/", "film/", "scene/",
        "readers/"},
       false},
      {"accel/", {"core/"}, {"shapes/primitives/", "shapes/sampling/", "shapes/clusters/"}},
      {"materials/", {"core/"}},
      {"lights/", {"core/", "accel/", "materials/"}},
      {"integrators/",
       {"core/", "accel/", "materials/", "lights/"},
       {"volumes/", "scene/", "render/", "path/", "bidirectional/", "metropolis/", "auxiliary/"}},
      {"apps/", {"core/", "accel/", "materials/", "lights/", "integrators/"}},
      {"tests/", {"core/", "accel/", "materials/", "lights/", "integrators/", "apps/"}},
  };
  return all;
}

const Room* roomOf(std::string_view path) {
  for (const Room& room : rooms()) {
    if (path.starts_with(room.folder)) return &room;
  }
  return nullptr;
}

/// The place of the file's sub-room in the order of its room; behind all of them for files of the room itself.
std::size_t orderOf(const Room& room, std::string_view path) {
  const std::string_view inRoom = path.substr(room.folder.size());
  const auto at = std::find_if(room.subRooms.begin(), room.subRooms.end(),
                               [&](std::string_view subRoom) { return inRoom.starts_with(subRoom); });
  return static_cast<std::size_t>(at - room.subRooms.begin());
}

/// Whether the file is in a sub-room, or in a room that may hold files.
bool isPlaced(const Room& room, std::string_view path) {
  if (room.subRooms.empty() || orderOf(room, path) < room.subRooms.size()) return true;
  return room.holdsFiles && path.find('/', room.folder.size()) == path.npos;
}

bool startsWithAny(std::string_view text, std::initializer_list<std::string_view> prefixes) {
  return std::any_of(prefixes.begin(), prefixes.end(), [&](std::string_view p) { return text.starts_with(p); });
}

bool containsAny(std::string_view text, std::initializer_list<std::string_view> parts) {
  return std::any_of(parts.begin(), parts.end(), [&](std::string_view p) { return text.find(p) != text.npos; });
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  return first == text.npos ? std::string_view() : text.substr(first);
}

// The argument of an #include with its opening < or ", or nothing.
std::optional<std::string_view> includeOf(std::string_view line) {
  line = trimmed(line);
  if (!line.starts_with('#')) return std::nullopt;
  line = trimmed(line.substr(1));
  if (!line.starts_with("include")) return std::nullopt;
  line = trimmed(line.substr(7));
  const auto end = line.find_first_of(">\"", 1);
  if (end == line.npos) return std::nullopt;
  return line.substr(0, end);
}

class Inspector {
 public:
  explicit Inspector(fs::path root) : root_(std::move(root)) {}

  void inspectFile(const std::string& path) {
    path_ = path;
    line_ = 0;
    ++findings_.files;
    std::ifstream file(root_ / path);
    bool once = false;
    for (std::string text; std::getline(file, text);) {
      ++line_;
      once = once || trimmed(text).starts_with("#pragma once");
      const std::string_view code = std::string_view(text).substr(0, text.find("//"));
      if (const auto include = includeOf(text)) {
        inspectInclude(*include);
      } else {
        inspectCode(code);
      }
    }
    if (line_ > kLongestFile) violation("longer than " + std::to_string(kLongestFile) + " lines: split it");
    line_ = 1;
    if (const Room* room = roomOf(path_); room != nullptr && !isPlaced(*room, path_))
      violation("lies in no sub-room of " + std::string(room->folder));
    if (isHeader() && !once) violation("a header without #pragma once");
  }

  Findings take() {
    std::sort(findings_.violations.begin(), findings_.violations.end());
    return std::move(findings_);
  }

 private:
  bool isHeader() const { return path_.ends_with(".h"); }
  bool isEmbreeFile() const { return path_.starts_with("accel/embree_"); }
  bool isPublicHeader() const { return isHeader() && !isEmbreeFile() && !startsWithAny(path_, {"apps/", "tests/"}); }

  /// Installed, because others include it, but not exported by a shared library.
  bool isInternalHeader() const { return path_.ends_with("_kernels.h"); }

  void violation(const std::string& text) {
    findings_.violations.push_back(path_ + ":" + std::to_string(line_) + ": " + text);
  }

  void inspectInclude(std::string_view include) {
    ++findings_.includes;
    const bool quoted = include.front() == '"';
    const std::string name(include.substr(1));
    if (name.starts_with("steradian/")) {
      inspectOurs(name.substr(std::string_view("steradian/").size()), quoted);
    } else if (quoted) {
      violation("\"" + name + "\" is not written as \"steradian/...\"");
    } else {
      inspectForeign(name);
    }
  }

  void inspectOurs(const std::string& target, bool quoted) {
    if (!quoted) violation("<steradian/" + target + ">: our own includes stand in quotes");
    if (!fs::exists(root_ / target)) violation(target + " does not exist");
    const bool isOfAccel = path_.starts_with("accel/") || path_.starts_with("tests/accel/");
    if (target.starts_with("accel/embree_") && !isEmbreeFile() && (!isOfAccel || isHeader()))
      violation("only sources of accel and its tests may include " + target);
    const Room* from = roomOf(path_);
    const Room* to = roomOf(target);
    if (to == nullptr) {
      violation(target + " is in no room");
    } else if (to == from) {
      if (orderOf(*to, target) > orderOf(*from, path_))
        violation(path_.substr(0, path_.rfind('/') + 1) + " may not know " + target + ": its sub-room comes later");
    } else if (std::find(from->mayKnow.begin(), from->mayKnow.end(), to->folder) == from->mayKnow.end()) {
      violation(std::string(from->folder) + " may not know " + target);
    }
  }

  void inspectForeign(std::string_view name) {
    const bool embree = startsWithAny(name, {"embree3/", "embree4/", "rtcore"});
    if (embree && !isEmbreeFile()) violation("only accel/embree_* may include " + std::string(name));
    if (startsWithAny(name,
                      {"immintrin.h", "x86intrin.h", "arm_neon.h", "experimental/simd", "simd", "hwy/", "xsimd/"}))
      simd(name);
    // Programs and tests make arenas of their own; build_info.cpp reads the version.
    if (startsWithAny(name, {"tbb/", "oneapi/"}) && name != "tbb/version.h" && path_ != "core/base/parallel.h" &&
        !startsWithAny(path_, {"apps/", "tests/"}))
      violation("only core/base/parallel.h may include " + std::string(name));
    if (isPublicHeader() && startsWithAny(name, {"OpenImageIO/", "OpenColorIO/", "fmt/", "CLI/", "nlohmann/"}))
      violation("a public header may not include " + std::string(name));
  }

  void inspectCode(std::string_view code) {
    if (containsAny(code, {"vector_size", "__builtin_ia32_", "__m128", "__m256", "__m512"})) simd(trimmed(code));
    if (isPublicHeader() && !isInternalHeader() && trimmed(code).starts_with("namespace steradian"))
      violation("an installed header opens its namespace with STERADIAN_API");
  }

  void simd(std::string_view what) {
    // These rules spell the words that they look for.
    if (!path_.starts_with("core/math/lanes") && !path_.starts_with("tests/layering/"))
      violation("only core/math/lanes* may use SIMD directly: " + std::string(what));
  }

  fs::path root_;
  std::string path_;
  int line_ = 0;
  Findings findings_;
};

}  // namespace

Findings inspect(const fs::path& root) {
  Inspector inspector(root);
  for (const char* folder : {"core", "accel", "materials", "lights", "integrators", "apps", "tests"}) {
    if (!fs::exists(root / folder)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string path = entry.path().lexically_relative(root).generic_string();
      const bool source = path.ends_with(".h") || path.ends_with(".cpp");
      // Folders outside/ are users' projects.
      if (source && path.find("/outside/") == path.npos) inspector.inspectFile(path);
    }
  }
  return inspector.take();
}

}  // namespace steradian::layering
