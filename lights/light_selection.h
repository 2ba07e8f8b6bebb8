#pragma once
/// Chooses one of many by weight.
#include <cstddef>
#include <span>
#include <variant>

#include "steradian/core/sampling/distribution.h"

namespace STERADIAN_API steradian {

/// Few entries by the inverse of the cumulative sum, which keeps the order of low-discrepancy numbers; many by the
/// alias method, in constant time.
class LightSelection {
 public:
  static constexpr std::size_t few = 256;

  /// Weights >= 0 of any sum. All zero, or none: nothing can be chosen.
  explicit LightSelection(std::span<const float> weights);

  template <class F>
  struct Choice {
    UintOf<F> index{0u};
    F probability{0.0f};  ///< 0: nothing was chosen
  };
  /// u in [0, 1).
  template <class F>
  Choice<F> choose(F u) const {
    if (const auto* table = std::get_if<PiecewiseConstant1D>(&table_)) {
      const UintOf<F> index = table->sample(u).bin;
      return {index, table->probabilityOf<F>(index)};
    }
    if (const auto* table = std::get_if<AliasTable>(&table_)) {
      const auto s = table->sample(u);
      return {s.index, s.probability};
    }
    return {};
  }
  float probability(std::size_t index) const;
  /// Nothing can be chosen.
  bool empty() const { return std::holds_alternative<Nothing>(table_); }

 private:
  struct Nothing {};
  std::variant<Nothing, PiecewiseConstant1D, AliasTable> table_;
};

}  // namespace steradian
