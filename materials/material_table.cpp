#include "steradian/materials/material_table.h"

namespace steradian {

MaterialTable::MaterialTable(const MaterialSet& materials)
    : materials_(&materials), present_(std::variant_size_v<Bsdf::Model>, false) {
  const std::size_t count = materials.size() + 1;
  for (std::size_t id = 0; id < count; ++id) {
    const Bsdf::Model model = id < materials.size() ? materials.model(static_cast<Id>(id)) : Absorber<float>{};
    Record record{static_cast<std::uint32_t>(model.index()), 0.0f, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f};
    present_[model.index()] = true;
    std::visit(
        [&](const auto& m) {
          if constexpr (requires { m.reflectance; }) {
            record.red = m.reflectance.r;
            record.green = m.reflectance.g;
            record.blue = m.reflectance.b;
          }
          if constexpr (requires { m.eta; }) {
            record.eta = m.eta;
            coloursOnly_ = false;
          }
          if constexpr (requires { m.fuzz; }) {
            record.fuzz = m.fuzz;
            coloursOnly_ = false;
          }
          if constexpr (requires { m.internalReflectance; }) record.internalReflectance = m.internalReflectance;
          if constexpr (requires { m.schlick; }) record.schlick = m.schlick ? 1.0f : 0.0f;
        },
        model);
    records_.push_back(record);
    const Id texture = id < materials.size() ? materials.texture(static_cast<Id>(id)) : kNone;
    textureOf_.push_back(texture);
    textured_ = textured_ || texture != kNone;
    readsUv_ = readsUv_ || materials.textures().readsUv(texture);
  }
}

}  // namespace steradian
