#pragma once
/// Records the rays of a render, to measure how fast they can be traced without anything else.
#include <vector>

#include "steradian/integrators/path/path_settings.h"
#include "steradian/integrators/render/render_settings.h"
#include "steradian/integrators/scene/scene.h"

namespace STERADIAN_API steradian {

enum class RayKind : std::uint8_t { Camera, Bounce, Shadow };

struct RecordedRay {
  Ray<float> ray;
  RayKind kind;  ///< Shadow: an any-hit query; the others: nearest hit
};

/// All rays of the path integrator, in the order in which one thread traces them: about 300 bytes per sample, so choose
/// size and samples with care. Throws as render() does.
std::vector<RecordedRay> recordRays(const Scene& scene, const PathSettings& path, const RenderSettings& settings);

}  // namespace steradian
