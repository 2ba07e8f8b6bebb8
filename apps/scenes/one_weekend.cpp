/// "Ray Tracing in One Weekend" v4, sections 13 and 14; "Ray Tracing: The Next Week" v4, section 2.6.
#include "steradian/apps/scenes/builders.h"
#include "steradian/core/samplers/rng.h"

namespace steradian::scenes {

namespace {

/// The random numbers in [0, 1) that belong to one small sphere.
class SphereRandom {
 public:
  SphereRandom(int column, int row)
      : stream_(static_cast<std::uint32_t>(column + 11), static_cast<std::uint32_t>(row + 11), 0, 0x7765656bu) {}
  float next() { return stream_.next(); }
  float between(float low, float high) { return low + (high - low) * next(); }
  Rgb colour(float low, float high) {
    const float r = between(low, high), g = between(low, high), b = between(low, high);
    return {r, g, b};
  }

 private:
  RandomStream stream_;
};

/// The cover: small spheres in a grid of cells, and three large ones. `ground` makes the material that they lie on;
/// `bouncing`: the small matte ones rise by up to 0.5 while the shutter is open.
template <class Ground>
SceneDescription coverScene(const Ground& ground, bool bouncing) {
  SceneDescription scene;
  SphereSet spheres;
  std::vector<Id> materials;
  const auto add = [&](Vec3f center, float radius, Id material) {
    spheres.add(center, radius);
    materials.push_back(material);
  };
  const auto lambert = [&](const char* name, Rgb c) {
    return scene.addMaterial(name, LambertMaterial{scene.addColour(c)});
  };
  const auto metal = [&](const char* name, Rgb c, float fuzz) {
    return scene.addMaterial(name, MetalMaterial{scene.addColour(c), fuzz});
  };
  const Id glass = scene.addMaterial("glass", DielectricMaterial{.eta = 1.5f});

  add({0.0f, -1000.0f, 0.0f}, 1000.0f, ground(scene));
  for (int column = -11; column < 11; ++column) {
    for (int row = -11; row < 11; ++row) {
      SphereRandom random(column, row);
      const float choice = random.next();
      const float x = static_cast<float>(column) + 0.9f * random.next();
      const float z = static_cast<float>(row) + 0.9f * random.next();
      const Vec3f center{x, 0.2f, z};
      if (length(center - Vec3f{4.0f, 0.2f, 0.0f}) <= 0.9f) continue;
      if (choice < 0.8f) {
        const Rgb a = random.colour(0.0f, 1.0f), b = random.colour(0.0f, 1.0f);
        const Id matte = lambert("matte", a * b);
        if (bouncing) {
          spheres.addMoving(center, center + Vec3f{0.0f, random.between(0.0f, 0.5f), 0.0f}, 0.2f);
          materials.push_back(matte);
        } else {
          add(center, 0.2f, matte);
        }
      } else if (choice < 0.95f) {
        const Rgb c = random.colour(0.5f, 1.0f);
        add(center, 0.2f, metal("metal", c, random.between(0.0f, 0.5f)));
      } else {
        add(center, 0.2f, glass);
      }
    }
  }
  add({0.0f, 1.0f, 0.0f}, 1.0f, glass);
  add({-4.0f, 1.0f, 0.0f}, 1.0f, lambert("brown", {0.4f, 0.2f, 0.1f}));
  add({4.0f, 1.0f, 0.0f}, 1.0f, metal("bronze mirror", {0.7f, 0.6f, 0.5f}, 0.0f));
  const Id shape = scene.addShape("spheres", std::move(spheres), glass);
  scene.shapes[shape].primitiveMaterials = std::move(materials);
  scene.camera = PerspectiveCamera{.lookFrom = {13.0f, 2.0f, 3.0f},
                                   .lookAt = {0.0f, 0.0f, 0.0f},
                                   .verticalFov = 20.0f,
                                   .defocusAngle = 0.6f,
                                   .focusDistance = 10.0f};
  return scene;
}

}  // namespace

GradientSky bookSky() { return {.nadir = {1.0f, 1.0f, 1.0f}, .zenith = {0.5f, 0.7f, 1.0f}}; }

SceneDescription oneWeekend() {
  const auto ground = [](SceneDescription& scene) {
    return scene.addMaterial("ground", LambertMaterial{scene.addColour({0.5f, 0.5f, 0.5f})});
  };
  SceneDescription scene = coverScene(ground, false);
  scene.addLight("sky", bookSky());
  scene.defaults = {.width = 1200, .height = 675, .samplesPerPixel = 100, .maxDepth = 49};
  return scene;
}

SceneDescription bouncingSpheres() {
  const auto ground = [](SceneDescription& scene) {
    const Id even = scene.addColour({0.2f, 0.3f, 0.1f}), odd = scene.addColour({0.9f, 0.9f, 0.9f});
    const Id checker = scene.addTexture(CheckerTexture{.even = even, .odd = odd, .scale = 0.32f});
    return scene.addMaterial("checkered", LambertMaterial{checker});
  };
  SceneDescription scene = coverScene(ground, true);
  scene.addLight("sky", ConstantSky{{0.7f, 0.8f, 1.0f}});
  scene.defaults = {.width = 400, .height = 225, .samplesPerPixel = 100, .maxDepth = 49};
  return scene;
}

SceneDescription oneWeekendMaterials() {
  SceneDescription scene;
  const auto add = [&](const char* name, Vec3f center, float radius, MaterialModel model) {
    SphereSet set;
    set.add(center, radius);
    scene.addShape(name, std::move(set), scene.addMaterial(name, model));
  };
  add("ground", {0.0f, -100.5f, -1.0f}, 100.0f, LambertMaterial{scene.addColour({0.8f, 0.8f, 0.0f})});
  add("matte", {0.0f, 0.0f, -1.2f}, 0.5f, LambertMaterial{scene.addColour({0.1f, 0.2f, 0.5f})});
  add("glass", {-1.0f, 0.0f, -1.0f}, 0.5f, DielectricMaterial{.eta = 1.5f});
  add("bubble", {-1.0f, 0.0f, -1.0f}, 0.4f, DielectricMaterial{.eta = 1.0f / 1.5f});
  add("metal", {1.0f, 0.0f, -1.0f}, 0.5f, MetalMaterial{scene.addColour({0.8f, 0.6f, 0.2f}), 1.0f});
  scene.addLight("sky", bookSky());
  scene.camera = PerspectiveCamera{.lookFrom = {-2.0f, 2.0f, 1.0f},
                                   .lookAt = {0.0f, 0.0f, -1.0f},
                                   .verticalFov = 20.0f,
                                   .defocusAngle = 10.0f,
                                   .focusDistance = 3.4f};
  scene.defaults = {.width = 400, .height = 225, .samplesPerPixel = 100, .maxDepth = 49};
  return scene;
}

}  // namespace steradian::scenes
