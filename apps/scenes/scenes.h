#pragma once
/// The built-in scenes: those of Peter Shirley's books, and generated ones of any size.
///
/// Book scenes have the books' coordinates, colours, cameras and sample counts; where a book draws random numbers, ours
/// come from the counter-based generator, so that every machine has the same scene.
#include <span>
#include <string_view>

#include "steradian/core/scene/description.h"

namespace steradian {

struct SceneInfo {
  std::string_view name;     ///< a trailing ":N" means: takes a count
  std::string_view summary;  ///< one line
};

/// All built-in scenes, in the order of the books.
std::span<const SceneInfo> builtInScenes();

/// Builds the scene called `spec`: a name, and for generated scenes ":N" with N >= 1 ("cornell-city:1000").
/// Throws Error (Usage) with a suggestion for an unknown name or a bad count.
SceneDescription makeScene(std::string_view spec);

}  // namespace steradian
