#pragma once
/// The render loop: from a scene to a film.
#include <stop_token>

#include "steradian/core/film/film.h"
#include "steradian/integrators/render/integrator.h"
#include "steradian/integrators/render/render_job.h"
#include "steradian/integrators/render/render_settings.h"
#include "steradian/integrators/render/render_statistics.h"
#include "steradian/integrators/scene/scene.h"

namespace STERADIAN_API steradian {

struct RenderResult {
  Film film;
  RenderSettings settings;  ///< with what the scene decided filled in: size, and the samples asked for
  RenderStatistics statistics;
  bool stopped = false;  ///< the stop token ended it
};

/// Renders in the caller's tbb::task_arena, without threads of its own. The film is the same to the bit for any number
/// of threads, tile size and crop, and for a picture put together from several ranges of samples (Film::merge).
///
/// Samples are added in passes over the whole crop that grow from one sample per pixel. When `stop` asks to stop, tiles
/// that are being rendered are finished, so that a pixel has all samples of a pass or none, and the film's ledger marks
/// the pass as incomplete. Several renders may run at once, of one scene and with one integrator too.
///
/// Throws Error: Usage for settings that make no sense (sizes, crop, counts, an integrator's unknown target; execution
/// settings that this machine cannot run; the stratified sampler under a time limit without a sample count); Memory.
/// What `progress` throws ends the render.
RenderResult render(const Scene& scene, const Integrator& integrator, const RenderSettings& settings = {},
                    const std::stop_token& stop = {}, const ProgressCallback& progress = {});

}  // namespace steradian
