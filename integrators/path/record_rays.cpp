#include "steradian/integrators/path/record_rays.h"

#include "steradian/core/base/parallel.h"
#include "steradian/integrators/path/path.h"
#include "steradian/integrators/render/render.h"

namespace steradian {
namespace {

class RecordingQueries : public SceneQueries {
 public:
  RecordingQueries(const Scene& scene, PathCounts& counts, std::vector<RecordedRay>& rays)
      : SceneQueries(scene, counts), rays_(rays) {}

  Hit<float> intersect(const Ray<float>& ray) {
    rays_.push_back({ray, first_ ? RayKind::Camera : RayKind::Bounce});
    first_ = false;
    return SceneQueries::intersect(ray);
  }
  bool occluded(const Ray<float>& ray) {
    rays_.push_back({ray, RayKind::Shadow});
    return SceneQueries::occluded(ray);
  }

 private:
  std::vector<RecordedRay>& rays_;
  bool first_ = true;
};

/// For one thread: all its rays go to one list.
class RecordingIntegrator final : public RadianceIntegrator {
 public:
  RecordingIntegrator(const Scene& scene, const PathSettings& path, std::vector<RecordedRay>& rays)
      : tracer_(scene, path), rays_(rays) {}

  Rgb radiance(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler) const override {
    PathCounts counts;
    return evaluate(scene, ray, sampler, counts).radiance;
  }
  PixelSample evaluate(const Scene& scene, const Ray<float>& ray, const Sampler<float>& sampler,
                       PathCounts& counts) const override {
    RecordingQueries queries(scene, counts, rays_);
    return tracePath(tracer_.plan(), queries, ray, sampler);
  }

 private:
  PathTracer tracer_;
  std::vector<RecordedRay>& rays_;
};

}  // namespace

std::vector<RecordedRay> recordRays(const Scene& scene, const PathSettings& path, const RenderSettings& settings) {
  std::vector<RecordedRay> rays;
  onOneThread([&] { render(scene, RecordingIntegrator(scene, PathIntegrator(path).settings(), rays), settings); });
  return rays;
}

}  // namespace steradian
