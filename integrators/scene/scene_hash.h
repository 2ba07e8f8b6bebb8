#pragma once
/// A fingerprint of what a scene looks like, for image metadata: do two files show the same scene?
#include <cstdint>
#include <string>

#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

/// The same on every machine. Depends on everything that a picture depends on, in its order; not on names, source
/// ranges and render defaults. Custom shapes count by their bounds.
std::uint64_t sceneHash(const SceneDescription& scene);

/// As 16 hexadecimal digits.
std::string sceneHashText(std::uint64_t hash);

}  // namespace steradian
