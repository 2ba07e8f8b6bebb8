#include "steradian/materials/bsdf.h"

namespace steradian {

Rgb Bsdf::albedo(Vec3f wo) const {
  const Vec3f localWo = frame_.toLocal(wo);
  return std::visit([&](const auto& model) { return model.albedo(localWo); }, model_);
}

}  // namespace steradian
