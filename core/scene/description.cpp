#include "steradian/core/scene/description.h"

#include <cmath>

namespace steradian {

namespace {

template <class... Alternatives>
struct Overload : Alternatives... {
  using Alternatives::operator()...;
};
template <class... Alternatives>
Overload(Alternatives...) -> Overload<Alternatives...>;

void append(std::vector<float>& x, std::vector<float>& y, std::vector<float>& z, Vec3f v) {
  x.push_back(v.x);
  y.push_back(v.y);
  z.push_back(v.z);
}

}  // namespace

void SphereSet::add(Vec3f center, float sphereRadius) {
  append(centerX, centerY, centerZ, center);
  radius.push_back(sphereRadius);
  if (!moveX.empty()) append(moveX, moveY, moveZ, {});
}

void SphereSet::addMoving(Vec3f from, Vec3f to, float sphereRadius) {
  for (std::vector<float>* column : {&moveX, &moveY, &moveZ}) column->resize(radius.size(), 0.0f);
  append(centerX, centerY, centerZ, from);
  radius.push_back(sphereRadius);
  append(moveX, moveY, moveZ, to - from);
}

void QuadSet::add(Vec3f corner, Vec3f u, Vec3f v) {
  append(cornerX, cornerY, cornerZ, corner);
  append(uX, uY, uZ, u);
  append(vX, vY, vZ, v);
}

void BoxSet::add(Vec3f center, Vec3f half) {
  append(centerX, centerY, centerZ, center);
  append(halfX, halfY, halfZ, half);
}

void BoxSet::addRotatedY(Vec3f center, Vec3f half, float degrees) {
  add(center, half);
  const double halfAngle = static_cast<double>(degrees) * 3.14159265358979323846 / 360.0;
  rotationW.push_back(static_cast<float>(std::cos(halfAngle)));
  append(rotationX, rotationY, rotationZ, {0.0f, static_cast<float>(std::sin(halfAngle)), 0.0f});
}

void DiskSet::add(Vec3f center, Vec3f normal, float diskRadius) {
  append(centerX, centerY, centerZ, center);
  append(normalX, normalY, normalZ, normal);
  radius.push_back(diskRadius);
}

std::size_t primitiveCount(const ShapeGeometry& geometry) {
  return std::visit(
      Overload{[](const SphereSet& s) { return s.radius.size(); }, [](const QuadSet& s) { return s.cornerX.size(); },
               [](const BoxSet& s) { return s.centerX.size(); }, [](const DiskSet& s) { return s.radius.size(); },
               [](const TriangleMesh& s) { return s.indices.size() / 3; },
               [](const CustomShapeSet& s) { return s.shapes.size(); }},
      geometry);
}

const char* primitiveName(const ShapeGeometry& geometry) {
  static constexpr const char* names[] = {"sphere", "quad", "box", "disk", "triangle", "custom"};
  static_assert(std::variant_size_v<ShapeGeometry> == std::size(names));
  return names[geometry.index()];
}

Id SceneDescription::addTexture(TextureDescription texture) {
  textures.push_back(std::move(texture));
  return static_cast<Id>(textures.size() - 1);
}

Id SceneDescription::addColour(Rgb value) { return addTexture(ConstantTexture{value}); }

Id SceneDescription::addMaterial(std::string materialName, MaterialModel model) {
  materials.push_back({std::move(materialName), model, {}});
  return static_cast<Id>(materials.size() - 1);
}

Id SceneDescription::addMedium(MediumDescription medium) {
  media.push_back(std::move(medium));
  return static_cast<Id>(media.size() - 1);
}

Id SceneDescription::addShape(std::string shapeName, ShapeGeometry geometry, Id material) {
  ShapeDescription shape;
  shape.name = std::move(shapeName);
  shape.geometry = std::move(geometry);
  shape.material = material;
  shapes.push_back(std::move(shape));
  return static_cast<Id>(shapes.size() - 1);
}

void SceneDescription::setEmission(Id shape, SurfaceEmission emission) {
  emissions.push_back(emission);
  shapes.at(shape).emission = static_cast<Id>(emissions.size() - 1);
}

Id SceneDescription::addLight(std::string lightName, LightModel model) {
  lights.push_back({std::move(lightName), std::move(model), {}});
  return static_cast<Id>(lights.size() - 1);
}

}  // namespace steradian
