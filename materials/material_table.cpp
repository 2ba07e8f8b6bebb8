#include "steradian/materials/material_table.h"

#include <algorithm>

namespace steradian {

MaterialTable::MaterialTable(const MaterialSet& materials)
    : materials_(&materials), present_(std::variant_size_v<Bsdf::Model>, false) {
  const std::size_t count = materials.size() + 1;
  model_.resize(count);
  values_.resize(kRows * count);
  for (std::size_t id = 0; id < count; ++id) {
    const Bsdf::Model model = id < materials.size() ? materials.model(static_cast<Id>(id)) : Absorber<float>{};
    const auto put = [&](Row row, float value) { values_[static_cast<std::size_t>(row) * count + id] = value; };
    model_[id] = static_cast<std::uint32_t>(model.index());
    present_[model.index()] = true;
    std::visit(
        [&](const auto& m) {
          if constexpr (requires { m.reflectance; }) {
            put(kRed, m.reflectance.r);
            put(kGreen, m.reflectance.g);
            put(kBlue, m.reflectance.b);
          }
          put(kEta, 1.0f);
          if constexpr (requires { m.eta; }) put(kEta, m.eta);
          if constexpr (requires { m.fuzz; }) put(kFuzz, m.fuzz);
          if constexpr (requires { m.internalReflectance; }) put(kInternal, m.internalReflectance);
          if constexpr (requires { m.schlick; }) put(kSchlick, m.schlick ? 1.0f : 0.0f);
        },
        model);
    if (id < materials.size() && materials.isTextured(static_cast<Id>(id))) textured_ = true;
  }
  for (std::size_t row = 0; row < kRows; ++row) {
    const auto first = values_.begin() + static_cast<std::ptrdiff_t>(row * count);
    if (std::equal(first + 1, first + static_cast<std::ptrdiff_t>(count), first)) uniform_[row] = *first;
  }
}

}  // namespace steradian
