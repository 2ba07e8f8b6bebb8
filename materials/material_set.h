#pragma once
/// The materials of a scene, ready for shading: makes the Bsdf of a surface point.
#include <optional>
#include <vector>

#include "steradian/materials/bsdf.h"
#include "steradian/materials/texture.h"

namespace STERADIAN_API steradian {

class MaterialSet {
 public:
  /// The description must be valid (see validate()).
  explicit MaterialSet(const SceneDescription& scene);

  /// The BSDF at a point, with its textures looked up. Where `wo` is on different sides of the surface by the shading
  /// normal and by the geometric one, the geometric normal shades too (see usableShadingNormal). A point without a
  /// material absorbs. A dielectric's refractive index is divided by `outsideEta`, that of the medium outside.
  Bsdf bsdf(const SurfacePoint<float>& at, Vec3f wo, float outsideEta = 1.0f) const;

  std::size_t size() const { return entries_.size(); }
  /// The model of a material, with its colour if that is constant.
  const Bsdf::Model& model(Id material) const { return entries_[material].model; }
  /// What its colour is read from; kNone if that is constant, or there is none.
  Id texture(Id material) const { return entries_[material].texture; }
  const TextureSet& textures() const { return textures_; }

 private:
  /// The model with its constant colour; `texture` replaces that where it is not kNone.
  struct Entry {
    Bsdf::Model model;
    Id texture = kNone;
  };
  TextureSet textures_;
  std::vector<Entry> entries_;
};

}  // namespace steradian
