#include "steradian/integrators/scene/scene_hash.h"

#include <fmt/format.h>

namespace steradian {
namespace {

/// Overloads for every type of a description; containers enter with their size, variants with their index.
class Hasher {
 public:
  std::uint64_t value() const { return state_; }

  void add(std::uint64_t word) {
    state_ = (state_ ^ word) * 0x9e3779b97f4a7c15u;
    state_ ^= state_ >> 32;
  }
  void add(std::uint32_t word) { add(std::uint64_t{word}); }
  void add(bool flag) { add(std::uint64_t{flag}); }
  void add(float x) { add(bitsOf(x)); }
  void add(Rgb c) { all(c.r, c.g, c.b); }
  void add(Vec2f v) { all(v.x, v.y); }
  void add(Vec3f v) { all(v.x, v.y, v.z); }
  void add(const Matrix& m) {
    for (int row = 0; row < 4; ++row) all(m[row][0], m[row][1], m[row][2], m[row][3]);
  }
  template <class T>
  void add(const std::vector<T>& items) {
    add(std::uint64_t{items.size()});
    for (const T& item : items) add(item);
  }
  template <class... T>
  void add(const std::variant<T...>& alternatives) {
    add(std::uint64_t{alternatives.index()});
    std::visit([&](const auto& chosen) { add(chosen); }, alternatives);
  }

  void add(const ConstantTexture& t) { add(t.value); }
  void add(const CheckerTexture& t) { all(t.even, t.odd, t.scale, t.space == CheckerTexture::Space::Uv); }
  void add(const std::shared_ptr<const Image>& image) {
    all(std::uint64_t(image->width()), std::uint64_t(image->height()));
    for (const float x : image->values()) add(x);
  }
  void add(const ImageTexture& t) {
    all(t.image, static_cast<std::uint32_t>(t.wrapU), static_cast<std::uint32_t>(t.wrapV),
        t.filter == ImageTexture::Filter::Nearest, t.repeatU, t.repeatV);
  }
  void add(const NoiseTexture& t) {
    all(static_cast<std::uint32_t>(t.pattern), t.colour, t.scale, static_cast<std::uint32_t>(t.octaves), t.seed);
  }
  void add(const AbsorberMaterial&) {}
  void add(const UniformDiffuseMaterial& m) { add(m.reflectance); }
  void add(const InterfaceMaterial&) {}
  void add(const LambertMaterial& m) { add(m.reflectance); }
  void add(const MetalMaterial& m) { all(m.reflectance, m.fuzz); }
  void add(const DielectricMaterial& m) { all(m.eta, m.schlick); }
  void add(const CoatedMaterial& m) { all(m.reflectance, m.eta); }
  void add(const MaterialDescription& m) { add(m.model); }
  void add(const MediumDescription& m) { all(m.absorption, m.scattering, m.emission, m.anisotropy); }
  void add(const Interior& i) { all(i.medium, static_cast<std::uint32_t>(i.priority)); }
  void add(const Motion& m) { all(m.open, m.close); }
  template <class T>
  void add(const std::optional<T>& value) {
    add(value.has_value());
    if (value) add(*value);
  }
  void add(const SurfaceEmission& e) { all(e.radiance, e.twoSided); }

  void add(const SphereSet& s) { all(s.centerX, s.centerY, s.centerZ, s.radius, s.moveX, s.moveY, s.moveZ); }
  void add(const QuadSet& s) { all(s.cornerX, s.cornerY, s.cornerZ, s.uX, s.uY, s.uZ, s.vX, s.vY, s.vZ); }
  void add(const BoxSet& s) {
    all(s.centerX, s.centerY, s.centerZ, s.halfX, s.halfY, s.halfZ);
    all(s.rotationW, s.rotationX, s.rotationY, s.rotationZ);
  }
  void add(const DiskSet& s) { all(s.centerX, s.centerY, s.centerZ, s.normalX, s.normalY, s.normalZ, s.radius); }
  void add(const TriangleMesh& m) { all(m.positions, m.indices, m.normals, m.uvs); }
  void add(const CustomShapeSet& s) {
    add(std::uint64_t{s.shapes.size()});
    for (const auto& shape : s.shapes) {
      const Bounds3 bounds = shape->bounds();
      all(bounds.low, bounds.high);
    }
  }
  void add(const ShapeDescription& s) {
    all(s.geometry, s.material, s.primitiveMaterials, s.emission, s.target, s.interior, s.motion);
  }
  void add(const Group& g) { add(g.shapes); }
  void add(const InstanceSet& s) { all(s.group, s.transforms, s.closing); }

  void add(const PointLight& l) { all(l.position, l.intensity); }
  void add(const SpotLight& l) { all(l.position, l.direction, l.intensity, l.innerAngle, l.outerAngle); }
  void add(const DistantLight& l) { all(l.direction, l.irradiance); }
  void add(const ConstantSky& l) { add(l.radiance); }
  void add(const GradientSky& l) { all(l.nadir, l.zenith); }
  void add(const ImageSky& l) { all(l.image, l.scale, l.rotation); }
  void add(const LightDescription& l) { add(l.model); }

  void add(const PerspectiveCamera& c) {
    all(c.lookFrom, c.lookAt, c.up, c.verticalFov, c.defocusAngle, c.focusDistance);
  }
  void add(const OrthographicCamera& c) { all(c.lookFrom, c.lookAt, c.up, c.height); }
  void add(const SphericalCamera& c) { all(c.lookFrom, c.lookAt, c.up); }

  template <class... T>
  void all(const T&... parts) {
    (add(parts), ...);
  }

 private:
  std::uint64_t state_ = 0x5357e2ad1a6b0001u;
};

}  // namespace

std::uint64_t sceneHash(const SceneDescription& scene) {
  Hasher hasher;
  hasher.all(scene.textures, scene.materials, scene.media, scene.outside, scene.emissions, scene.shapes, scene.groups,
             scene.instances, scene.lights, scene.camera);
  return hasher.value();
}

std::string sceneHashText(std::uint64_t hash) { return fmt::format("{:016x}", hash); }

}  // namespace steradian
