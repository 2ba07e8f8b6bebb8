#include "steradian/apps/bench/renders.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

#include "steradian/apps/bench/bench_scenes.h"
#include "steradian/apps/bench/machine.h"
#include "steradian/apps/bench/measure.h"
#include "steradian/apps/bench/replay.h"
#include "steradian/integrators/path/path.h"
#include "steradian/integrators/render/render.h"

namespace steradian::bench {
namespace {

constexpr std::uint32_t kSamplesPerPixel = 16;
/// Rays are recorded for at most this many samples: they take about 300 bytes a sample.
constexpr std::uint64_t kMaxRecordedSamples = 1'500'000;

/// Rates are per second of all threads together.
struct Row {
  std::string scene;
  std::size_t primitives = 0;
  double buildSeconds = 0.0;     ///< of the whole Scene
  double geometrySeconds = 0.0;  ///< of it, clusters and hierarchies
  double bytesPerPrimitive = 0.0;
  double samples = 0.0, rays = 0.0, tracedRays = 0.0;

  double share() const { return rays / tracedRays; }
};

std::unique_ptr<const Scene> build(Threads& threads, const std::string& name, int repeats, Row& row) {
  std::unique_ptr<const Scene> scene;
  std::vector<double> seconds, geometrySeconds;
  for (int i = 0; i < repeats; ++i) {
    scene.reset();
    SceneDescription description = benchScene(name);
    seconds.push_back(
        secondsOf([&] { threads.run([&] { scene = std::make_unique<Scene>(std::move(description)); }); }));
    geometrySeconds.push_back(scene->geometry().statistics().buildSeconds);
  }
  const GeometryStatistics statistics = scene->geometry().statistics();
  row.primitives = statistics.primitives();
  row.buildSeconds = median(seconds);
  row.geometrySeconds = median(geometrySeconds);
  row.bytesPerPrimitive = static_cast<double>(statistics.bytes) / static_cast<double>(statistics.primitives());
  return scene;
}

RenderSettings settingsFor(const BenchOptions& options) {
  RenderSettings settings;
  settings.width = options.width;
  settings.height = options.height;
  settings.samplesPerPixel = options.samplesPerPixel.value_or(kSamplesPerPixel);
  settings.execution.width = options.pathWidth;
  return settings;
}

/// The rays of the render's first samples, as many as there is room for.
std::vector<RecordedRay> recordFor(const Scene& scene, RenderSettings settings) {
  const std::uint64_t pixels =
      static_cast<std::uint64_t>(*settings.width) * static_cast<std::uint64_t>(*settings.height);
  const std::uint64_t room = std::max<std::uint64_t>(kMaxRecordedSamples / pixels, 1);
  settings.samplesPerPixel = static_cast<std::uint32_t>(std::min<std::uint64_t>(*settings.samplesPerPixel, room));
  return recordRays(scene, {}, settings);
}

Row measure(Threads& threads, const std::string& name, const BenchOptions& options) {
  Row row{.scene = name};
  const std::unique_ptr<const Scene> scene = build(threads, name, options.repeats, row);
  const RenderSettings settings = settingsFor(options);
  const std::vector<RecordedRay> rays = recordFor(*scene, settings);
  std::vector<double> samples, rendered, traced;
  for (int i = 0; i < options.repeats; ++i) {
    // In turns, so that changes of the machine's speed affect both.
    const RenderStatistics statistics =
        threads.run([&] { return render(*scene, PathIntegrator(), settings); }).statistics;
    const PathCounts& paths = statistics.paths;
    const auto count = static_cast<double>(paths.cameraRays + paths.bounceRays + paths.shadowRays);
    samples.push_back(static_cast<double>(statistics.samples) / statistics.sampleSeconds);
    rendered.push_back(count / statistics.sampleSeconds);
    std::uint64_t hits = 0;
    const double seconds =
        secondsOf([&] { hits = threads.run([&] { return replay(scene->geometry(), rays, options.pathWidth != 1); }); });
    if (hits > 0) traced.push_back(static_cast<double>(rays.size()) / seconds);
  }
  if (traced.empty()) throw Error(ErrorKind::Usage, name + ": its rays hit nothing");
  row.samples = median(samples);
  row.rays = median(rendered);
  row.tracedRays = median(traced);
  return row;
}

void printRow(const Row& row) {
  fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} % |\n", row.scene,
             row.primitives, row.buildSeconds, row.geometrySeconds, row.bytesPerPrimitive, row.samples / 1e6,
             row.rays / 1e6, row.tracedRays / 1e6, row.share() * 100.0);
  std::fflush(stdout);
}

nlohmann::json toJson(const Row& row) {
  return {{"scene", row.scene},
          {"primitives", row.primitives},
          {"build_seconds", row.buildSeconds},
          {"geometry_build_seconds", row.geometrySeconds},
          {"bytes_per_primitive", row.bytesPerPrimitive},
          {"samples_per_second", row.samples},
          {"rays_per_second", row.rays},
          {"trace_only_rays_per_second", row.tracedRays},
          {"share_of_trace_only", row.share()}};
}

}  // namespace

void runRenders(const BenchOptions& options) {
  std::vector<std::string> scenes = options.scenes;
  if (scenes.empty()) scenes = {"cornell-box", "one-weekend", "cornell-city:166667", "cornell-city:1666667"};
  if (!options.json) {
    fmt::print(
        "\nWhole renders, {} x {}, {} spp, {} threads, medians of {}\n\n"
        "| scene | primitives | build s | of it geometry | bytes/primitive | Msamples/s | Mray/s | trace-only Mray/s | "
        "share |\n|---|---|---|---|---|---|---|---|---|\n",
        options.width, options.height, *settingsFor(options).samplesPerPixel, options.threads, options.repeats);
  }
  Threads threads(options.threads);
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& scene : scenes) {
    const Row row = measure(threads, scene, options);
    if (options.json) {
      rows.push_back(toJson(row));
    } else {
      printRow(row);
    }
  }
  if (options.json) fmt::print("{}\n", nlohmann::json{{"machine", machineLine()}, {"renders", rows}}.dump(1));
}

}  // namespace steradian::bench
