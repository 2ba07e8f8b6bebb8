#include "steradian/core/samplers/sampler.h"

namespace steradian {

std::optional<SamplerType> samplerTypeOf(std::string_view name) {
  for (const SamplerType type : kSamplerTypes) {
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
    case SamplerType::Halton:
      return "halton";
    case SamplerType::Sobol:
      break;
    case SamplerType::SobolFull:
      return "sobol-full";
    case SamplerType::BlueNoise:
      return "blue-noise";
    case SamplerType::Pmj02:
      return "pmj02";
  }
  return "sobol";
}

}  // namespace steradian
