#pragma once
/// Fail at the start with a message rather than be killed hours later.
#include <cstdint>
#include <filesystem>

#include "steradian/core/film/film.h"
#include "steradian/core/scene/description.h"

namespace steradian::app {

/// Memory available to this process in bytes, by /proc/meminfo and the limits of its control group (version 2); the
/// largest number if neither is known. `root` is where the system's files are, for tests.
std::uint64_t availableMemory(const std::filesystem::path& root = "/");

/// Throws Error (Memory) if what is built from the scene, not counting the description itself, does not fit in
/// `available` bytes.
void checkMemory(const SceneDescription& scene, std::uint64_t available);

/// Throws Error (Memory) if the film of such a picture, the image made of it and its file do not fit in `available`
/// bytes together.
void checkMemory(int width, int height, std::uint32_t replicates, std::uint64_t available);

}  // namespace steradian::app
