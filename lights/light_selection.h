#pragma once
/// Chooses one of many by weight.
#include <cstddef>
#include <span>
#include <variant>

#include "steradian/core/distribution.h"

namespace steradian {

/// Few entries by the inverse of the cumulative sum, which keeps the order of low-discrepancy numbers; many by the
/// alias method, in constant time.
class LightSelection {
 public:
  static constexpr std::size_t few = 256;

  /// Weights >= 0 of any sum. All zero, or none: nothing can be chosen.
  explicit LightSelection(std::span<const float> weights);

  struct Choice {
    std::size_t index;
    float probability;  ///< 0: nothing was chosen
  };
  /// u in [0, 1).
  Choice choose(float u) const;
  float probability(std::size_t index) const;
  /// Nothing can be chosen.
  bool empty() const { return std::holds_alternative<Nothing>(table_); }

 private:
  struct Nothing {};
  std::variant<Nothing, PiecewiseConstant1D, AliasTable> table_;
};

}  // namespace steradian
