#pragma once
/// The materials of a scene for several points at once: their parameters in tables to gather from, and the models that
/// occur.
#include <array>
#include <cstdint>
#include <utility>
#include <variant>
#include <vector>

#include "steradian/materials/material_set.h"
#include "steradian/materials/model_parameters.h"

namespace STERADIAN_API steradian {

/// A material takes as much room as its model has parameters. The first three are stored beside the index of the model,
/// the others in blocks of four, which only the models that have them read.
class MaterialTable {
 public:
  /// `materials` must outlive the table. Throws Error (Scene) for more than 2^29 parameters that are not a material's
  /// first three.
  explicit MaterialTable(const MaterialSet& materials);

  /// What the materials of the lanes are made of.
  template <class F>
  struct Parameters {
    UintOf<F> model;         ///< the index in Bsdf::Model
    std::array<F, 3> first;  ///< the first parameters of the model: its reflectance if it has one
    UintOf<F> block;         ///< of the others, if there are any
    F outsideEta{1.0f};      ///< index of the medium around dielectrics
  };
  /// `at` needs valid points; for some textures their uv as well (see readsUv()).
  template <class F>
  Parameters<F> parameters(const SurfacePoint<F>& at, MaskOf<F> active) const;

  /// Whether the texture of any material reads the uv of its points.
  bool readsUv() const { return readsUv_; }

  /// Calls visit(model, mask) for each model that some active lane has, as a model of width F with the lanes'
  /// parameters.
  template <class F, class Visit>
  void forEachModel(const Parameters<F>& parameters, MaskOf<F> active, const Visit& visit) const;

 private:
  static constexpr std::uint32_t kModelBits = 5, kFirst = 3, kBlock = 4;
  static_assert(std::variant_size_v<Bsdf::Model> <= 1u << kModelBits);

  /// What is gathered of every material.
  struct Record {
    std::uint32_t modelAndBlock;  ///< the model in the lowest kModelBits
    std::array<float, kFirst> first;
  };

  void add(const Bsdf::Model& model);
  /// Sets the colours that are read from textures: noise for all its lanes at once, others one by one.
  template <class F>
  void addTextures(const SurfacePoint<F>& at, UintOf<F> material, MaskOf<F> active, Parameters<F>& parameters) const;
  /// The model of this index, as if all lanes had it.
  template <class F, std::size_t index>
  auto modelOf(const Parameters<F>& p) const;
  template <class F, std::size_t index, class Visit>
  void visitModel(const Parameters<F>& p, MaskOf<F> active, const Visit& visit) const;

  const MaterialSet* materials_;
  std::vector<Record> records_;  ///< per material, and of none
  std::vector<float> blocks_;    ///< the parameters after the first; padded so that any model can be read at any block
  std::vector<Id> textureOf_;    ///< per material, and of none; kNone where the record has the colour
  std::uint32_t present_ = 0;    ///< a bit per model that occurs
  bool textured_ = false;        ///< some material has a texture
  bool readsUv_ = false;
};

template <class F>
MaterialTable::Parameters<F> MaterialTable::parameters(const SurfacePoint<F>& at, MaskOf<F> active) const {
  const UintOf<F> none(static_cast<std::uint32_t>(materials_->size()));
  const UintOf<F> material = select(at.material < none, at.material, none);
  static_assert(sizeof(Record) == kBlock * sizeof(float));
  const auto a = gather4(&records_.data()->modelAndBlock, material << 2);
  Parameters<F> p{a[0] & UintOf<F>((1u << kModelBits) - 1u),
                  {floatOf(a[1]), floatOf(a[2]), floatOf(a[3])},
                  a[0] >> static_cast<int>(kModelBits)};
  if (textured_) addTextures(at, material, active, p);
  return p;
}

template <class F>
void MaterialTable::addTextures(const SurfacePoint<F>& at, UintOf<F> material, MaskOf<F> active,
                                Parameters<F>& p) const {
  const TextureSet& textures = materials_->textures();
  const UintOf<F> texture = gather(textureOf_.data(), material);
  MaskOf<F> left = active & (texture != UintOf<F>(kNone));
  Spectrum<F> reflectance{p.first[0], p.first[1], p.first[2]};
  for (int i = 0; i < widthOf<F>; ++i) {
    if (!lane(left, i)) continue;
    const Id id = lane(texture, i);
    if (const NoisePattern* noise = textures.noise(id)) {
      const MaskOf<F> mine = left & (texture == UintOf<F>(id));
      reflectance = select(mine, noise->value(at.position), reflectance);
      left = left & !mine;
    } else {
      setLane(reflectance, i, textures.value(id, lane(at, i)));
    }
  }
  p.first = {reflectance.r, reflectance.g, reflectance.b};
}

template <class F, std::size_t index>
auto MaterialTable::modelOf(const Parameters<F>& p) const {
  constexpr std::size_t count = kParameterCount<std::variant_alternative_t<index, Bsdf::Model>>;
  constexpr std::size_t blocks = count > kFirst ? (count - kFirst + kBlock - 1) / kBlock : 0;
  std::array<std::array<F, kBlock>, blocks> others;
  for (std::size_t b = 0; b < blocks; ++b) others[b] = gather4(blocks_.data() + kBlock * b, p.block << 2);
  auto model = makeModel<std::variant_alternative_t<index, BsdfModels<F>>, count>([&](auto i) {
    if constexpr (i < kFirst) {
      return p.first[i];
    } else {
      return others[(i - kFirst) / kBlock][(i - kFirst) % kBlock];
    }
  });
  if constexpr (requires { model.setOutsideEta(p.outsideEta); }) model.setOutsideEta(p.outsideEta);
  return model;
}

template <class F, std::size_t index, class Visit>
void MaterialTable::visitModel(const Parameters<F>& p, MaskOf<F> active, const Visit& visit) const {
  if ((present_ >> index & 1u) == 0) return;
  const MaskOf<F> mine = active & (p.model == UintOf<F>(static_cast<std::uint32_t>(index)));
  if (any(mine)) visit(modelOf<F, index>(p), mine);
}

template <class F, class Visit>
void MaterialTable::forEachModel(const Parameters<F>& parameters, MaskOf<F> active, const Visit& visit) const {
  [&]<std::size_t... index>(std::index_sequence<index...>) { (visitModel<F, index>(parameters, active, visit), ...); }
  (std::make_index_sequence<std::variant_size_v<Bsdf::Model>>{});
}

}  // namespace steradian
