#pragma once
/// Pictures that are compared bit by bit, and scenes for them.
#include <string>
#include <vector>

#include "steradian/integrators/render/render.h"

namespace steradian::test {

/// Every kind of shape and of material, an area, a point and a spot light.
SceneDescription everythingRoom();
/// The same without a texture, so that it is tested with all lanes at once.
SceneDescription plainRoom();
/// A grey room with a box and a ball of the same grey in it.
SceneDescription greyRoom();
/// With a fuzzy and a glass ball and a varnished box, and one wall of another colour.
SceneDescription colouredRoom();
/// Under the sky, with a distant light and a lamp: paths leave the scene.
SceneDescription openScene();

/// Without a hierarchy, for up to 64 clusters.
inline const SceneSettings kFlat{.geometry = {.accel = {.maxClustersWithoutTree = 64}}, .lights = {}};

struct Rendered {
  std::vector<float> values;
  PathCounts counts;
};
/// By an integrator's spec, `width=` included.
Rendered renderWith(const Scene& scene, const std::string& integrator, const RenderSettings& settings);

Image pictureOf(const Scene& scene, const std::string& integrator, const RenderSettings& settings);

/// Also what was counted.
void expectEqual(const Rendered& a, const Rendered& b, const std::string& what);

}  // namespace steradian::test
