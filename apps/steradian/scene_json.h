#pragma once
/// A scene description as JSON, complete enough for another program to build the same scene.
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "steradian/core/scene/description.h"

namespace steradian::app {

/// Keys and units are those of core/scene/description.h (textures, materials, shapes, groups, instances, lights,
/// camera, defaults), ids are indices, a missing id is null; "counts" sums up the primitives by kind, instances
/// expanded.
nlohmann::json toJson(const SceneDescription& scene);

/// Number of primitives by name of their kind, instances expanded: a shape of a group counts once per instance.
std::map<std::string, std::uint64_t> countPrimitives(const SceneDescription& scene);

}  // namespace steradian::app
