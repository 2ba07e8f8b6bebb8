#include <array>
#include <memory>
#include <optional>

#include "steradian/apps/bench/micro.h"
#include "steradian/apps/bench/micro_loop.h"
#include "steradian/apps/scenes/scenes.h"
#include "steradian/integrators/record_rays.h"

namespace steradian::bench {
namespace {

enum Generation : std::size_t { kCamera, kBounce1, kBounce2, kShadow1, kGenerations };
constexpr std::array<const char*, kGenerations> kNames{"camera", "bounce-1", "bounce-2", "shadow-1"};

/// A scene and the first rays of its paths, made when first asked for: a filter may select none of them.
class Workload {
 public:
  explicit Workload(std::string scene) : name_(std::move(scene)) {}

  const Geometry& geometry() {
    prepare();
    return scene_->geometry();
  }
  const std::vector<Ray<float>>& rays(Generation generation) {
    prepare();
    return rays_[generation];
  }

 private:
  void prepare() {
    if (scene_) return;
    scene_ = std::make_unique<Scene>(makeScene(name_));
    RenderSettings settings;
    settings.width = settings.height = 256;
    settings.samplesPerPixel = 1;
    PathSettings path;
    path.maxDepth = 2;
    std::size_t bounces = 0;
    for (const RecordedRay& recorded : recordRays(*scene_, path, settings)) {
      if (recorded.kind == RayKind::Camera) bounces = 0;
      if (recorded.kind == RayKind::Bounce) ++bounces;
      if (recorded.kind != RayKind::Shadow) {
        rays_[kCamera + bounces].push_back(recorded.ray);
      } else if (bounces == 0) {
        rays_[kShadow1].push_back(recorded.ray);
      }
    }
  }

  std::string name_;
  std::unique_ptr<const Scene> scene_;
  std::array<std::vector<Ray<float>>, kGenerations> rays_;
};

void measureGeneration(benchmark::State& state, Workload& workload, Generation generation) {
  const Geometry& geometry = workload.geometry();
  const std::vector<Ray<float>>& rays = workload.rays(generation);
  if (rays.empty()) return state.SkipWithError("has no such rays");
  if (generation == kShadow1) {
    measureRays(state, rays.size(), [&](std::size_t i) { return geometry.occluded(rays[i]); });
  } else {
    measureRays(state, rays.size(), [&](std::size_t i) { return geometry.intersect(rays[i]); });
  }
}

}  // namespace

void registerQueryBenchmarks() {
  for (const char* scene : {"cornell-box", "one-weekend", "cornell-city:166667"}) {
    const auto workload = std::make_shared<Workload>(scene);
    for (const Generation generation : {kCamera, kBounce1, kBounce2, kShadow1}) {
      const std::string query = generation == kShadow1 ? "occluded/" : "intersect/";
      benchmark::RegisterBenchmark(
          (query + scene + "/" + kNames[generation]).c_str(),
          [workload, generation](benchmark::State& state) { measureGeneration(state, *workload, generation); });
    }
  }
}

}  // namespace steradian::bench
