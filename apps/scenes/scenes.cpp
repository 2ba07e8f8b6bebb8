#include "steradian/apps/scenes/scenes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <vector>

#include "steradian/apps/scenes/builders.h"

namespace steradian {

namespace {

struct Entry {
  SceneInfo info;
  SceneDescription (*fixed)();
  SceneDescription (*counted)(std::uint32_t);
  std::uint32_t limit;      ///< largest N
  std::uint32_t first = 1;  ///< smallest
};

constexpr std::array kEntries{
    Entry{{"one-weekend", "the cover of book 1: 484 spheres under the sky, thin lens"}, scenes::oneWeekend, nullptr, 0},
    Entry{{"one-weekend-materials", "book 1: matte, hollow glass and fuzzy metal spheres, defocus blur"},
          scenes::oneWeekendMaterials,
          nullptr,
          0},
    Entry{{"one-weekend-picture:N", "book 1: the scene of its picture N, 4 to 23"},
          nullptr,
          scenes::oneWeekendPicture,
          23,
          4},
    Entry{{"checkered-spheres", "book 2: two checkered spheres"}, scenes::checkeredSpheres, nullptr, 0},
    Entry{{"earth", "book 2: a globe; --texture FILE for a map of your own"}, scenes::earth, nullptr, 0},
    Entry{{"perlin-spheres", "book 2: a sphere of marble on marble ground"}, scenes::perlinSpheres, nullptr, 0},
    Entry{{"bouncing-spheres",
           "book 2: the cover of book 1, checkered, its matte spheres rising while the shutter is open"},
          scenes::bouncingSpheres,
          nullptr,
          0},
    Entry{{"quads", "book 2: five coloured quads around the camera"}, scenes::quads, nullptr, 0},
    Entry{{"simple-light", "book 2: a sphere and a quad light over marble"}, scenes::simpleLight, nullptr, 0},
    Entry{
        {"cornell-original", "book 2: the Cornell box with its two-sided light"}, scenes::cornellOriginal, nullptr, 0},
    Entry{{"cornell-smoke", "book 2: the Cornell box with boxes of smoke and fog"}, scenes::cornellSmoke, nullptr, 0},
    Entry{{"next-week-final", "book 2: everything at once; motion, mist, a map, marble, glass"},
          [] { return scenes::nextWeekFinal(false); },
          nullptr,
          0},
    Entry{{"cornell-box", "book 3: the Cornell box, light facing down"}, scenes::cornellBox, nullptr, 0},
    Entry{{"cornell-uniform-diffuse", "book 3: the original box of surfaces that scatter to all sides alike"},
          scenes::cornellUniformDiffuse,
          nullptr,
          0},
    Entry{{"cornell-aluminium", "book 3: the tall box of aluminium"}, scenes::cornellAluminium, nullptr, 0},
    Entry{{"cornell-glass-sphere", "book 3: a glass sphere; it and the light are sampling targets"},
          scenes::cornellGlassSphere,
          nullptr,
          0},
    Entry{{"nested-glass", "tea in a tumbler: liquid and glass without a gap, by priority"},
          scenes::nestedGlass,
          nullptr,
          0},
    Entry{{"door-crack", "a room lit through the gap under its door, which is a sampling target"},
          scenes::doorCrack,
          nullptr,
          0},
    Entry{{"cornell-city:N", "N boxes on the floor of the Cornell room"}, nullptr, scenes::cornellCity, 200'000'000},
    Entry{{"cornell-tower:N", "N Cornell rooms, side by side and stacked, each with its light"},
          nullptr,
          scenes::cornellTower,
          1'000'000},
};

constexpr auto kInfos = [] {
  std::array<SceneInfo, kEntries.size()> infos{};
  std::transform(kEntries.begin(), kEntries.end(), infos.begin(), [](const Entry& e) { return e.info; });
  return infos;
}();

std::string_view stemOf(std::string_view name) { return name.substr(0, name.find(':')); }

[[noreturn]] void throwUnknown(std::string_view spec) {
  std::vector<std::string> names;
  names.reserve(kInfos.size());
  for (const SceneInfo& info : kInfos) names.emplace_back(stemOf(info.name));
  Diagnostic unknown;
  unknown.message = "unknown scene \"" + std::string(spec) + "\"; `steradian scenes` lists them";
  unknown.suggestion = didYouMean(stemOf(spec), names);
  throw Error(ErrorKind::Usage, unknown);
}

std::uint32_t parseCount(std::string_view spec, const Entry& entry) {
  const std::string_view stem = stemOf(entry.info.name);
  const std::string_view text = spec.size() > stem.size() ? spec.substr(stem.size() + 1) : std::string_view{};
  std::uint32_t count = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (text.empty() || failure != std::errc{} || end != text.data() + text.size() || count < entry.first ||
      count > entry.limit)
    throw Error(ErrorKind::Usage, "scene \"" + std::string(spec) + "\": " + std::string(entry.info.name) +
                                      " needs a whole number N from " + std::to_string(entry.first) + " to " +
                                      std::to_string(entry.limit));
  return count;
}

}  // namespace

std::span<const SceneInfo> builtInScenes() { return kInfos; }

SceneDescription makeScene(std::string_view spec) {
  for (const Entry& entry : kEntries) {
    if (stemOf(spec) != stemOf(entry.info.name)) continue;
    if (entry.fixed != nullptr && spec != entry.info.name)
      throw Error(ErrorKind::Usage, "scene \"" + std::string(entry.info.name) + "\" takes no count");
    SceneDescription scene = entry.fixed != nullptr ? entry.fixed() : entry.counted(parseCount(spec, entry));
    scene.name = spec;
    return scene;
  }
  throwUnknown(spec);
}

}  // namespace steradian
