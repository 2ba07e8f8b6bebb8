#pragma once
/// The scenes that benchmarks know by name: the built-in ones, and one with a mesh.
#include <string>

#include "steradian/core/scene/description.h"

namespace steradian::bench {

/// The empty Cornell room with a bumpy ball of at least so many triangles, which have vertex normals. Vertices lie on a
/// grid of angles, at the distance 150 + 12 sin(9 phi) sin(7 theta) from (278, 200, 278).
SceneDescription meshRoom(std::uint32_t triangles);

/// A built-in scene, or `mesh-room:N`. Throws as makeScene() does.
SceneDescription benchScene(const std::string& name);

}  // namespace steradian::bench
