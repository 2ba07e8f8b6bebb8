#include "steradian/lights/light_selection.h"

#include <algorithm>

namespace steradian {

LightSelection::LightSelection(std::span<const float> weights) {
  if (std::none_of(weights.begin(), weights.end(), [](float w) { return w > 0.0f; })) return;
  if (weights.size() <= kMaxInverted) {
    table_.emplace<PiecewiseConstant1D>(weights);
  } else {
    table_.emplace<AliasTable>(weights);
  }
}

float LightSelection::probability(std::size_t index) const {
  if (const auto* table = std::get_if<PiecewiseConstant1D>(&table_)) return table->probability(index);
  if (const auto* table = std::get_if<AliasTable>(&table_)) return table->probability(index);
  return 0.0f;
}

}  // namespace steradian
