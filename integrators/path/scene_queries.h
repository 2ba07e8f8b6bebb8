#pragma once
/// The questions that path tracing asks a scene.
#include "steradian/integrators/render/render_statistics.h"
#include "steradian/integrators/scene/scene.h"
#include "steradian/integrators/volumes/crossings.h"
#include "steradian/integrators/volumes/free_flight.h"
#include "steradian/lights/target_set.h"

namespace STERADIAN_API steradian {

/// Answers the questions of the path loop (path_loop.h) from a scene, and counts the rays. The loop takes this type as
/// a template parameter, so that a benchmark can record rays and a test can falsify a density without cost to renders:
/// derive from it, and hide the functions that are to behave otherwise.
class SceneQueries {
 public:
  SceneQueries(const Scene& scene, PathCounts& counts) : scene_(scene), counts_(counts) {}

  Hit<float> intersect(const Ray<float>& ray) { return scene_.geometry().intersect(ray, &counts_.embree); }
  bool occluded(const Ray<float>& ray) {
    countShadowRay();
    return scene_.geometry().occluded(ray, &counts_.embree);
  }
  void countShadowRay() { ++counts_.shadowRays; }
  const Volumes& volumes() const { return scene_.volumes(); }
  InteriorStack interiorAtStart(const Ray<float>& cameraRay) const { return scene_.interiorAtStart(cameraRay); }
  SurfacePoint<float> surfacePoint(const Ray<float>& ray, const Hit<float>& hit) const {
    return scene_.geometry().surfacePoint(ray, hit);
  }
  /// `outsideEta`: see Boundary.
  Bsdf bsdf(const SurfacePoint<float>& point, Vec3f wo, float outsideEta) const {
    return scene_.materials().bsdf(point, wo, outsideEta);
  }

  LightSample<float> sampleLight(const LightSet& lights, const ScatterPoint<float>& from,
                                 LightRandom<float> random) const {
    return lights.sample(from, random);
  }
  Emission<float> emission(const LightSet& lights, const ScatterPoint<float>& from, const Ray<float>& ray,
                           const SurfacePoint<float>& hit) const {
    return lights.emission(from, ray, hit);
  }
  DirectionSample<float> sampleTarget(const TargetSet& targets, const ScatterPoint<float>& from,
                                      LightRandom<float> random) const {
    return targets.sampleDirection(from, random);
  }
  float targetPdf(const TargetSet& targets, const ScatterPoint<float>& from, Vec3f wi) const {
    return targets.pdfDirection(from, wi);
  }
  void countPath(std::uint32_t bounces) { counts_.countPath(bounces); }

 private:
  const Scene& scene_;
  PathCounts& counts_;
};

}  // namespace steradian
