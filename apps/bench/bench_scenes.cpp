#include "steradian/apps/bench/bench_scenes.h"

#include <cmath>
#include <numbers>

#include "steradian/apps/scenes/builders.h"
#include "steradian/apps/scenes/scenes.h"

namespace steradian::bench {
namespace {

constexpr std::string_view kMeshRoom = "mesh-room:";

/// A closed surface over a grid of (phi, theta): `position` at each vertex, normals from its neighbours.
template <class Position>
TriangleMesh gridMesh(std::uint32_t columns, std::uint32_t rows, const Position& position) {
  TriangleMesh mesh;
  const auto at = [&](float column, float row) {
    return position(2.0f * std::numbers::pi_v<float> * column / static_cast<float>(columns),
                    std::numbers::pi_v<float> * row / static_cast<float>(rows));
  };
  for (std::uint32_t r = 0; r <= rows; ++r) {
    for (std::uint32_t c = 0; c <= columns; ++c) {
      const auto column = static_cast<float>(c), row = static_cast<float>(r);
      mesh.positions.push_back(at(column, row));
      const float nearRow = minimum(maximum(row, 0.5f), static_cast<float>(rows) - 0.5f);  // not at the poles
      const Vec3f alongRow = at(column + 0.5f, nearRow) - at(column - 0.5f, nearRow);
      const Vec3f alongColumn = at(column, nearRow + 0.5f) - at(column, nearRow - 0.5f);
      mesh.normals.push_back(normalize(cross(alongRow, alongColumn)));
    }
  }
  for (std::uint32_t r = 0; r < rows; ++r) {
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t a = r * (columns + 1) + c, b = a + columns + 1;
      if (r > 0) mesh.indices.insert(mesh.indices.end(), {a, a + 1, b});
      if (r + 1 < rows) mesh.indices.insert(mesh.indices.end(), {a + 1, b + 1, b});
    }
  }
  return mesh;
}

}  // namespace

SceneDescription meshRoom(std::uint32_t triangles) {
  SceneDescription scene;
  scenes::addCornellWalls(scene);
  scenes::addCornellLight(scene, false);
  scene.camera = scenes::cornellCamera();
  // columns = 2 rows: 4 rows (rows - 1) triangles.
  const auto rows = static_cast<std::uint32_t>(std::ceil(0.5 * (1.0 + std::sqrt(1.0 + triangles))));
  const TriangleMesh ball = gridMesh(2 * rows, rows, [](float phi, float theta) {
    const float radius = 150.0f + 12.0f * std::sin(9.0f * phi) * std::sin(7.0f * theta);
    return Vec3f{278.0f, 200.0f, 278.0f} +
           Vec3f{std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)} * radius;
  });
  scene.addShape("ball", ball, scenes::whiteOf(scene));
  scene.name = std::string(kMeshRoom) + std::to_string(triangles);
  return scene;
}

SceneDescription benchScene(const std::string& name) {
  if (name.starts_with(kMeshRoom))
    return meshRoom(static_cast<std::uint32_t>(std::stoul(name.substr(kMeshRoom.size()))));
  return makeScene(name);
}

}  // namespace steradian::bench
