#pragma once
/// The parameters of a BSDF model as floats one after another: how tables keep materials, each with as many as its
/// model has.
///
/// A model (materials/bsdf.h lists them) is an aggregate whose members are its parameters: F or Spectrum<F>, nothing
/// else. If it has a `reflectance`, which textures may set, that comes first. The assertions here say so at compile
/// time.
#include <array>
#include <bit>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

namespace detail {
template <class Model, std::size_t... i>
constexpr bool isMadeOfFloats(std::index_sequence<i...>) {
  // A bool or an integer would be a narrowing conversion; one float more is one too many.
  return requires(float x) { Model{(static_cast<void>(i), x)...}; }
  &&!requires(float x) { Model{x, (static_cast<void>(i), x)...}; };
}
template <class Model>
constexpr std::size_t countParameters() {
  constexpr std::size_t bytes = std::is_empty_v<Model> ? 0 : sizeof(Model), count = bytes / sizeof(float);
  static_assert(isMadeOfFloats<Model>(std::make_index_sequence<count>{}),
                "a model has parameters F or Spectrum<F> only");
  if constexpr (requires(Model model) { model.reflectance; }) {
    static_assert(offsetof(Model, reflectance) == 0, "a model's reflectance is its first parameter");
  }
  return count;
}
}  // namespace detail

/// The number of parameters of a model at width 1; a Spectrum counts as three.
template <class Model>
inline constexpr std::size_t kParameterCount = detail::countParameters<Model>();

/// The parameters of a model at width 1, in the order of its members.
template <class Model>
std::array<float, kParameterCount<Model>> parametersOf(const Model& model) {
  if constexpr (kParameterCount<Model> == 0) {
    return {};
  } else {
    return std::bit_cast<std::array<float, kParameterCount<Model>>>(model);
  }
}

/// The model (of any width) whose i-th parameter is parameter(std::integral_constant<std::size_t, i>), for i < count.
template <class Model, std::size_t count, class Parameter>
Model makeModel(const Parameter& parameter) {
  return [&]<std::size_t... i>(std::index_sequence<i...>) {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-braces"  // those of the Spectrum in the model
    return Model{parameter(std::integral_constant<std::size_t, i>{})...};
#pragma GCC diagnostic pop
  }
  (std::make_index_sequence<count>{});
}

}  // namespace steradian
