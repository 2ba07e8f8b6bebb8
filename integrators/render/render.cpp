#include "steradian/integrators/render/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace steradian {
namespace {

/// Passes stop growing here: longer ones would save nothing.
constexpr std::uint32_t kLongestPass = 64;

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The other side of the picture, with the aspect ratio of the scene's own.
int proportional(int side, int sceneSide, int sceneOther) {
  const double other = std::round(static_cast<double>(side) * sceneOther / sceneSide);
  return static_cast<int>(std::clamp(other, 1.0, static_cast<double>(Image::maxSide)));
}

RenderSettings completed(RenderSettings settings, const RenderDefaults& defaults) {
  if (!settings.width && !settings.height) {
    settings.width = defaults.width;
    settings.height = defaults.height;
  } else if (!settings.width) {
    settings.width = proportional(*settings.height, defaults.height, defaults.width);
  } else if (!settings.height) {
    settings.height = proportional(*settings.width, defaults.width, defaults.height);
  }
  const std::uint32_t room = std::numeric_limits<std::uint32_t>::max() - settings.firstSample;
  if (!settings.samplesPerPixel) settings.samplesPerPixel = settings.timeLimit ? room : defaults.samplesPerPixel;
  return settings;
}

/// `settings` is `given` with what the scene decides.
void check(const RenderSettings& given, const RenderSettings& settings) {
  Diagnostics wrong;
  check(given.execution, wrong);
  if (settings.samplesPerPixel == 0u) wrong.error({}, "samples per pixel must be at least 1");
  if (*settings.samplesPerPixel > std::numeric_limits<std::uint32_t>::max() - given.firstSample) {
    wrong.error({}, fmt::format("sample indices end at {}", std::numeric_limits<std::uint32_t>::max()));
  }
  if (given.timeLimit && !(*given.timeLimit > 0.0)) wrong.error({}, "the time limit must be above 0 s");
  if (given.tileSize < 1) wrong.error({}, "the tile size must be at least 1 pixel");
  if (needsSampleCount(given.sampler) && !given.samplesPerPixel && given.timeLimit) {
    wrong.error(
        {}, fmt::format("the {} sampler needs the number of samples besides the time limit", nameOf(given.sampler)));
  }
  if (needsSampleCount(given.sampler) && given.firstSample > 0) {
    wrong.error({}, fmt::format("the {} sampler cannot render a part of its samples", nameOf(given.sampler)));
  }
  wrong.throwIfErrors(ErrorKind::Usage);
}

/// How many samples per pixel the next pass takes; 0: time is over. Replicates stay balanced.
std::uint32_t nextPass(const RenderSettings& settings, std::uint32_t done, double seconds) {
  const std::uint32_t quantum = settings.replicates;
  const std::uint32_t left = *settings.samplesPerPixel - done;
  std::uint32_t count = std::min(std::max(done, quantum), std::max(kLongestPass, quantum) / quantum * quantum);
  if (settings.timeLimit && done > 0) {
    const double affordable = std::floor((*settings.timeLimit - seconds) / seconds * done);
    if (!(affordable >= quantum)) return 0;
    if (affordable < count) count = static_cast<std::uint32_t>(affordable) / quantum * quantum;
  }
  return std::min(count, left);
}

}  // namespace

RenderResult render(const Scene& scene, const Integrator& integrator, const RenderSettings& given,
                    const std::stop_token& stop, const ProgressCallback& progress) {
  const Clock::time_point start = Clock::now();
  const RenderSettings settings = completed(given, scene.description().defaults);
  check(given, settings);
  const std::uint32_t samplesPerPixel = *settings.samplesPerPixel;
  const FilmSettings filmSettings{
      .width = *settings.width, .height = *settings.height, .crop = settings.crop, .replicates = settings.replicates};
  RenderResult result{Film(filmSettings, settings.execution.isa), settings, {}, false};
  Film& film = result.film;
  RenderStatistics& statistics = result.statistics;
  const Camera camera(scene.description().camera, *settings.width, *settings.height);
  const std::unique_ptr<const PreparedIntegrator> prepared = integrator.prepare(scene, settings.execution);
  statistics.prepareSeconds = secondsSince(start);
  statistics.correlatedPixels = prepared->correlatedPixels();

  const Crop& crop = film.crop();
  const auto pixels = static_cast<std::uint64_t>(crop.x1 - crop.x0) * static_cast<std::uint64_t>(crop.y1 - crop.y0);
  const double total = static_cast<double>(pixels) * samplesPerPixel;
  std::uint32_t done = 0;
  double fraction = 0.0;
  RenderMonitor monitor(stop, [&](std::uint64_t samples) {
    if (!progress) return;
    const double seconds = secondsSince(start);
    const double ofTime = settings.timeLimit ? seconds / *settings.timeLimit : 0.0;
    fraction = std::min(1.0, std::max({fraction, static_cast<double>(samples) / total, ofTime}));
    progress({fraction, seconds, samples, done});
  });
  const RenderJob job{camera,
                      settings.filter,
                      {settings.sampler, settings.seed, samplesPerPixel, settings.replicates},
                      settings.tileSize,
                      monitor,
                      scene.geometry().dependsOnTime()};

  while (done < samplesPerPixel && !stop.stop_requested()) {
    const std::uint32_t count = nextPass(settings, done, secondsSince(start));
    if (count == 0) break;
    const PassRange pass{settings.firstSample + done, settings.firstSample + done + count};
    const std::uint64_t before = monitor.samples();
    prepared->renderPass(job, pass, film);
    const std::uint64_t added = monitor.samples() - before;
    const bool complete = added == pixels * count;
    if (added > 0) film.ledger().add({settings.seed, pass.first, pass.end, complete});
    if (!complete) break;
    done += count;
    ++statistics.passes;
  }
  result.stopped = stop.stop_requested() && done < samplesPerPixel;
  statistics.samples = monitor.samples();
  statistics.nonFiniteSamples = film.droppedCount();
  statistics.paths = monitor.counts();
  statistics.renderSeconds = secondsSince(start);
  statistics.sampleSeconds = statistics.renderSeconds - statistics.prepareSeconds;
  return result;
}

}  // namespace steradian
