#pragma once
/// A table that compares renders of one scene.
#include <functional>
#include <string>
#include <vector>

#include "steradian/apps/books/measurement.h"

namespace steradian::books {

struct Trial {
  std::string label;                                ///< HTML
  std::vector<std::string> command;                 ///< "render" and so on; always a scene second
  std::function<void(SceneDescription&)> change{};  ///< of the scene, where no command can say it
  std::string picture{};                            ///< the name of its file, if it is to be kept
};

struct TrialResult {
  double seconds = 0.0, samplesPerSecond = 0.0;
  double raysPerSample = 0.0;  ///< of all kinds
  std::uint32_t samplesPerPixel = 0;
  std::uint64_t samples = 0, nonFinite = 0;
  double relMse = 0.0;  ///< against the reference of the unchanged scene
  double mean = 0.0;    ///< luminance

  /// Efficiency relative to another's: the inverse ratio of relMSE x seconds.
  double efficiencyOver(const TrialResult& other) const { return other.relMse * other.seconds / (relMse * seconds); }
};

/// Renders a trial, and keeps its picture in `folder` if it is to be kept.
TrialResult run(const Trial& trial, Measurer& measurer, const Effort& effort, const std::filesystem::path& folder);
/// The same in about `seconds`: the number of samples is estimated by a first short render.
TrialResult runFor(double seconds, const Trial& trial, Measurer& measurer, const Effort& effort,
                   const std::filesystem::path& folder);

/// The commands as the page shows them; those of changed scenes are left out.
std::string commandsOf(const std::vector<Trial>& trials);

}  // namespace steradian::books
