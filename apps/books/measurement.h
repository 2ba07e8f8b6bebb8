#pragma once
/// The quality of a picture: its error against a reference of its scene, and its efficiency relative to the default
/// settings.
#include <map>
#include <optional>
#include <string>

#include "steradian/apps/books/rendering.h"
#include "steradian/apps/steradian/reference.h"

namespace steradian::books {

struct Measurement {
  double relMse = 0.0;         ///< against the reference, whose own noise is subtracted
  double defaultRelMse = 0.0;  ///< of the default settings in about the same time
  /// Efficiency, 1 / (relMSE x seconds), over that of the default settings; empty if either error is within that of the
  /// reference.
  std::optional<double> ratio;
  double bias = 0.0;       ///< mean luminance over that of the reference, less 1
  double biasError = 0.0;  ///< its standard error
};

/// Keeps a reference for each scene, size and crop: two pictures by the default settings.
class Measurer {
 public:
  explicit Measurer(const Effort& effort) : effort_(effort) {}

  /// relMSE against the reference of the scene that `rendering` should have shown; the reference's own noise is
  /// subtracted.
  double relMse(const Rendering& rendering, const std::string& sceneName);
  /// Renders what it compares with.
  Measurement measure(const Rendering& rendering, const std::string& sceneName);

 private:
  struct Known {
    std::unique_ptr<const Scene> scene;
    app::Reference reference;
    double samplesPerSecond;
    double mean, meanError;  ///< of the luminance
  };
  Known& knownOf(const std::string& sceneName, const RenderSettings& settings);

  Effort effort_;
  std::map<std::string, Known> known_;
};

/// The mean luminance of a picture with the channel StdErr.Y, and its standard error; pixels count as independent.
struct MeanLuminance {
  double mean, standardError;
};
MeanLuminance meanLuminance(const Image& image);

}  // namespace steradian::books
