#include "steradian/apps/bench/books_world.h"

#include <cmath>
#include <string>
#include <utility>

#include "steradian/core/scene/placements.h"

namespace steradian::bench::books {
namespace {

/// Longer lists become hierarchies.
constexpr std::size_t kLongList = 16;

[[noreturn]] void throwMissing(const std::string& what) {
  throw Error(ErrorKind::Usage, "the books' renderer has no " + what);
}

template <class T>
Vec vectorAt(const std::vector<T>& x, const std::vector<T>& y, const std::vector<T>& z, std::size_t i) {
  return {static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])};
}

Object together(std::vector<Object> objects) {
  if (objects.size() == 1) return std::move(objects.front());
  if (objects.size() > kLongList) return makeHierarchy(std::move(objects));
  return std::make_unique<List>(std::move(objects));
}

/// Turned about y, then moved.
struct Placement {
  double sine = 0.0, cosine = 1.0;
  Vec offset{};

  /// Throws Error if the matrix is another transform.
  static Placement of(const Matrix& m) {
    const auto at = [&](int row, int column) { return static_cast<double>(m[row][column]); };
    Placement placement{at(2, 0), at(0, 0), {at(3, 0), at(3, 1), at(3, 2)}};
    // Row vectors: x' = cos x + sin z, z' = cos z - sin x.
    const double expected[3][3] = {
        {placement.cosine, 0.0, -placement.sine}, {0.0, 1.0, 0.0}, {placement.sine, 0.0, placement.cosine}};
    double error = std::fabs(std::hypot(placement.sine, placement.cosine) - 1.0);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        error = std::max(error, std::fabs(at(row, column) - expected[row][column]));
    if (error > 1e-5) throwMissing("transforms but turns about the y axis and translations");
    return placement;
  }

  Object operator()(Object object) const {
    if (sine != 0.0) object = std::make_unique<RotatedY>(std::move(object), sine, cosine);
    return std::make_unique<Translated>(std::move(object), offset);
  }
};

class WorldBuilder {
 public:
  explicit WorldBuilder(const SceneDescription& scene) : scene_(scene) {}

  World build() &&;

 private:
  template <class T, class... Arguments>
  const T* addTexture(Arguments&&... arguments) {
    auto texture = std::make_unique<T>(std::forward<Arguments>(arguments)...);
    const T* const made = texture.get();
    world_.textures.push_back(std::move(texture));
    return made;
  }
  template <class T, class... Arguments>
  const T* addMaterial(Arguments&&... arguments) {
    auto material = std::make_unique<T>(std::forward<Arguments>(arguments)...);
    const T* const made = material.get();
    world_.materials.push_back(std::move(material));
    return made;
  }

  const Texture* texture(Id id);
  const Texture* makeTexture(const TextureDescription& description);
  const Material* material(Id id);
  const Material* makeMaterial(const MaterialModel& model);
  const Material* lightOf(const ShapeDescription& shape);
  Object medium(Id id, Object boundary);

  Object primitive(const ShapeGeometry& geometry, std::size_t i, const Material* of);
  void addShape(const ShapeDescription& shape, std::vector<Object>& to);
  void addInstances(const Placements& placements, std::vector<Object>& to);
  void setBackground();

  const SceneDescription& scene_;
  World world_;
  std::vector<const Texture*> textures_;    ///< by id, null until needed
  std::vector<const Material*> materials_;  ///< likewise
};

// --- Textures and materials -------------------------------------------------------------------------------------

const Texture* WorldBuilder::texture(Id id) {
  if (id == kNone) return addTexture<SolidColour>(Colour{});
  if (textures_[id] == nullptr) textures_[id] = makeTexture(scene_.textures[id]);
  return textures_[id];
}

const Texture* WorldBuilder::makeTexture(const TextureDescription& description) {
  if (const auto* constant = std::get_if<ConstantTexture>(&description))
    return addTexture<SolidColour>(inDoubles(constant->value));
  if (const auto* checker = std::get_if<CheckerTexture>(&description)) {
    const bool inSpace = checker->space == CheckerTexture::Space::World;
    const auto scale = static_cast<double>(checker->scale);
    return addTexture<Checker>(texture(checker->even), texture(checker->odd), inSpace ? 1.0 / scale : scale, inSpace);
  }
  if (const auto* image = std::get_if<ImageTexture>(&description)) return addTexture<Picture>(*image);
  return addTexture<Noise>(std::get<NoiseTexture>(description));
}

const Material* WorldBuilder::material(Id id) {
  if (id == kNone) return addMaterial<Black>();
  if (materials_[id] == nullptr) materials_[id] = makeMaterial(scene_.materials[id].model);
  return materials_[id];
}

const Material* WorldBuilder::makeMaterial(const MaterialModel& model) {
  if (std::holds_alternative<AbsorberMaterial>(model)) return addMaterial<Black>();
  if (const auto* lambert = std::get_if<LambertMaterial>(&model))
    return addMaterial<Lambertian>(texture(lambert->reflectance));
  if (const auto* metal = std::get_if<MetalMaterial>(&model))
    return addMaterial<Metal>(texture(metal->reflectance), static_cast<double>(metal->fuzz));
  if (const auto* glass = std::get_if<DielectricMaterial>(&model))
    return addMaterial<Glass>(static_cast<double>(glass->eta), glass->schlick);
  if (const auto* uniform = std::get_if<UniformDiffuseMaterial>(&model))
    return addMaterial<Hemispherical>(texture(uniform->reflectance));
  throwMissing("coats");
}

/// Lights only emit.
const Material* WorldBuilder::lightOf(const ShapeDescription& shape) {
  const bool isBlack =
      shape.material == kNone || (shape.primitiveMaterials.empty() &&
                                  std::holds_alternative<AbsorberMaterial>(scene_.materials[shape.material].model));
  if (!isBlack) throwMissing("lights that scatter");
  const SurfaceEmission& emission = scene_.emissions[shape.emission];
  return addMaterial<Light>(inDoubles(emission.radiance), emission.twoSided);
}

Object WorldBuilder::medium(Id id, Object boundary) {
  const MediumDescription& medium = scene_.media[id];
  const Colour scattering = inDoubles(medium.scattering), total = scattering + inDoubles(medium.absorption);
  if (std::fabs(total.r - total.g) > 1e-6 * total.r || std::fabs(total.r - total.b) > 1e-6 * total.r || total.r <= 0.0)
    throwMissing("media that weaken one colour more than another");
  if (medium.anisotropy != 0.0f) throwMissing("media that scatter forwards or backwards");
  if (medium.emission.r > 0.0f || medium.emission.g > 0.0f || medium.emission.b > 0.0f)
    throwMissing("media that shine");
  return std::make_unique<ConstantMedium>(std::move(boundary), total.r, addMaterial<Isotropic>(scattering / total.r));
}

// --- Shapes -----------------------------------------------------------------------------------------------------

struct MakePrimitive {
  std::size_t i;
  const Material* of;

  Object operator()(const SphereSet& s) const {
    const Vec from = vectorAt(s.centerX, s.centerY, s.centerZ, i);
    const Vec move = s.moveX.empty() ? Vec{} : vectorAt(s.moveX, s.moveY, s.moveZ, i);
    return std::make_unique<Sphere>(from, from + move, static_cast<double>(s.radius[i]), of);
  }
  Object operator()(const QuadSet& s) const {
    return std::make_unique<Quad>(vectorAt(s.cornerX, s.cornerY, s.cornerZ, i), vectorAt(s.uX, s.uY, s.uZ, i),
                                  vectorAt(s.vX, s.vY, s.vZ, i), of);
  }
  Object operator()(const BoxSet& s) const {
    const Vec center = vectorAt(s.centerX, s.centerY, s.centerZ, i), half = vectorAt(s.halfX, s.halfY, s.halfZ, i);
    if (s.rotationW.empty()) return makeBox(center - half, center + half, of);
    if (s.rotationX[i] != 0.0f || s.rotationZ[i] != 0.0f) throwMissing("boxes turned but about the y axis");
    const auto w = static_cast<double>(s.rotationW[i]), y = static_cast<double>(s.rotationY[i]);
    return Placement{2.0 * w * y, w * w - y * y, center}(makeBox(-half, half, of));
  }
  template <class Other>
  Object operator()(const Other&) const {
    throwMissing("shapes but spheres, quads and boxes");
  }
};

Object WorldBuilder::primitive(const ShapeGeometry& geometry, std::size_t i, const Material* of) {
  return std::visit(MakePrimitive{i, of}, geometry);
}

void WorldBuilder::addShape(const ShapeDescription& shape, std::vector<Object>& to) {
  if (shape.motion) throwMissing("moving shapes but spheres");
  if (shape.interior && shape.interior->priority > 0) throwMissing("priorities");
  const bool isFilled = shape.interior && shape.interior->medium != kNone;
  const Material* const light = shape.emission != kNone ? lightOf(shape) : nullptr;
  std::vector<Object> objects;
  for (std::size_t i = 0; i < primitiveCount(shape.geometry); ++i) {
    const Id id = shape.primitiveMaterials.empty() ? shape.material : shape.primitiveMaterials[i];
    const bool isOpen = id != kNone && std::holds_alternative<InterfaceMaterial>(scene_.materials[id].model);
    if (!isOpen) objects.push_back(primitive(shape.geometry, i, light != nullptr ? light : material(id)));
    if (isFilled) objects.push_back(medium(shape.interior->medium, primitive(shape.geometry, i, nullptr)));
  }
  if (objects.size() > kLongList) return to.push_back(makeHierarchy(std::move(objects)));
  for (Object& object : objects) to.push_back(std::move(object));
}

void WorldBuilder::addInstances(const Placements& placements, std::vector<Object>& to) {
  placements.forEachInstance([&](const InstancePlacement& instance) {
    if (instance.motion()) throwMissing("moving instances");
    std::vector<Object> objects;  // one copy per instance; the books share them, at the same cost per ray
    for (const Id shape : placements.shapesOf(instance)) addShape(scene_.shapes[shape], objects);
    if (!objects.empty()) to.push_back(Placement::of(instance.localToWorld())(together(std::move(objects))));
  });
}

void WorldBuilder::setBackground() {
  for (const LightDescription& light : scene_.lights) {
    if (const auto* constant = std::get_if<ConstantSky>(&light.model)) {
      world_.background.nadir += inDoubles(constant->radiance);
      world_.background.zenith += inDoubles(constant->radiance);
    } else if (const auto* gradient = std::get_if<GradientSky>(&light.model)) {
      world_.background.nadir += inDoubles(gradient->nadir);
      world_.background.zenith += inDoubles(gradient->zenith);
    } else {
      throwMissing("lights but surfaces and plain skies");
    }
  }
}

World WorldBuilder::build() && {
  textures_.resize(scene_.textures.size());
  materials_.resize(scene_.materials.size());
  const auto* camera = std::get_if<PerspectiveCamera>(&scene_.camera);
  if (scene_.outside != kNone) throwMissing("media around everything");
  if (camera == nullptr) throwMissing("cameras but the perspective one");
  world_.camera = *camera;
  world_.maxDepth = scene_.defaults.maxDepth + 1;
  setBackground();
  const Placements placements(scene_);
  std::vector<Object> objects;
  for (const Id shape : placements.directShapes()) addShape(scene_.shapes[shape], objects);
  addInstances(placements, objects);
  world_.root = objects.empty() ? std::make_unique<List>(std::move(objects)) : together(std::move(objects));
  return std::move(world_);
}

}  // namespace

Colour Background::value(Vec direction) const {
  const double up = 0.5 * (unit(direction).y + 1.0);
  return nadir * (1.0 - up) + zenith * up;
}

World makeWorld(const SceneDescription& scene) { return WorldBuilder(scene).build(); }

}  // namespace steradian::bench::books
