#include "steradian/apps/bench/structures.h"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "steradian/apps/bench/bench_scenes.h"
#include "steradian/apps/bench/machine.h"
#include "steradian/apps/bench/measure.h"
#include "steradian/apps/bench/replay.h"
#include "steradian/core/base/diagnostics.h"
#include "steradian/core/base/float_mode.h"

namespace steradian::bench {
namespace {

constexpr std::uint64_t kSamples = 400'000;  ///< whose rays are recorded

constexpr std::array<RayKind, 3> kKinds{RayKind::Camera, RayKind::Bounce, RayKind::Shadow};
using Rates = std::array<double, kKinds.size()>;  ///< rays per second; 0: not measured

/// The rays of each kind, in the order in which a render traces them.
using RaysByKind = std::array<std::vector<RecordedRay>, kKinds.size()>;

RaysByKind recordFor(const std::string& name, const BenchOptions& options) {
  const Scene scene(benchScene(name));
  RenderSettings settings;
  settings.width = options.width;
  settings.height = options.height;
  const auto pixels = static_cast<std::uint64_t>(options.width) * static_cast<std::uint64_t>(options.height);
  settings.samplesPerPixel = static_cast<std::uint32_t>(std::max<std::uint64_t>(kSamples / pixels, 1));
  RaysByKind rays;
  for (const RecordedRay& ray : recordRays(scene, {}, settings)) {
    for (std::size_t k = 0; k < kKinds.size(); ++k)
      if (kKinds[k] == ray.kind) rays[k].push_back(ray);
  }
  return rays;
}

std::uint64_t tracePackets(const Geometry& geometry, const std::vector<RecordedRay>& rays) {
  constexpr std::size_t width = 8;
  const FlushDenormals floatMode;
  std::array<Ray<float>, width> packet;
  std::array<Hit<float>, width> hits;
  std::uint64_t count = 0;
  for (std::size_t first = 0; first < rays.size(); first += width) {
    const std::size_t n = std::min(width, rays.size() - first);
    for (std::size_t i = 0; i < n; ++i) packet[i] = rays[first + i].ray;
    geometry.intersectPacket(std::span(packet).first(n), std::span(hits).first(n));
    for (std::size_t i = 0; i < n; ++i) count += hits[i].valid ? 1u : 0u;
  }
  return count;
}

/// Processor time of this thread: other work on the machine does not count.
double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// One way to trace rays.
struct Contender {
  std::string name;
  Accel accel;
  bool several = false, packets = false;

  std::shared_ptr<const Geometry> geometry = nullptr;
  std::array<std::vector<double>, kKinds.size()> rates = {};
};

/// The first is what a render uses, where several rays are traced at once if they are flat.
std::vector<Contender> contendersFor(const std::string& scene) {
  std::vector<Contender> contenders{
      {"auto", Accel::Auto, true},        {"flat, several rays", Accel::Flat, true},
      {"flat, single rays", Accel::Flat}, {"bvh8", Accel::Bvh8},
      {"embree", Accel::Embree},          {"embree, packets of 8", Accel::Embree, false, true}};
  const auto description = std::make_shared<const SceneDescription>(benchScene(scene));
  std::array<std::shared_ptr<const Geometry>, 4> built;
  std::vector<Contender> possible;
  for (Contender& contender : contenders) {
    std::shared_ptr<const Geometry>& geometry = built[static_cast<std::size_t>(contender.accel)];
    if (!geometry) {
      try {
        geometry = std::make_shared<const Geometry>(description, GeometrySettings{.accel = {.accel = contender.accel}});
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::Usage) throw;
        continue;  // a structure that the scene cannot have
      }
    }
    contender.geometry = geometry;
    if (contender.accel == Accel::Auto) contender.name += ": " + describe(geometry->statistics().accel);
    possible.push_back(std::move(contender));
  }
  return possible;
}

void measureOnce(Contender& contender, const RaysByKind& rays) {
  for (std::size_t k = 0; k < kKinds.size(); ++k) {
    if (rays[k].empty() || (contender.packets && kKinds[k] == RayKind::Shadow)) continue;
    const double start = threadSeconds();
    const std::uint64_t hits = contender.packets ? tracePackets(*contender.geometry, rays[k])
                                                 : replay(*contender.geometry, rays[k], contender.several);
    const double seconds = threadSeconds() - start;
    if (hits > 0) contender.rates[k].push_back(static_cast<double>(rays[k].size()) / seconds);
  }
}

}  // namespace

void runStructures(const BenchOptions& options) {
  std::vector<std::string> scenes = options.scenes;
  if (scenes.empty())
    scenes = {"cornell-box", "one-weekend", "cornell-city:20000", "cornell-tower:1000", "mesh-room:100000"};
  if (!options.json) {
    fmt::print(
        "\nAcceleration structures, Mray/s by the processor time of one thread, medians of {}\n\n| scene | structure | "
        "camera | bounces | "
        "shadow |\n|---|---|---|---|---|\n",
        options.repeats);
  }
  Threads one(1);
  nlohmann::json rows = nlohmann::json::array();
  for (const std::string& scene : scenes) {
    const RaysByKind rays = recordFor(scene, options);
    std::vector<Contender> contenders = contendersFor(scene);
    for (int i = 0; i < options.repeats; ++i) {
      // In turns, so that all see the same moods of the machine.
      for (Contender& contender : contenders) one.run([&] { measureOnce(contender, rays); });
    }
    for (const Contender& contender : contenders) {
      std::array<std::string, kKinds.size()> texts;
      nlohmann::json row{{"scene", scene}, {"structure", contender.name}};
      for (std::size_t k = 0; k < kKinds.size(); ++k) {
        const std::vector<double>& rates = contender.rates[k];
        texts[k] = rates.empty() ? "" : fmt::format("{:.2f}", median(rates) / 1e6);
        static constexpr std::array<const char*, kKinds.size()> kNames{"camera", "bounce", "shadow"};
        if (!rates.empty()) row[kNames[k]] = median(rates);
      }
      rows.push_back(row);
      if (options.json) continue;
      fmt::print("| {} | {} | {} | {} | {} |\n", scene, contender.name, texts[0], texts[1], texts[2]);
      std::fflush(stdout);
    }
  }
  if (options.json) fmt::print("{}\n", nlohmann::json{{"machine", machineLine()}, {"structures", rows}}.dump(1));
}

}  // namespace steradian::bench
