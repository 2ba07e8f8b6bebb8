#include "steradian/materials/material_set.h"

#include <type_traits>

namespace steradian {
namespace {

struct Compiled {
  Bsdf::Model model;
  Id texture = kNone;  ///< what the model's colour is read from
};

Compiled compile(const MaterialModel& material) {
  if (const auto* m = std::get_if<LambertMaterial>(&material)) return {Lambert<float>{}, m->reflectance};
  if (const auto* m = std::get_if<UniformDiffuseMaterial>(&material)) return {UniformDiffuse<float>{}, m->reflectance};
  if (const auto* m = std::get_if<MetalMaterial>(&material)) {
    if (m->fuzz < FuzzyMetal<float>::minFuzz) return {Mirror<float>{}, m->reflectance};
    return {FuzzyMetal<float>{{}, minimum(m->fuzz, 1.0f)}, m->reflectance};
  }
  if (const auto* m = std::get_if<DielectricMaterial>(&material)) return {Dielectric<float>{m->eta, m->schlick}, kNone};
  if (const auto* m = std::get_if<CoatedMaterial>(&material)) {
    const auto internal = static_cast<float>(1.0 - diffuseTransmittance(1.0 / static_cast<double>(m->eta)));
    return {Coated<float>{{}, m->eta, internal}, m->reflectance};
  }
  return {Absorber<float>{}, kNone};
}

void setReflectance(Bsdf::Model& model, Rgb colour) {
  std::visit(
      [&](auto& m) {
        if constexpr (requires { m.reflectance; }) m.reflectance = colour;
      },
      model);
}

}  // namespace

MaterialSet::MaterialSet(const SceneDescription& scene) : textures_(scene.textures) {
  entries_.reserve(scene.materials.size());
  for (const MaterialDescription& material : scene.materials) {
    Compiled compiled = compile(material.model);
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
  if (auto* dielectric = std::get_if<Dielectric<float>>(&model)) dielectric->eta /= outsideEta;
  return {model, at.geometricNormal, shadingNormal};
}

}  // namespace steradian
