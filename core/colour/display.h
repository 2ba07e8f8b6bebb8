#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "steradian/core/image/image.h"

namespace STERADIAN_API steradian {

struct DisplaySettings {
  std::string display;    ///< empty: the configuration's default
  std::string view;       ///< empty: the default view of the display
  float exposure = 0.0f;  ///< in stops: radiance is multiplied by 2^exposure first
};

/// From scene-linear pixels (linear Rec.709, D65) to display values, through OpenColorIO.
///
/// The built-in configuration has the display "sRGB" with the views
///   "sRGB" (default)  the sRGB curve (within 1e-5) and nothing else; values beyond [0, 1] are cut in the file;
///   "ACES SDR"        the ACES 1.x output transform for SDR video, then the sRGB curve;
///   "Book"            square root, and quantisation as in "Ray Tracing in One Weekend" (see image_io.h);
///   "Raw"             the pixels as they are.
///
/// A configuration of the user's (programs take it from $OCIO; this library reads no environment variables of its
/// own) is connected to ours by its role `aces_interchange`.
///
/// A value: cheap to copy, and const functions may be called from several threads. No global state of OpenColorIO is
/// touched, so its log, which for damaged configurations goes to standard error, stays in the hands of the host
/// (OCIO::SetLoggingFunction).
class Display {
 public:
  /// The built-in configuration.
  Display();

  /// Reads an .ocio (or, where OpenColorIO supports them, .ocioz) file. Throws `Error` (kind Usage) if it cannot be
  /// read or is not valid, or if it has no role `aces_interchange`.
  explicit Display(const std::filesystem::path& config);

  /// The same from the text of a configuration; `name` is for messages.
  static Display fromText(const std::string& text, const std::string& name);

  std::vector<std::string> displays() const;
  /// Throws `Error` (kind Usage) if there is no such display. Empty: the default display.
  std::vector<std::string> views(const std::string& display = {}) const;
  std::string defaultDisplay() const;
  std::string defaultView(const std::string& display = {}) const;

  /// Throws the error that `apply` would throw for these names.
  void check(const DisplaySettings& settings) const;

  /// The image for display, in the channels R, G and B, with the image's window and metadata, "encoding" = "display"
  /// and, for "Book", "quantisation" = "book". The values are for a display file's full range [0, 1], and may lie
  /// outside. Throws `Error` (kind Usage) for an unknown display or view, with a suggestion, if the exposure is not
  /// finite, or if the image has no R, G and B; kind Other if OpenColorIO cannot build the transform (a missing LUT,
  /// say).
  Image apply(const Image& image, const DisplaySettings& settings = {}) const;

 private:
  struct Config;
  explicit Display(std::shared_ptr<const Config> config) : config_(std::move(config)) {}
  DisplaySettings resolve(const DisplaySettings& settings) const;

  std::shared_ptr<const Config> config_;
};

/// The sRGB curve (IEC 61966-2-1) from linear light to code value, both 0 to 1, and back. Odd in x, so that negative
/// values survive.
float srgbEncode(float linear);
float srgbDecode(float code);

/// Removes the sRGB curve from the channels R, G, B and Y of an image whose metadata says "encoding" = "srgb", as
/// `readImage` returns it, and makes that "linear". Other images stay as they are.
void linearise(Image& image);

}  // namespace steradian
