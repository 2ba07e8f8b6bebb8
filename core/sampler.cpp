#include "steradian/core/sampler.h"

namespace steradian {

std::optional<SamplerType> samplerTypeOf(std::string_view name) {
  for (const SamplerType type : {SamplerType::Independent, SamplerType::Stratified, SamplerType::Sobol}) {
    if (name == nameOf(type)) return type;
  }
  return std::nullopt;
}

std::string_view nameOf(SamplerType type) {
  switch (type) {
    case SamplerType::Independent:
      return "independent";
    case SamplerType::Stratified:
      return "stratified";
    case SamplerType::Sobol:
      break;
  }
  return "sobol";
}

}  // namespace steradian
