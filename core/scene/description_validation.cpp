#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "steradian/core/scene/camera.h"
#include "steradian/core/scene/description.h"

namespace steradian {

namespace {

bool finite(Vec3f v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }
bool finite(Rgb c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }
bool nonNegative(Rgb c) { return finite(c) && c.r >= 0.0f && c.g >= 0.0f && c.b >= 0.0f; }
bool zero(Vec3f v) { return !(lengthSquared(v) > 0.0f); }

/// Reports what is wrong with the parts of one description.
class Validator {
 public:
  Validator(const SceneDescription& scene, Diagnostics& out) : scene_(scene), out_(out) {}

  void run() {
    for (std::size_t i = 0; i < scene_.textures.size(); ++i) {
      checkTexture(i);
      reflects_.push_back(reflects(scene_.textures[i]));
    }
    for (const MaterialDescription& m : scene_.materials) checkMaterial(m);
    for (const MediumDescription& m : scene_.media) checkMedium(m);
    checkOutside();
    for (const SurfaceEmission& e : scene_.emissions)
      if (!nonNegative(e.radiance)) error({}, "an emission's radiance must be finite and not negative");
    for (const ShapeDescription& s : scene_.shapes) checkShape(s);
    checkGroups();
    for (const LightDescription& l : scene_.lights) checkLight(l);
    const Diagnostics camera = validate(scene_.camera);
    for (const Diagnostic& d : camera.items()) out_.add(d);
    checkDefaults();
  }

 private:
  void error(const SourceRange& where, std::string message) { out_.error(where, std::move(message)); }

  bool textureExists(Id id) const { return id < scene_.textures.size(); }

  void checkTexture(std::size_t index) {
    if (const auto* image = std::get_if<ImageTexture>(&scene_.textures[index])) {
      checkPicture(image->image.get(), {}, fmt::format("texture {}", index));
      const auto usable = [](float repeat) { return std::isfinite(repeat) && repeat != 0.0f; };
      if (!usable(image->repeatU) || !usable(image->repeatV))
        error({}, fmt::format("texture {}: an image fits into the surface a finite number of times, not 0", index));
      return;
    }
    if (const auto* noise = std::get_if<NoiseTexture>(&scene_.textures[index])) {
      if (!nonNegative(noise->colour) || !std::isfinite(noise->scale) || noise->octaves < 1 || noise->octaves > 16)
        error({}, fmt::format("texture {}: noise needs a colour, a finite scale and 1 to 16 octaves", index));
      return;
    }
    if (const auto* constant = std::get_if<ConstantTexture>(&scene_.textures[index])) {
      if (!finite(constant->value)) error({}, fmt::format("texture {} has a value that is not finite", index));
      return;
    }
    const auto& checker = std::get<CheckerTexture>(scene_.textures[index]);
    if (!(checker.scale > 0.0f) || !std::isfinite(checker.scale))
      error({}, fmt::format("texture {}: a checker's scale must be positive", index));
    // A texture may only refer to earlier ones: no cycle can be written, and one pass resolves all.
    if (checker.even >= index || checker.odd >= index)
      error({}, fmt::format("texture {}: a checker must refer to textures defined before it", index));
  }

  /// Whether all colours of a texture lie in [0, 1]; images are clamped.
  bool reflects(const TextureDescription& texture) const {
    const auto within = [](Rgb c) { return nonNegative(c) && maxChannel(c) <= 1.0f; };
    if (const auto* constant = std::get_if<ConstantTexture>(&texture)) return within(constant->value);
    if (const auto* noise = std::get_if<NoiseTexture>(&texture)) return within(noise->colour);
    const auto* checker = std::get_if<CheckerTexture>(&texture);
    const auto earlier = [&](Id id) { return id >= reflects_.size() || reflects_[id]; };
    return checker == nullptr || (earlier(checker->even) && earlier(checker->odd));
  }

  void checkPicture(const Image* image, const SourceRange& where, const std::string& owner) {
    if (image == nullptr || (!image->findRgb() && image->channelCount() != 1)) {
      error(where, owner + " needs a picture with the channels R, G and B, or with a single one");
      return;
    }
    if (image->values().size() >= std::size_t{1} << 31)
      error(where, owner + " has a picture of more than 2^31 - 1 values");
    const auto channels = static_cast<std::size_t>(image->channelCount());
    const std::array<int, 3> colours = image->findRgb().value_or(std::array<int, 3>{0, 0, 0});
    for (std::size_t pixel = 0; pixel < image->pixelCount(); ++pixel) {
      const float* values = image->values().data() + pixel * channels;
      if (finite(Rgb{values[colours[0]], values[colours[1]], values[colours[2]]})) continue;
      const auto width = static_cast<std::size_t>(image->width());
      error(where, fmt::format("{}: the colour of pixel ({}, {}) of its picture is not finite", owner, pixel % width,
                               pixel / width));
      return;
    }
  }

  void checkMedium(const MediumDescription& m) {
    if (!nonNegative(m.absorption) || !nonNegative(m.scattering) || !nonNegative(m.emission))
      error(m.where, fmt::format("medium \"{}\": its coefficients must be finite and not negative", m.name));
    if (!(std::abs(m.anisotropy) < 1.0f))
      error(m.where,
            fmt::format("medium \"{}\": anisotropy must lie between -1 and 1, not be {}", m.name, m.anisotropy));
  }

  void checkOutside() {
    if (scene_.outside == kNone) return;
    if (scene_.outside >= scene_.media.size()) {
      error({}, "the medium around everything is not in the scene");
      return;
    }
    const MediumDescription& m = scene_.media[scene_.outside];
    const auto endless = [](float emission, float absorption, float scattering) {
      return emission > 0.0f && !(absorption + scattering > 0.0f);
    };
    if (endless(m.emission.r, m.absorption.r, m.scattering.r) ||
        endless(m.emission.g, m.absorption.g, m.scattering.g) || endless(m.emission.b, m.absorption.b, m.scattering.b))
      error(m.where,
            fmt::format("medium \"{}\" is around everything and emits without absorbing: its radiance is infinite",
                        m.name));
  }

  bool isNothing(Id material) const {
    return material < scene_.materials.size() &&
           std::holds_alternative<InterfaceMaterial>(scene_.materials[material].model);
  }

  void checkReflectance(const MaterialDescription& m, Id texture) {
    if (!textureExists(texture)) {
      error(m.where, fmt::format("material \"{}\": its reflectance is no texture of the scene", m.name));
      return;
    }
    if (!reflects_[texture]) error(m.where, fmt::format("material \"{}\": a reflectance must lie in [0, 1]", m.name));
  }

  void checkEta(const MaterialDescription& m, float eta) {
    if (!(eta > 0.0f) || !std::isfinite(eta))
      error(m.where, fmt::format("material \"{}\": eta must be positive, not {}", m.name, eta));
  }

  void checkMaterial(const MaterialDescription& m) {
    std::visit([&](const auto& model) { checkModel(m, model); }, m.model);
  }
  void checkModel(const MaterialDescription&, const AbsorberMaterial&) {}
  void checkModel(const MaterialDescription&, const InterfaceMaterial&) {}
  void checkModel(const MaterialDescription& m, const LambertMaterial& lambert) {
    checkReflectance(m, lambert.reflectance);
  }
  void checkModel(const MaterialDescription& m, const MetalMaterial& metal) {
    checkReflectance(m, metal.reflectance);
    if (!(metal.fuzz >= 0.0f && metal.fuzz <= 1.0f))
      error(m.where, fmt::format("material \"{}\": fuzz must lie in [0, 1], not {}", m.name, metal.fuzz));
  }
  void checkModel(const MaterialDescription& m, const DielectricMaterial& dielectric) { checkEta(m, dielectric.eta); }
  void checkModel(const MaterialDescription& m, const UniformDiffuseMaterial& uniform) {
    checkReflectance(m, uniform.reflectance);
  }
  void checkModel(const MaterialDescription& m, const CoatedMaterial& coated) {
    checkReflectance(m, coated.reflectance);
    checkEta(m, coated.eta);
    if (coated.eta < 1.0f) error(m.where, fmt::format("material \"{}\": a coat's eta is at least 1", m.name));
  }

  void checkShape(const ShapeDescription& s) {
    const std::size_t count = primitiveCount(s.geometry);
    if (count >= kNone)
      error(s.where, fmt::format("shape \"{}\" has {} primitives; the limit is 2^32 - 2", s.name, count));
    if (!s.primitiveMaterials.empty() && s.primitiveMaterials.size() != count)
      error(s.where,
            fmt::format("shape \"{}\" has {} primitives but {} materials", s.name, count, s.primitiveMaterials.size()));
    const auto badMaterial = [&](Id id) { return id >= scene_.materials.size(); };
    bool bad = s.primitiveMaterials.empty() && badMaterial(s.material);
    for (const Id id : s.primitiveMaterials) bad = bad || badMaterial(id);
    if (bad) error(s.where, fmt::format("shape \"{}\" has a material that is not in the scene", s.name));
    if (s.emission != kNone && s.emission >= scene_.emissions.size())
      error(s.where, fmt::format("shape \"{}\" has an emission that is not in the scene", s.name));
    const bool invisible =
        isNothing(s.material) || std::any_of(s.primitiveMaterials.begin(), s.primitiveMaterials.end(),
                                             [&](Id material) { return isNothing(material); });
    if (s.emission != kNone && invisible)
      error(s.where,
            fmt::format("shape \"{}\" emits, but is a boundary that rays cross; a medium in it can emit", s.name));
    if (s.emission != kNone && std::holds_alternative<CustomShapeSet>(s.geometry))
      error(s.where, fmt::format("shape \"{}\": a custom shape cannot be a light", s.name));
    if (s.target && std::holds_alternative<CustomShapeSet>(s.geometry))
      error(s.where, fmt::format("shape \"{}\": a custom shape cannot be a sampling target", s.name));
    if (s.interior && s.interior->medium != kNone && s.interior->medium >= scene_.media.size())
      error(s.where, fmt::format("shape \"{}\" is filled with a medium that is not in the scene", s.name));
    if (s.interior && s.interior->priority < 0)
      error(s.where, fmt::format("shape \"{}\": a priority is at least 0, not {}", s.name, s.interior->priority));
    if (s.interior && (std::holds_alternative<QuadSet>(s.geometry) || std::holds_alternative<DiskSet>(s.geometry)))
      error(s.where,
            fmt::format("shape \"{}\" has an interior, but a {} encloses nothing", s.name, primitiveName(s.geometry)));
    if (s.motion && (!usable(s.motion->open) || !usable(s.motion->close)))
      error(s.where,
            fmt::format("shape \"{}\": the transforms of its motion must be affine, finite and invertible", s.name));
    else if (s.motion && !sameHandedness(s.motion->open, s.motion->close))
      error(s.where, fmt::format("shape \"{}\": only one of the transforms of its motion is a mirror", s.name));
    std::visit([&](const auto& set) { checkSet(s, set); }, s.geometry);
  }

  bool sameLength(const ShapeDescription& s, std::initializer_list<const std::vector<float>*> columns) {
    const std::size_t count = primitiveCount(s.geometry);
    for (const auto* column : columns) {
      if (column->size() == count) continue;
      error(s.where, fmt::format("shape \"{}\": its columns differ in length", s.name));
      return false;
    }
    return true;
  }

  /// Reports the first primitive for which `good` is false.
  template <class Good>
  void checkEach(const ShapeDescription& s, Good good, const char* rule) {
    const std::size_t count = primitiveCount(s.geometry);
    for (std::size_t i = 0; i < count; ++i) {
      if (good(i)) continue;
      error(s.where, fmt::format("shape \"{}\": {} {} {}", s.name, primitiveName(s.geometry), i, rule));
      return;
    }
  }

  void checkSet(const ShapeDescription& s, const SphereSet& set) {
    if (!sameLength(s, {&set.centerX, &set.centerY, &set.centerZ})) return;
    const bool moves = !set.moveX.empty();
    if (moves && !sameLength(s, {&set.moveX, &set.moveY, &set.moveZ})) return;
    checkEach(
        s,
        [&](std::size_t i) {
          return finite(Vec3f{set.centerX[i], set.centerY[i], set.centerZ[i]}) && set.radius[i] > 0.0f &&
                 std::isfinite(set.radius[i]) && (!moves || finite(Vec3f{set.moveX[i], set.moveY[i], set.moveZ[i]}));
        },
        "needs a finite centre and a positive radius");
  }

  void checkSet(const ShapeDescription& s, const QuadSet& set) {
    if (!sameLength(s, {&set.cornerY, &set.cornerZ, &set.uX, &set.uY, &set.uZ, &set.vX, &set.vY, &set.vZ})) return;
    checkEach(
        s,
        [&](std::size_t i) {
          const Vec3f u{set.uX[i], set.uY[i], set.uZ[i]}, v{set.vX[i], set.vY[i], set.vZ[i]};
          return finite(Vec3f{set.cornerX[i], set.cornerY[i], set.cornerZ[i]}) && finite(cross(u, v)) &&
                 !zero(cross(u, v));
        },
        "needs finite coordinates and an area above zero");
  }

  void checkSet(const ShapeDescription& s, const BoxSet& set) {
    if (!sameLength(s, {&set.centerY, &set.centerZ, &set.halfX, &set.halfY, &set.halfZ})) return;
    const bool rotated = !set.rotationW.empty();
    if (rotated && !sameLength(s, {&set.rotationW, &set.rotationX, &set.rotationY, &set.rotationZ})) return;
    checkEach(
        s,
        [&](std::size_t i) {
          const Vec3f half{set.halfX[i], set.halfY[i], set.halfZ[i]};
          return finite(Vec3f{set.centerX[i], set.centerY[i], set.centerZ[i]}) && finite(half) && half.x > 0.0f &&
                 half.y > 0.0f && half.z > 0.0f;
        },
        "needs a finite centre and positive edges");
    if (!rotated) return;
    checkEach(
        s,
        [&](std::size_t i) {
          const float norm =
              sqr(set.rotationW[i]) + sqr(set.rotationX[i]) + sqr(set.rotationY[i]) + sqr(set.rotationZ[i]);
          return std::abs(norm - 1.0f) < 1e-5f;
        },
        "needs a quaternion of unit length");
  }

  void checkSet(const ShapeDescription& s, const DiskSet& set) {
    if (!sameLength(s, {&set.centerX, &set.centerY, &set.centerZ, &set.normalX, &set.normalY, &set.normalZ})) return;
    checkEach(
        s,
        [&](std::size_t i) {
          const Vec3f normal{set.normalX[i], set.normalY[i], set.normalZ[i]};
          return finite(Vec3f{set.centerX[i], set.centerY[i], set.centerZ[i]}) &&
                 std::abs(lengthSquared(normal) - 1.0f) < 1e-5f && set.radius[i] > 0.0f && std::isfinite(set.radius[i]);
        },
        "needs a finite centre, a unit normal and a positive radius");
  }

  void checkSet(const ShapeDescription& s, const TriangleMesh& mesh) {
    if (mesh.indices.size() % 3 != 0) error(s.where, fmt::format("shape \"{}\": indices come in threes", s.name));
    if ((!mesh.normals.empty() && mesh.normals.size() != mesh.positions.size()) ||
        (!mesh.uvs.empty() && mesh.uvs.size() != mesh.positions.size()))
      error(s.where, fmt::format("shape \"{}\": normals and uvs are one per vertex, or none", s.name));
    for (const Vec3f& p : mesh.positions)
      if (!finite(p)) {
        error(s.where, fmt::format("shape \"{}\" has a vertex that is not finite", s.name));
        break;
      }
    for (const std::uint32_t i : mesh.indices)
      if (i >= mesh.positions.size()) {
        error(s.where, fmt::format("shape \"{}\" has an index beyond its {} vertices", s.name, mesh.positions.size()));
        break;
      }
  }

  void checkSet(const ShapeDescription& s, const CustomShapeSet& set) {
    checkEach(
        s, [&](std::size_t i) { return set.shapes[i] != nullptr; }, "is null");
  }

  void checkGroups() {
    for (const Group& group : scene_.groups)
      for (const Id id : group.shapes)
        if (id >= scene_.shapes.size())
          error({}, fmt::format("group \"{}\" has a shape that is not in the scene", group.name));
    for (const InstanceSet& set : scene_.instances) {
      if (set.group >= scene_.groups.size()) error(set.where, "an instance refers to a group that is not in the scene");
      checkTransforms(set);
    }
  }

  void checkTransforms(const InstanceSet& set) {
    if (!set.closing.empty() && set.closing.size() != set.transforms.size())
      error(set.where,
            fmt::format("{} instances have {} transforms at time 1", set.transforms.size(), set.closing.size()));
    for (const std::vector<Matrix>* matrices : {&set.transforms, &set.closing}) {
      if (std::all_of(matrices->begin(), matrices->end(), usable)) continue;
      error(set.where, "an instance's transform must be affine, finite and invertible");
      return;
    }
    for (std::size_t i = 0; i < std::min(set.transforms.size(), set.closing.size()); ++i) {
      if (sameHandedness(set.transforms[i], set.closing[i])) continue;
      error(set.where, fmt::format("of the two transforms of instance {} only one is a mirror", i));
      return;
    }
  }

  static bool usable(const Matrix& m) {
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (!std::isfinite(m[i][j])) return false;
    const bool affine = m[0][3] == 0.0f && m[1][3] == 0.0f && m[2][3] == 0.0f && m[3][3] == 1.0f;
    return affine && std::isnormal(m.determinant());
  }

  void checkLight(const LightDescription& l) {
    const auto complain = [&](const char* rule) { error(l.where, fmt::format("light \"{}\" {}", l.name, rule)); };
    if (const auto* point = std::get_if<PointLight>(&l.model))
      if (!finite(point->position) || !nonNegative(point->intensity)) complain("needs a finite place and an intensity");
    if (const auto* spot = std::get_if<SpotLight>(&l.model)) {
      if (!finite(spot->position) || !nonNegative(spot->intensity) || !finite(spot->direction) || zero(spot->direction))
        complain("needs a finite place, a direction and an intensity");
      if (!(spot->innerAngle >= 0.0f && spot->innerAngle <= spot->outerAngle && spot->outerAngle < 180.0f))
        complain("needs 0 <= inner angle <= outer angle < 180 degrees");
    }
    if (const auto* distant = std::get_if<DistantLight>(&l.model))
      if (!finite(distant->direction) || zero(distant->direction) || !nonNegative(distant->irradiance))
        complain("needs a direction and an irradiance");
    if (const auto* sky = std::get_if<ConstantSky>(&l.model))
      if (!nonNegative(sky->radiance)) complain("needs a radiance that is finite and not negative");
    if (const auto* sky = std::get_if<ImageSky>(&l.model)) {
      checkPicture(sky->image.get(), l.where, fmt::format("light \"{}\"", l.name));
      if (!nonNegative(sky->scale) || !std::isfinite(sky->rotation)) complain("needs a scale and a finite rotation");
    }
    if (const auto* sky = std::get_if<GradientSky>(&l.model))
      if (!nonNegative(sky->nadir) || !nonNegative(sky->zenith))
        complain("needs radiances that are finite and not negative");
  }

  void checkDefaults() {
    const RenderDefaults& d = scene_.defaults;
    if (d.width < 1 || d.height < 1 || d.samplesPerPixel < 1 || d.maxDepth < 0)
      error({}, "the scene's defaults need a size, samples and a depth");
  }

  const SceneDescription& scene_;
  Diagnostics& out_;
  std::vector<bool> reflects_;  ///< per texture that has been checked: its colours lie in [0, 1]
};

}  // namespace

Diagnostics validate(const SceneDescription& scene) {
  Diagnostics diagnostics;
  Validator(scene, diagnostics).run();
  return diagnostics;
}

}  // namespace steradian
