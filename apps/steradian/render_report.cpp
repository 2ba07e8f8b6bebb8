#include "steradian/apps/steradian/render_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "steradian/apps/steradian/console.h"

namespace steradian::app {

namespace {

using nlohmann::json;

json statisticsJson(const std::string& sceneName, int threads, const Scene& scene, const RenderResult& result,
                    const Phases& phases) {
  const RenderStatistics& s = result.statistics;
  const GeometryStatistics geometry = scene.geometry().statistics();
  json lengths = json::array();
  std::size_t last = s.paths.pathLengths.size();
  while (last > 0 && s.paths.pathLengths[last - 1] == 0) --last;
  for (std::size_t i = 0; i < last; ++i) lengths.push_back(s.paths.pathLengths[i]);
  json out;
  out["scene"] = sceneName;
  out["width"] = result.film.settings().width;
  out["height"] = result.film.settings().height;
  out["threads"] = threads;
  out["seed"] = result.settings.seed;
  out["stopped"] = result.stopped;
  out["render_seconds"] = s.renderSeconds;
  out["seconds"] = {{"build", phases.buildSeconds},
                    {"prepare", s.prepareSeconds},
                    {"sample", s.sampleSeconds},
                    {"write", phases.writeSeconds}};
  out["samples"] = s.samples;
  out["passes"] = s.passes;
  out["rays"] = {{"camera", s.paths.cameraRays}, {"bounce", s.paths.bounceRays}, {"shadow", s.paths.shadowRays}};
  out["path_lengths"] = lengths;
  out["accel"] = nameOf(geometry.accel.accel);
  out["embree"] = {{"rays", s.paths.embree.rays}, {"callbacks", s.paths.embree.callbacks}};
  out["primitives"] = geometry.primitives();
  out["clusters"] = geometry.clusters;
  out["bytes"] = {{"geometry", geometry.bytes}, {"film_per_pixel", Film::bytesPerPixel(result.settings.replicates)}};
  out["non_finite_samples"] = s.nonFiniteSamples;
  return out;
}

std::string asText(const json& j) {
  const double seconds = j["render_seconds"];
  const double samples = j["samples"];
  const double rays =
      j["rays"]["camera"].get<double>() + j["rays"]["bounce"].get<double>() + j["rays"]["shadow"].get<double>();
  std::string text = fmt::format("scene            {} ({}x{}, {} threads)\n", j["scene"].get<std::string>(),
                                 j["width"].get<int>(), j["height"].get<int>(), j["threads"].get<int>());
  text += fmt::format("seconds          build {:.3f}, render {:.3f}, write {:.3f}\n",
                      j["seconds"]["build"].get<double>(), seconds, j["seconds"]["write"].get<double>());
  text += fmt::format("samples          {:.0f} ({:.3f} M/s)\n", samples, samples / seconds / 1e6);
  text += fmt::format("rays             {:.0f} ({:.3f} M/s): camera {}, bounce {}, shadow {}\n", rays,
                      rays / seconds / 1e6, j["rays"]["camera"].get<std::uint64_t>(),
                      j["rays"]["bounce"].get<std::uint64_t>(), j["rays"]["shadow"].get<std::uint64_t>());
  text += fmt::format("accel            {}; by Embree {} rays, {} callbacks\n", j["accel"].get<std::string>(),
                      j["embree"]["rays"].get<std::uint64_t>(), j["embree"]["callbacks"].get<std::uint64_t>());
  text += fmt::format("geometry         {} clusters, {} bytes\n", j["clusters"].get<std::uint64_t>(),
                      j["bytes"]["geometry"].get<std::uint64_t>());
  return text + fmt::format("non-finite       {}\n", j["non_finite_samples"].get<std::uint64_t>());
}

}  // namespace

std::string geometrySummary(const GeometryStatistics& s) {
  return fmt::format("{} primitives, {} instances, {} clusters, {:.1f} MiB, built in {:.3f} s, traced by {}",
                     s.primitives(), s.instances, s.clusters, static_cast<double>(s.bytes) / (1024.0 * 1024.0),
                     s.buildSeconds, describe(s.accel));
}

void printStatistics(StatisticsFormat format, const std::string& sceneName, int threads, const Scene& scene,
                     const RenderResult& result, const Phases& phases) {
  if (format == StatisticsFormat::None) return;
  const json statistics = statisticsJson(sceneName, threads, scene, result, phases);
  if (format == StatisticsFormat::Json) {
    printOut(statistics.dump(1) + "\n");
  } else {
    printErr(asText(statistics));
  }
}

void reportStop(const RenderResult& result) {
  if (!result.stopped) return;
  const Crop& crop = result.film.crop();
  const double pixels = static_cast<double>(crop.x1 - crop.x0) * (crop.y1 - crop.y0);
  printErr(fmt::format("stopped after {:.1f} of {} samples per pixel\n",
                       static_cast<double>(result.statistics.samples) / pixels,
                       result.settings.samplesPerPixel.value_or(0)));
}

void warnAboutDroppedSamples(const std::string& sceneName, const RenderOptions& options, const RenderResult& result) {
  const auto dropped = result.film.dropped();
  if (dropped.empty()) return;
  const DroppedSample& first = dropped.front();
  const bool fixedCount = needsSampleCount(result.settings.sampler);
  const std::uint32_t count = fixedCount ? result.settings.samplesPerPixel.value_or(1) : first.sample + 1;
  printErr(
      fmt::format("warning: {} samples were not finite and were dropped; the first again:\n"
                  "  steradian render {} --size {}x{} --spp {} --crop {},{},{},{} {}\n",
                  result.film.droppedCount(), sceneName, result.film.settings().width, result.film.settings().height,
                  count, first.x, first.x + 1, first.y, first.y + 1, options.replay));
}

}  // namespace steradian::app
