#pragma once
/// The books' ray_color with its mistakes: needed for some of their pictures, and kept out of the library.
#include "steradian/integrators/render/integrator.h"

namespace steradian::books {

enum class Mistake {
  None,                ///< the picture is rendered as its command says
  UniformDenominator,  ///< "The Rest of Your Life", listing 20: directions have the material's density, but are divided
                       ///< by 1 / 2 pi
  AlwaysRefracts       ///< "In One Weekend", listings 72 and 76: refracts wherever it can
};

/// Follows the material without sampling lights and without roulette, to the depth of the scene, with one mistake.
class BookIntegrator final : public RadianceIntegrator {
 public:
  explicit BookIntegrator(Mistake mistake) : mistake_(mistake) {}

  /// Biased.
  Rgb radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const override;

 private:
  Mistake mistake_;
};

}  // namespace steradian::books
