#include "steradian/apps/steradian/scene_json.h"

#include <array>
#include <charconv>
#include <nlohmann/json.hpp>
#include <vector>

#include "steradian/core/scene/placements.h"

namespace steradian::app {

namespace {

using nlohmann::json;

/// The shortest decimal that reads back as this float: 0.65 and not 0.64999997615814209.
json toJson(float value) {
  std::array<char, 32> text{};
  const char* end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  double shortest = value;
  std::from_chars(text.data(), end, shortest);
  return shortest;
}
json toJson(const std::vector<float>& values) {
  json list = json::array();
  for (const float value : values) list.push_back(toJson(value));
  return list;
}
json toJson(Vec3f v) { return {toJson(v.x), toJson(v.y), toJson(v.z)}; }
json toJson(Rgb c) { return {toJson(c.r), toJson(c.g), toJson(c.b)}; }
json idJson(Id id) { return id == kNone ? json(nullptr) : json(id); }

json toJson(const Matrix& m) {
  json rows = json::array();
  for (int i = 0; i < 4; ++i) rows.push_back({toJson(m[i][0]), toJson(m[i][1]), toJson(m[i][2]), toJson(m[i][3])});
  return rows;
}

json toJson(const ConstantTexture& t) { return {{"type", "constant"}, {"value", toJson(t.value)}}; }
json toJson(const CheckerTexture& t) {
  return {{"type", "checker"},
          {"even", t.even},
          {"odd", t.odd},
          {"scale", toJson(t.scale)},
          {"space", t.space == CheckerTexture::Space::World ? "world" : "uv"}};
}

const char* toJson(ImageTexture::Wrap wrap) {
  static constexpr const char* names[] = {"repeat", "mirror", "clamp", "black"};
  return names[static_cast<int>(wrap)];
}
json toJson(const ImageTexture& t) {
  return {{"type", "image"},
          {"file", t.name},
          {"wrapU", toJson(t.wrapU)},
          {"wrapV", toJson(t.wrapV)},
          {"filter", t.filter == ImageTexture::Filter::Nearest ? "nearest" : "bilinear"},
          {"repeatU", toJson(t.repeatU)},
          {"repeatV", toJson(t.repeatV)}};
}
json toJson(const NoiseTexture& t) {
  static constexpr const char* patterns[] = {"noise", "turbulence", "marble"};
  return {{"type", "noise"},
          {"pattern", patterns[static_cast<int>(t.pattern)]},
          {"colour", toJson(t.colour)},
          {"scale", toJson(t.scale)},
          {"octaves", t.octaves},
          {"seed", t.seed}};
}

json toJson(const UniformDiffuseMaterial& m) { return {{"type", "uniform-diffuse"}, {"reflectance", m.reflectance}}; }
json toJson(const InterfaceMaterial&) { return {{"type", "interface"}}; }
json toJson(const AbsorberMaterial&) { return {{"type", "absorber"}}; }
json toJson(const LambertMaterial& m) { return {{"type", "lambert"}, {"reflectance", m.reflectance}}; }
json toJson(const MetalMaterial& m) {
  return {{"type", "metal"}, {"reflectance", m.reflectance}, {"fuzz", toJson(m.fuzz)}};
}
json toJson(const DielectricMaterial& m) {
  return {{"type", "dielectric"}, {"eta", toJson(m.eta)}, {"schlick", m.schlick}};
}
json toJson(const CoatedMaterial& m) {
  return {{"type", "coated"}, {"reflectance", m.reflectance}, {"eta", toJson(m.eta)}};
}

json toJson(const SphereSet& s) {
  json out = {{"centerX", toJson(s.centerX)},
              {"centerY", toJson(s.centerY)},
              {"centerZ", toJson(s.centerZ)},
              {"radius", toJson(s.radius)}};
  if (!s.moveX.empty()) {
    out["moveX"] = toJson(s.moveX);
    out["moveY"] = toJson(s.moveY);
    out["moveZ"] = toJson(s.moveZ);
  }
  return out;
}
json toJson(const QuadSet& s) {
  return {{"cornerX", toJson(s.cornerX)}, {"cornerY", toJson(s.cornerY)}, {"cornerZ", toJson(s.cornerZ)},
          {"uX", toJson(s.uX)},           {"uY", toJson(s.uY)},           {"uZ", toJson(s.uZ)},
          {"vX", toJson(s.vX)},           {"vY", toJson(s.vY)},           {"vZ", toJson(s.vZ)}};
}
json toJson(const BoxSet& s) {
  json out = {{"centerX", toJson(s.centerX)}, {"centerY", toJson(s.centerY)}, {"centerZ", toJson(s.centerZ)},
              {"halfX", toJson(s.halfX)},     {"halfY", toJson(s.halfY)},     {"halfZ", toJson(s.halfZ)}};
  if (!s.rotationW.empty()) {
    out["rotationW"] = toJson(s.rotationW);
    out["rotationX"] = toJson(s.rotationX);
    out["rotationY"] = toJson(s.rotationY);
    out["rotationZ"] = toJson(s.rotationZ);
  }
  return out;
}
json toJson(const DiskSet& s) {
  return {{"centerX", toJson(s.centerX)}, {"centerY", toJson(s.centerY)}, {"centerZ", toJson(s.centerZ)},
          {"normalX", toJson(s.normalX)}, {"normalY", toJson(s.normalY)}, {"normalZ", toJson(s.normalZ)},
          {"radius", toJson(s.radius)}};
}
json toJson(const TriangleMesh& mesh) {
  json positions = json::array(), normals = json::array(), uvs = json::array();
  for (const Vec3f& p : mesh.positions) positions.push_back(toJson(p));
  for (const Vec3f& n : mesh.normals) normals.push_back(toJson(n));
  for (const Vec2f& uv : mesh.uvs) uvs.push_back({toJson(uv.x), toJson(uv.y)});
  return {{"positions", positions}, {"indices", mesh.indices}, {"normals", normals}, {"uvs", uvs}};
}
json toJson(const CustomShapeSet& s) { return {{"count", s.shapes.size()}}; }

json toJson(const PointLight& l) {
  return {{"type", "point"}, {"position", toJson(l.position)}, {"intensity", toJson(l.intensity)}};
}
json toJson(const SpotLight& l) {
  return {{"type", "spot"},
          {"position", toJson(l.position)},
          {"direction", toJson(l.direction)},
          {"intensity", toJson(l.intensity)},
          {"innerAngle", toJson(l.innerAngle)},
          {"outerAngle", toJson(l.outerAngle)}};
}
json toJson(const DistantLight& l) {
  return {{"type", "distant"}, {"direction", toJson(l.direction)}, {"irradiance", toJson(l.irradiance)}};
}
json toJson(const ConstantSky& l) { return {{"type", "constant sky"}, {"radiance", toJson(l.radiance)}}; }
json toJson(const GradientSky& l) {
  return {{"type", "gradient sky"}, {"nadir", toJson(l.nadir)}, {"zenith", toJson(l.zenith)}};
}

json toJson(const ImageSky& l) {
  return {{"type", "image sky"}, {"file", l.name}, {"scale", toJson(l.scale)}, {"rotation", toJson(l.rotation)}};
}

json toJson(const MediumDescription& m) {
  return {{"name", m.name},
          {"absorption", toJson(m.absorption)},
          {"scattering", toJson(m.scattering)},
          {"emission", toJson(m.emission)},
          {"anisotropy", toJson(m.anisotropy)}};
}

template <class Camera>
json viewJson(const char* type, const Camera& c) {
  return {{"type", type}, {"lookFrom", toJson(c.lookFrom)}, {"lookAt", toJson(c.lookAt)}, {"up", toJson(c.up)}};
}
json toJson(const PerspectiveCamera& c) {
  json out = viewJson("perspective", c);
  out["verticalFov"] = toJson(c.verticalFov);
  out["defocusAngle"] = toJson(c.defocusAngle);
  out["focusDistance"] = toJson(c.focusDistance);
  return out;
}
json toJson(const OrthographicCamera& c) {
  json out = viewJson("orthographic", c);
  out["height"] = toJson(c.height);
  return out;
}
json toJson(const SphericalCamera& c) { return viewJson("spherical", c); }

template <class... Alternatives>
json toJson(const std::variant<Alternatives...>& value) {
  return std::visit([](const auto& alternative) { return toJson(alternative); }, value);
}

json toJson(const ShapeDescription& s) {
  json out = toJson(s.geometry);
  out["name"] = s.name;
  out["type"] = primitiveName(s.geometry);
  out["material"] = idJson(s.material);
  if (!s.primitiveMaterials.empty()) out["primitiveMaterials"] = s.primitiveMaterials;
  out["emission"] = idJson(s.emission);
  out["target"] = s.target;
  if (s.interior) out["interior"] = {{"medium", idJson(s.interior->medium)}, {"priority", s.interior->priority}};
  if (s.motion) out["motion"] = {{"open", toJson(s.motion->open)}, {"close", toJson(s.motion->close)}};
  return out;
}

template <class Items>
json listJson(const Items& items) {
  json list = json::array();
  for (const auto& item : items) list.push_back(toJson(item));
  return list;
}

template <class Items>
json namedJson(const Items& items) {
  json list = json::array();
  for (const auto& item : items) {
    json entry = toJson(item.model);
    entry["name"] = item.name;
    list.push_back(std::move(entry));
  }
  return list;
}

}  // namespace

std::map<std::string, std::uint64_t> countPrimitives(const SceneDescription& scene) {
  const Placements placements(scene);
  std::map<std::string, std::uint64_t> counts;
  for (Id id = 0; id < scene.shapes.size(); ++id) {
    const ShapeGeometry& geometry = scene.shapes[id].geometry;
    if (placements.countOf(id) > 0)
      counts[primitiveName(geometry)] += placements.countOf(id) * primitiveCount(geometry);
  }
  return counts;
}

json toJson(const SceneDescription& scene) {
  json out;
  out["name"] = scene.name;
  out["textures"] = listJson(scene.textures);
  out["materials"] = namedJson(scene.materials);
  out["media"] = listJson(scene.media);
  out["outside"] = idJson(scene.outside);
  out["emissions"] = json::array();
  for (const SurfaceEmission& e : scene.emissions)
    out["emissions"].push_back({{"radiance", toJson(e.radiance)}, {"twoSided", e.twoSided}});
  out["shapes"] = listJson(scene.shapes);
  out["groups"] = json::array();
  for (const Group& g : scene.groups) out["groups"].push_back({{"name", g.name}, {"shapes", g.shapes}});
  out["instances"] = json::array();
  for (const InstanceSet& set : scene.instances) {
    out["instances"].push_back({{"group", set.group}, {"transforms", listJson(set.transforms)}});
    if (!set.closing.empty()) out["instances"].back()["closing"] = listJson(set.closing);
  }
  out["lights"] = namedJson(scene.lights);
  out["camera"] = toJson(scene.camera);
  out["defaults"] = {{"width", scene.defaults.width},
                     {"height", scene.defaults.height},
                     {"samplesPerPixel", scene.defaults.samplesPerPixel},
                     {"maxDepth", scene.defaults.maxDepth}};
  out["counts"] = countPrimitives(scene);
  return out;
}

}  // namespace steradian::app
