#pragma once
/// Integrators that show one property of what the camera sees.
#include "steradian/integrators/render/integrator.h"

namespace STERADIAN_API steradian {

/// (n + 1) / 2 of the unit shading normal, turned to the camera ("In One Weekend", 6.2); the sky where nothing is.
class NormalIntegrator final : public RadianceIntegrator {
 public:
  Rgb radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const override;
};

/// The share of light that the material reflects or lets through, 0..1; black where nothing is.
class AlbedoIntegrator final : public RadianceIntegrator {
 public:
  Rgb radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const override;
};

/// The distance from the camera in scene units; 0 where nothing is.
class DepthIntegrator final : public RadianceIntegrator {
 public:
  Rgb radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const override;
};

/// The cosine-weighted share of the hemisphere without a surface nearer than `distance` (scene units, > 0, may be
/// +inf); 0 where nothing is.
class AmbientOcclusionIntegrator final : public RadianceIntegrator {
 public:
  explicit AmbientOcclusionIntegrator(float distance = kInfinity) : distance_(distance) {}

  Rgb radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const override;

 private:
  float distance_;
};

}  // namespace steradian
