#include "steradian/materials/material_table.h"

#include <algorithm>

namespace steradian {

MaterialTable::MaterialTable(const MaterialSet& materials) : materials_(&materials) {
  for (Id id = 0; id < materials.size(); ++id) {
    add(materials.model(id));
    const Id texture = materials.texture(id);
    textureOf_.push_back(texture);
    textured_ = textured_ || texture != kNone;
    readsUv_ = readsUv_ || materials.textures().readsUv(texture);
  }
  add(Absorber<float>{});
  textureOf_.push_back(kNone);
  constexpr std::size_t largest = sizeof(Bsdf::Model) / sizeof(float);
  blocks_.resize(blocks_.size() + largest + kBlock);
}

void MaterialTable::add(const Bsdf::Model& model) {
  const std::size_t block = blocks_.size() / kBlock;
  if (block >= std::size_t{1} << (32 - kModelBits)) {
    throw Error(ErrorKind::Scene, "the materials of the scene have more parameters than its table can hold");
  }
  const auto index = static_cast<std::uint32_t>(model.index());
  Record record{index | static_cast<std::uint32_t>(block) << kModelBits, {}};
  std::visit(
      [&](const auto& m) {
        const auto parameters = parametersOf(m);
        const std::size_t first = std::min<std::size_t>(parameters.size(), kFirst);
        std::copy_n(parameters.begin(), first, record.first.begin());
        blocks_.insert(blocks_.end(), parameters.begin() + first, parameters.end());
      },
      model);
  blocks_.resize((blocks_.size() + kBlock - 1) / kBlock * kBlock);
  records_.push_back(record);
  present_ |= 1u << index;
}

}  // namespace steradian
