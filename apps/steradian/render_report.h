#pragma once
/// What `steradian render` reports when it is done.
#include <string>

#include "steradian/apps/steradian/render_options.h"
#include "steradian/integrators/render/render.h"
#include "steradian/integrators/scene/scene.h"

namespace steradian::app {

/// Seconds of the phases around the render itself.
struct Phases {
  double buildSeconds = 0.0;
  double writeSeconds = 0.0;
};

/// "8 primitives, 0 instances, 2 clusters, 0.0 MiB, built in 0.001 s"
std::string geometrySummary(const GeometryStatistics& statistics);

/// To standard error as text, or to standard output as JSON.
void printStatistics(StatisticsFormat format, const std::string& sceneName, int threads, const Scene& scene,
                     const RenderResult& result, const Phases& phases);

/// "stopped after 12 of 64 samples per pixel"; nothing if it was not stopped.
void reportStop(const RenderResult& result);

/// Non-finite samples are dropped, never silently: reports how many, and a command that renders the first again.
void warnAboutDroppedSamples(const std::string& sceneName, const RenderOptions& options, const RenderResult& result);

}  // namespace steradian::app
