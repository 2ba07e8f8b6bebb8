/// Scenes of any size, as formulas of N (stated in builders.h).
#include <cmath>

#include "steradian/apps/scenes/builders.h"
#include "steradian/core/samplers/rng.h"

namespace steradian::scenes {

namespace {

constexpr float kSide = 555.0f;
constexpr float kPitch = 565.0f;  ///< of the rooms of a tower: walls of neighbours must not coincide

std::uint32_t squareSide(std::uint32_t count) {
  auto side = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
  while (static_cast<std::uint64_t>(side) * side < count) ++side;
  return side;
}

}  // namespace

SceneDescription cornellCity(std::uint32_t boxes) {
  SceneDescription scene;
  addCornellWalls(scene);
  addCornellLight(scene, false);
  const std::uint32_t side = squareSide(boxes);
  const float cell = kSide / static_cast<float>(side);
  BoxSet set;
  for (auto* column : {&set.centerX, &set.centerY, &set.centerZ, &set.halfX, &set.halfY, &set.halfZ, &set.rotationW,
                       &set.rotationX, &set.rotationY, &set.rotationZ})
    column->reserve(boxes);
  for (std::uint32_t i = 0; i < boxes; ++i) {
    const auto words = randomWords<std::uint32_t>(i, 0, 0, 0x63697479u);
    const auto random = [&](std::size_t k) { return toUnitFloat<float>(words[k]); };
    const float edgeX = cell * (0.3f + 0.35f * random(0)), edgeZ = cell * (0.3f + 0.35f * random(1));
    const float height = 40.0f + 290.0f * random(2) * random(2);
    const std::uint32_t column = i % side, row = i / side;
    const Vec3f center{cell * (static_cast<float>(column) + 0.5f), 0.5f * height,
                       cell * (static_cast<float>(row) + 0.5f)};
    set.addRotatedY(center, {0.5f * edgeX, 0.5f * height, 0.5f * edgeZ}, 90.0f * random(3));
  }
  scene.addShape("city", std::move(set), whiteOf(scene));
  scene.camera = cornellCamera();
  scene.defaults = {.width = 600, .height = 600, .samplesPerPixel = 64, .maxDepth = 49};
  return scene;
}

SceneDescription cornellTower(std::uint32_t rooms) {
  SceneDescription scene;
  Group room{"room", addCornellWalls(scene)};
  room.shapes.push_back(addCornellLight(scene, false));
  room.shapes.push_back(addTallBox(scene, whiteOf(scene)));
  room.shapes.push_back(addShortBox(scene, whiteOf(scene)));
  scene.groups.push_back(std::move(room));

  const std::uint32_t columns = squareSide(rooms), floors = (rooms + columns - 1) / columns;
  InstanceSet set;
  set.group = 0;
  set.transforms.reserve(rooms);
  for (std::uint32_t i = 0; i < rooms; ++i) {
    const std::uint32_t column = i % columns, floor = i / columns;
    Matrix move;
    move.setTranslation(Imath::V3f(kPitch * static_cast<float>(column), kPitch * static_cast<float>(floor), 0.0f));
    set.transforms.push_back(move);
  }
  scene.instances.push_back(std::move(set));

  // The camera of the single room, moved back until the whole front fits: for N = 1 it is the Cornell box's.
  const float width = kPitch * static_cast<float>(columns - 1), height = kPitch * static_cast<float>(floors - 1);
  const Vec3f center{278.0f + 0.5f * width, 278.0f + 0.5f * height, 0.0f};
  const float back = 800.0f + 0.5f * maximum(width, height) / std::tan(0.5f * 40.0f * kPi / 180.0f);
  PerspectiveCamera camera = cornellCamera();
  camera.lookAt = center;
  camera.lookFrom = center - Vec3f{0.0f, 0.0f, back};
  scene.camera = camera;
  scene.defaults = {.width = 600, .height = 600, .samplesPerPixel = 64, .maxDepth = 49};
  return scene;
}

}  // namespace steradian::scenes
