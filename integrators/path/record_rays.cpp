#include "steradian/integrators/path/record_rays.h"

#include "steradian/core/base/parallel.h"
#include "steradian/integrators/path/path.h"
#include "steradian/integrators/path/path_context.h"
#include "steradian/integrators/path/path_loop.h"
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

/// Paths whose rays all go to one list: for one thread.
class RecordingIntegrator final : public Integrator {
 public:
  RecordingIntegrator(const PathSettings& path, std::vector<RecordedRay>& rays) : path_(path), rays_(rays) {}

  std::unique_ptr<const PreparedIntegrator> prepare(const Scene& scene, const ExecutionSettings&) const override {
    return std::make_unique<Prepared>(scene, path_.settings(), rays_);
  }

 private:
  class Prepared final : public PreparedSampleIntegrator {
   public:
    Prepared(const Scene& scene, const PathSettings& path, std::vector<RecordedRay>& rays)
        : context_(scene, path), rays_(rays) {}
    PixelSample evaluate(const Ray<float>& ray, const Sampler<float>& sampler, PathCounts& counts) const override {
      RecordingQueries queries(context_.scene(), counts, rays_);
      return tracePath(context_.plan(), queries, ray, sampler);
    }

   private:
    PathContext context_;
    std::vector<RecordedRay>& rays_;
  };

  PathIntegrator path_;
  std::vector<RecordedRay>& rays_;
};

}  // namespace

std::vector<RecordedRay> recordRays(const Scene& scene, const PathSettings& path, const RenderSettings& settings) {
  std::vector<RecordedRay> rays;
  onOneThread([&] { render(scene, RecordingIntegrator(path, rays), settings); });
  return rays;
}

}  // namespace steradian
