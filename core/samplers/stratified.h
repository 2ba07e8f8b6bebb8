#pragma once
/// Jittered strata in a random order, without a table: the stratum of sample `place` of `count` is computed.
#include <cmath>

#include "steradian/core/samplers/permutation.h"
#include "steradian/core/samplers/rng.h"

namespace STERADIAN_API steradian {

/// (cell + jitter) / cells; rounding must not reach 1.
template <class F>
F jittered(UintOf<F> cell, UintOf<F> jitter, std::uint32_t cells) {
  const F x = (toFloat(toSigned(cell)) + toUnitFloat<F>(jitter)) / F(static_cast<float>(cells));
  return minimum(x, F(kOneMinusEpsilon));
}

/// One number in each of `count` strata, 1 <= count <= 2^24: the samples place = 0 ... count - 1 that share a key. The
/// jitter must be another random word for each sample.
template <class F>
F stratified1D(UintOf<F> place, std::uint32_t count, const std::array<UintOf<F>, 4>& key, UintOf<F> jitter) {
  return jittered<F>(permute(place, count, key), jitter, count);
}

/// The same in a grid of about sqrt(count) x sqrt(count) cells.
template <class F>
Vec2<F> stratified2D(UintOf<F> place, std::uint32_t count, const std::array<UintOf<F>, 4>& key, UintOf<F> jitterX,
                     UintOf<F> jitterY) {
  using Uint = UintOf<F>;
  // Columns times rows may exceed the count: then some random cells stay empty, and each sample is uniform still.
  const auto columns = static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)));
  const std::uint32_t rows = (count + columns - 1) / columns;
  Uint column(0u);
  const Uint row = divide(permute(place, columns * rows, key), columns, column);
  return {jittered<F>(column, jitterX, columns), jittered<F>(row, jitterY, rows)};
}

}  // namespace steradian
