#include "outside.h"

#include <steradian/core/scene/custom_shape.h>
#include <steradian/integrators/render/render.h>

#include <memory>

namespace {

using namespace steradian;

/// The plane z = 0, in front of the camera.
class Wall final : public CustomShape {
 public:
  Bounds3 bounds() const override { return {{-10.0f, -10.0f, 0.0f}, {10.0f, 10.0f, 0.0f}}; }
  std::optional<CustomHit> intersect(const Ray<float>& ray) const override {
    const float t = -ray.origin.z / ray.direction.z;
    if (!(t > ray.tMin && t < ray.tMax)) return std::nullopt;
    return CustomHit{t, {0.0f, 0.0f, 1.0f}, {}};
  }
};

class Constant final : public RadianceIntegrator {
 public:
  Rgb radiance(const Scene&, const Ray<float>&, const Sampler<float>&) const override { return grey(0.5f); }
};

}  // namespace

float renderABit() {
  SceneDescription scene;
  const Id white = scene.addMaterial("white", LambertMaterial{scene.addColour({1.0f, 1.0f, 1.0f})});
  scene.addShape("wall", CustomShapeSet{{std::make_shared<Wall>()}}, white);
  scene.camera = PerspectiveCamera{.lookFrom = {0.0f, 0.0f, 4.0f}, .lookAt = {0.0f, 0.0f, 0.0f}};
  RenderSettings settings;
  settings.width = settings.height = 4;
  settings.samplesPerPixel = 1;
  const Film film = render(Scene(std::move(scene)), Constant(), settings).film;
  const Image image = film.image();
  return image.at(2, 2, image.channel("A")) * film.radiance(2, 2).g;
}

void failALot() {
  SceneDescription scene;
  scene.addShape("ball", SphereSet{{0.0f}, {0.0f}, {0.0f}, {-1.0f}}, 7);
  const Scene broken(std::move(scene));
}
