#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <memory>
#include <new>

#include "steradian/apps/steradian/commands.h"
#include "steradian/apps/steradian/console.h"
#include "steradian/apps/steradian/exit_codes.h"
#include "steradian/apps/steradian/interrupt.h"
#include "steradian/apps/steradian/memory_check.h"
#include "steradian/apps/steradian/progress.h"
#include "steradian/apps/steradian/render_options.h"
#include "steradian/apps/steradian/render_report.h"
#include "steradian/core/base/atomic_file.h"
#include "steradian/core/colour/display.h"
#include "steradian/integrators/make_integrator.h"
#include "steradian/integrators/render/render.h"
#include "steradian/integrators/render/rendered_image.h"
#include "steradian/integrators/scene/scene.h"

namespace steradian::app {

namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The part of the picture that is rendered.
Crop cropOf(const RenderSettings& settings, const RenderDefaults& defaults) {
  return settings.crop.value_or(
      Crop{0, settings.width.value_or(defaults.width), 0, settings.height.value_or(defaults.height)});
}

/// Checks that should not fail only after hours of rendering.
void checkResources(const RenderOptions& options) {
  Diagnostics problems;
  for (const Output& output : options.outputs) {
    try {
      checkWritable(output.path);
    } catch (const Error& error) {
      for (const Diagnostic& d : error.diagnostics()) problems.add(d);
    }
  }
  problems.throwIfErrors(ErrorKind::Output);
  const Crop crop = cropOf(options.settings, options.scene.defaults);
  checkMemory(options.scene, availableMemory());
  checkMemory(crop.x1 - crop.x0, crop.y1 - crop.y0, options.settings.replicates, availableMemory());
}

void writeOutputs(const RenderOptions& options, const Image& image) {
  std::optional<Image> shown;
  Diagnostics failures;
  for (const Output& output : options.outputs) {
    const bool displayed = isDisplayReferred(output.format);
    try {  // the other files may still be saved
      if (displayed && !shown) shown = options.display->apply(image, options.view);
      writeImage(displayed ? *shown : image, output.path, {.format = output.format});
    } catch (const Error& error) {
      for (const Diagnostic& d : error.diagnostics()) failures.add(d);
    } catch (const std::bad_alloc&) {
      failures.error({}, fmt::format("cannot write \"{}\": out of memory", output.path.string()));
    }
  }
  failures.throwIfErrors(ErrorKind::Output);
}

RenderResult renderWithProgress(const Scene& scene, const Integrator& integrator, const RenderOptions& options,
                                const Interrupt& interrupt) {
  ProgressDisplay bar(ProgressDisplay::styleFor(options.quiet));
  const Crop crop = cropOf(options.settings, scene.description().defaults);
  const double pixels = static_cast<double>(crop.x1 - crop.x0) * (crop.y1 - crop.y0);
  return render(scene, integrator, options.settings, interrupt.token(), [&](const RenderProgress& progress) {
    const auto samples = static_cast<double>(progress.samples);
    const double rate = progress.seconds > 0.0 ? samples / progress.seconds / 1e6 : 0.0;
    bar.update(progress.fraction, progress.seconds,
               fmt::format("{:.1f} spp, {:.2f} Msamples/s", samples / pixels, rate));
  });
}

int runRender(const RenderTexts& texts, Arguments& arguments) {
  RenderOptions options = checkRenderOptions(texts, arguments);
  checkResources(options);
  const ExecutionSettings& execution = options.settings.execution;
  const std::unique_ptr<const Integrator> integrator = makeIntegrator(options.integrator, execution).integrator;

  Interrupt interrupt;  // before TBB starts threads
  const int threads = options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);

  const std::string name = options.scene.name;
  const auto buildStart = std::chrono::steady_clock::now();
  std::unique_ptr<const Scene> scene;
  arena.execute([&] {
    scene = std::make_unique<Scene>(
        std::move(options.scene),
        SceneSettings{.geometry = {.accel = {.accel = options.accel}, .isa = execution.isa}, .lights = {}});
  });
  Phases phases{.buildSeconds = secondsSince(buildStart)};
  if (options.verbose) printErr(fmt::format("{}: {}\n", name, geometrySummary(scene->geometry().statistics())));

  std::optional<RenderResult> result;
  arena.execute([&] { result = renderWithProgress(*scene, *integrator, options, interrupt); });

  const auto writeStart = std::chrono::steady_clock::now();
  if (!options.outputs.empty()) writeOutputs(options, renderedImage(*result, *scene));
  phases.writeSeconds = secondsSince(writeStart);

  warnAboutDroppedSamples(name, options, *result);
  if (!options.quiet) reportStop(*result);
  if (!options.quiet && options.outputs.empty()) printErr("nothing was saved: give -o FILE\n");
  printStatistics(options.statistics, name, threads, *scene, *result, phases);
  return result->stopped ? kExitStopped : kExitSuccess;
}

}  // namespace

void addRenderCommand(CLI::App& app, Run& run) {
  CLI::App* command = app.add_subcommand("render", "Render a scene to image files");
  auto texts = std::make_shared<RenderTexts>();
  declareRenderOptions(*command, *texts);
  command->callback([&run, texts] { run = [texts](Arguments& arguments) { return runRender(*texts, arguments); }; });
}

}  // namespace steradian::app
