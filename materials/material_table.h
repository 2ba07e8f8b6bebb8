#pragma once
/// The materials of a scene for several points at once: their parameters in rows to gather from, and the models that
/// occur.
#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "steradian/materials/material_set.h"

namespace STERADIAN_API steradian {

class MaterialTable {
 public:
  /// `materials` must outlive the table.
  explicit MaterialTable(const MaterialSet& materials);

  /// What the materials of the lanes are made of. A model reads what it needs.
  template <class F>
  struct Parameters {
    UintOf<F> model;  ///< which one: the index in Bsdf::Model
    Spectrum<F> reflectance;
    F eta, fuzz, internalReflectance, schlick;
  };
  /// `at` needs valid points; for some textures their uv as well (see readsUv()).
  template <class F>
  Parameters<F> parameters(const SurfacePoint<F>& at, MaskOf<F> active) const;

  /// Whether the texture of any material reads the uv of its points.
  bool readsUv() const { return readsUv_; }

  /// Calls visit(model, mask) for each model that some active lane has, as Model<F> with the lanes' parameters.
  template <class F, class Visit>
  void forEachModel(const Parameters<F>& parameters, MaskOf<F> active, const Visit& visit) const;

 private:
  /// The model and its parameters as one record to gather: two blocks of four, the second for models that have more
  /// than a colour.
  struct Record {
    std::uint32_t model;
    float red, green, blue, eta, fuzz, internalReflectance, schlick;
  };

  /// Sets the colours that are read from textures: noise for all its lanes at once, others one by one.
  template <class F>
  void addTextures(const SurfacePoint<F>& at, UintOf<F> material, MaskOf<F> active, Parameters<F>& parameters) const;
  template <class F, std::size_t index, class Visit>
  void visitModel(const Parameters<F>& p, MaskOf<F> active, const Visit& visit) const;

  const MaterialSet* materials_;
  std::vector<Record> records_;  ///< per material, and of none
  std::vector<Id> textureOf_;    ///< likewise; kNone where the record has the colour
  std::vector<bool> present_;    ///< per model
  bool coloursOnly_ = true;      ///< no model has other parameters
  bool textured_ = false;        ///< some material has a texture
  bool readsUv_ = false;
};

template <class F>
MaterialTable::Parameters<F> MaterialTable::parameters(const SurfacePoint<F>& at, MaskOf<F> active) const {
  const UintOf<F> none(static_cast<std::uint32_t>(materials_->size()));
  const UintOf<F> material = select(at.material < none, at.material, none);
  static_assert(sizeof(Record) == 8 * sizeof(float));
  const UintOf<F> place = material << 3;
  const auto a = gather4(&records_.data()->model, place);
  Parameters<F> p{a[0], {floatOf(a[1]), floatOf(a[2]), floatOf(a[3])}, F(1.0f), F(0.0f), F(0.0f), F(0.0f)};
  if (!coloursOnly_) {
    const auto b = gather4(&records_.data()->eta, place);
    p.eta = b[0];
    p.fuzz = b[1];
    p.internalReflectance = b[2];
    p.schlick = b[3];
  }
  if (textured_) addTextures(at, material, active, p);
  return p;
}

template <class F>
void MaterialTable::addTextures(const SurfacePoint<F>& at, UintOf<F> material, MaskOf<F> active,
                                Parameters<F>& p) const {
  const TextureSet& textures = materials_->textures();
  const UintOf<F> texture = gather(textureOf_.data(), material);
  MaskOf<F> left = active & (texture != UintOf<F>(kNone));
  for (int i = 0; i < widthOf<F>; ++i) {
    if (!lane(left, i)) continue;
    const Id id = lane(texture, i);
    if (const NoisePattern* noise = textures.noise(id)) {
      const MaskOf<F> mine = left & (texture == UintOf<F>(id));
      p.reflectance = select(mine, noise->value(at.position), p.reflectance);
      left = left & !mine;
    } else {
      setLane(p.reflectance, i, textures.value(id, lane(at, i)));
    }
  }
}

namespace detail {
template <class F, class P>
Absorber<F> makeModel(const P&, std::type_identity<Absorber<float>>) {
  return {};
}
template <class F, class P>
Lambert<F> makeModel(const P& p, std::type_identity<Lambert<float>>) {
  return {p.reflectance};
}
template <class F, class P>
Mirror<F> makeModel(const P& p, std::type_identity<Mirror<float>>) {
  return {p.reflectance};
}
template <class F, class P>
FuzzyMetal<F> makeModel(const P& p, std::type_identity<FuzzyMetal<float>>) {
  return {p.reflectance, p.fuzz};
}
template <class F, class P>
Coated<F> makeModel(const P& p, std::type_identity<Coated<float>>) {
  return {p.reflectance, p.eta, p.internalReflectance};
}
template <class F, class P>
UniformDiffuse<F> makeModel(const P& p, std::type_identity<UniformDiffuse<float>>) {
  return {p.reflectance};
}
}  // namespace detail

template <class F, std::size_t index, class Visit>
void MaterialTable::visitModel(const Parameters<F>& p, MaskOf<F> active, const Visit& visit) const {
  using Model = std::variant_alternative_t<index, Bsdf::Model>;
  if (!present_[index]) return;
  const MaskOf<F> mine = active & (p.model == UintOf<F>(static_cast<std::uint32_t>(index)));
  if (!any(mine)) return;
  if constexpr (std::is_same_v<Model, Dielectric<float>>) {
    // Which Fresnel term is not a matter of lanes.
    const MaskOf<F> schlick = mine & (p.schlick > F(0.0f)), exact = mine & !schlick;
    if (any(exact)) visit(Dielectric<F>{p.eta, false}, exact);
    if (any(schlick)) visit(Dielectric<F>{p.eta, true}, schlick);
  } else {
    visit(detail::makeModel<F>(p, std::type_identity<Model>{}), mine);
  }
}

template <class F, class Visit>
void MaterialTable::forEachModel(const Parameters<F>& parameters, MaskOf<F> active, const Visit& visit) const {
  [&]<std::size_t... index>(std::index_sequence<index...>) { (visitModel<F, index>(parameters, active, visit), ...); }
  (std::make_index_sequence<std::variant_size_v<Bsdf::Model>>{});
}

}  // namespace steradian
