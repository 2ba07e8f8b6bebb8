#include "steradian/materials/material_set.h"

#include <variant>

namespace steradian {
namespace {

struct Compiled {
  Bsdf::Model model;
  Id texture = kNone;  ///< what the model's colour is read from
};

Compiled compile(const AbsorberMaterial&) { return {Absorber<float>{}, kNone}; }
/// Nothing is shaded there: paths cross it.
Compiled compile(const InterfaceMaterial&) { return {Absorber<float>{}, kNone}; }
Compiled compile(const LambertMaterial& m) { return {Lambert<float>{}, m.reflectance}; }
Compiled compile(const UniformDiffuseMaterial& m) { return {UniformDiffuse<float>{}, m.reflectance}; }
Compiled compile(const MetalMaterial& m) {
  if (m.fuzz < FuzzyMetal<float>::minFuzz) return {Mirror<float>{}, m.reflectance};
  return {FuzzyMetal<float>{{}, minimum(m.fuzz, 1.0f)}, m.reflectance};
}
Compiled compile(const DielectricMaterial& m) {
  if (m.schlick) return {SchlickDielectric<float>{m.eta}, kNone};
  return {Dielectric<float>{m.eta}, kNone};
}
Compiled compile(const CoatedMaterial& m) {
  const auto internal = static_cast<float>(1.0 - diffuseTransmittance(1.0 / static_cast<double>(m.eta)));
  return {Coated<float>{{}, m.eta, internal}, m.reflectance};
}

void setReflectance(Bsdf::Model& model, Rgb colour) {
  std::visit(
      [&](auto& m) {
        if constexpr (requires { m.reflectance; }) m.reflectance = colour;
      },
      model);
}

void setOutsideEta(Bsdf::Model& model, float outsideEta) {
  std::visit(
      [&](auto& m) {
        if constexpr (requires { m.setOutsideEta(outsideEta); }) m.setOutsideEta(outsideEta);
      },
      model);
}

}  // namespace

MaterialSet::MaterialSet(const SceneDescription& scene) : textures_(scene.textures) {
  entries_.reserve(scene.materials.size());
  for (const MaterialDescription& material : scene.materials) {
    Compiled compiled = std::visit([](const auto& m) { return compile(m); }, material.model);
    if (const auto colour = textures_.constant(compiled.texture)) {
      setReflectance(compiled.model, *colour);
      compiled.texture = kNone;
    }
    entries_.push_back({compiled.model, compiled.texture});
  }
}

Bsdf MaterialSet::bsdf(const SurfacePoint<float>& at, Vec3f wo, float outsideEta) const {
  const Vec3f shadingNormal = usableShadingNormal(at.geometricNormal, at.shadingNormal, wo);
  if (at.material >= entries_.size()) return {Absorber<float>{}, at.geometricNormal, shadingNormal};
  const Entry& entry = entries_[at.material];
  if (entry.texture == kNone && outsideEta == 1.0f) return {entry.model, at.geometricNormal, shadingNormal};
  Bsdf::Model model = entry.model;
  if (entry.texture != kNone) setReflectance(model, textures_.value(entry.texture, at));
  setOutsideEta(model, outsideEta);
  return {model, at.geometricNormal, shadingNormal};
}

}  // namespace steradian
