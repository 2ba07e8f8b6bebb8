#pragma once
/// Chooses one of many lights with probabilities in proportion to weights.
#include <cstddef>
#include <span>
#include <variant>

#include "steradian/core/sampling/distribution.h"

namespace STERADIAN_API steradian {

/// Up to kMaxInverted entries by inverting the cumulative distribution, which keeps the stratification of
/// low-discrepancy numbers; more by the alias method, in constant time.
class LightSelection {
 public:
  static constexpr std::size_t kMaxInverted = 256;

  /// Weights are >= 0, and need not add up to 1. If all are zero, or there are none, nothing can be chosen.
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
