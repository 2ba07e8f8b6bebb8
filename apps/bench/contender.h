#pragma once
/// Renderers that take part in a comparison.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "steradian/apps/bench/measure.h"
#include "steradian/apps/bench/options.h"
#include "steradian/core/image/image.h"
#include "steradian/integrators/path/path.h"

namespace steradian::bench {

/// A picture, and the seconds that sampling it took: without reading, building and writing.
struct TimedPicture {
  Image image;
  double seconds;
};

/// One renderer, set up for one scene.
class Contender {
 public:
  virtual ~Contender() = default;
  /// Equal arguments give equal pictures, other seeds independent ones. Throws Error if the renderer fails.
  virtual TimedPicture render(std::uint32_t samplesPerPixel, std::uint32_t seed) = 0;
};

/// Ours: the path integrator with its defaults, except that `reuse` pixels share paths.
class Steradian final : public Contender {
 public:
  Steradian(const SceneDescription& scene, const BenchOptions& options, std::uint32_t reuse);
  TimedPicture render(std::uint32_t samplesPerPixel, std::uint32_t seed) override;

 private:
  int width_, height_;
  PathIntegrator integrator_;
  ExecutionSettings execution_;
  Threads threads_;
  std::unique_ptr<const Scene> scene_;
};

/// Blender's Cycles, by cycles_scene.py, in a process of its own.
class Cycles final : public Contender {
 public:
  /// `folder` is for the scene and the pictures. Throws Error (Usage) if the script is not there.
  Cycles(const SceneDescription& scene, const BenchOptions& options, std::filesystem::path folder);
  TimedPicture render(std::uint32_t samplesPerPixel, std::uint32_t seed) override;

  /// Whether Blender is installed.
  static bool available();

 private:
  std::filesystem::path folder_;
  std::string script_;
  int width_, height_, threads_;
};

}  // namespace steradian::bench
