#include "steradian/integrators/render/rendered_image.h"

#include <string>

#include "steradian/core/scene/camera.h"
#include "steradian/integrators/scene/scene_hash.h"

namespace steradian {
namespace {

std::vector<float> rowMajor(const Matrix& m) {
  const float* values = m.getValue();
  return std::vector<float>(values, values + 16);
}

}  // namespace

Image renderedImage(const RenderResult& result, const Scene& scene, const FilmImageOptions& options) {
  Image image = result.film.image(options);
  const FilmSettings& film = result.film.settings();
  const Camera camera(scene.description().camera, film.width, film.height);
  Metadata& metadata = image.metadata();
  metadata["worldToCamera"] = rowMajor(camera.worldToCamera());
  if (camera.worldToNdc()) metadata["worldToNDC"] = rowMajor(*camera.worldToNdc());
  metadata["chromaticities"] = std::vector<float>{0.64f, 0.33f, 0.30f, 0.60f, 0.15f, 0.06f, 0.3127f, 0.3290f};
  metadata["software"] = std::string("Steradian");
  metadata["renderTime"] = result.statistics.renderSeconds;
  metadata["steradian.scene"] = scene.description().name;
  metadata["steradian.sceneHash"] = sceneHashText(scene.hash());
  // As text: EXR has no unsigned integers.
  metadata["steradian.seed"] = std::to_string(result.settings.seed);
  metadata["steradian.replicates"] = std::to_string(result.settings.replicates);
  metadata["steradian.correlatedPixels"] = std::to_string(result.statistics.correlatedPixels);
  metadata["steradian.sampler"] = std::string(nameOf(result.settings.sampler));
  metadata["steradian.ledger"] = result.film.ledger().text();
  return image;
}

}  // namespace steradian
