#include <fmt/format.h>

#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include "steradian/accel/shapes/clusters/cluster.h"
#include "steradian/apps/bench/micro.h"
#include "steradian/apps/bench/micro_loop.h"
#include "steradian/apps/scenes/scenes.h"
#include "steradian/integrators/path/record_rays.h"

namespace steradian::bench {
namespace {

enum Generation : std::size_t { kCamera, kBounce1, kBounce2, kShadow1, kGenerations };
constexpr std::array<const char*, kGenerations> kNames{"camera", "bounce-1", "bounce-2", "shadow-1"};

/// A scene and the first rays of its paths, made on first use: a filter may select none of them.
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

/// Random boxes in a cube, in this many clusters, with a hierarchy or without, and rays from within.
void measureLayout(benchmark::State& state, std::uint32_t clusters, bool hierarchy) {
  const std::uint32_t count = clusters * kClusterSize;
  const auto number = [](std::uint32_t i, std::uint32_t k) { return toUnitFloat<float>(randomWords(i, k, 0u, 0u)[0]); };
  const auto point = [&](std::uint32_t i, std::uint32_t k) {
    return Vec3f{number(i, k), number(i, k + 1), number(i, k + 2)};
  };
  const float half = 0.35f / std::cbrt(static_cast<float>(count));
  BoxSet boxes;
  for (std::uint32_t i = 0; i < count; ++i) boxes.addRotatedY(point(i, 0), {half, half, half}, 90.0f * number(i, 3));
  const auto scene = std::make_shared<SceneDescription>();
  scene->addShape("boxes", std::move(boxes), kNone);
  std::vector<Ray<float>> rays;
  for (std::uint32_t i = 0; i < 4096; ++i) {
    rays.push_back({point(i, 4), UniformSphere<float>::sample({number(i, 7), number(i, 8)})});
  }
  const Geometry geometry(scene, {.accel = {.maxClustersWithoutTree = hierarchy ? 0 : clusters}});
  measureRays(state, rays.size(), [&](std::size_t i) { return geometry.intersect(rays[i]); });
}

}  // namespace

void registerQueryBenchmarks() {
  for (const std::uint32_t clusters : {1u, 2u, 3u, 4u, 6u, 8u, 12u}) {
    for (const bool hierarchy : {false, true}) {
      benchmark::RegisterBenchmark(
          fmt::format("layout/{}-clusters/{}", clusters, hierarchy ? "hierarchy" : "all").c_str(),
          [clusters, hierarchy](benchmark::State& state) { measureLayout(state, clusters, hierarchy); });
    }
  }
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
