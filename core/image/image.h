#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "steradian/core/base/api.h"

namespace STERADIAN_API steradian {

/// A value that travels with an image. A vector of 16 floats is a 4x4 matrix in row-major order (row vectors, as in
/// Imath and OpenEXR), of 8 floats under the name "chromaticities" the xy of red, green, blue and white.
using MetadataValue = std::variant<std::string, int, float, double, std::vector<float>>;
/// Names of their own meaning: "encoding" ("linear", "srgb": the pixels carry the sRGB curve, "display": the pixels
/// are the result of a display transform) and "quantisation" ("book": see `Quantisation` in image_io.h).
using Metadata = std::map<std::string, MetadataValue, std::less<>>;

/// The value of that name if it exists and has type T, otherwise null.
template <class T>
const T* findMetadata(const Metadata& metadata, std::string_view name) {
  const auto found = metadata.find(name);
  return found == metadata.end() ? nullptr : std::get_if<T>(&found->second);
}

/// Where an image lies in the full picture: its pixel (0, 0) is pixel (x0, y0) of fullWidth x fullHeight pixels.
struct ImageWindow {
  int x0 = 0;
  int y0 = 0;
  int fullWidth = 0;
  int fullHeight = 0;
  bool operator==(const ImageWindow&) const = default;
};

/// A picture of float32 pixels with named channels. Pixels are interleaved (all channels of a pixel side by side,
/// rows from top to bottom, no padding): the order in which a film produces them and image files store them.
/// Channels are named as in OpenEXR: "R", "G", "B", "A", "Albedo.R", "N.X", "Z", "StdErr.Y", ...
class Image {
 public:
  static constexpr int maxSide = 1 << 20;

  /// All pixels are 0. The image lies in the full picture at `window`; by default it is the full picture.
  /// Throws `Error`: kind Usage if a side is not in [1, maxSide], if there is no channel, if a name is empty or
  /// occurs twice, or if the window is not inside the full picture in the sense that its size is not positive;
  /// kind Memory if there is not enough memory.
  Image(int width, int height, std::vector<std::string> channels, std::optional<ImageWindow> window = std::nullopt);

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }
  std::size_t pixelCount() const noexcept { return data_.size() / channels_.size(); }
  int channelCount() const noexcept { return static_cast<int>(channels_.size()); }
  const std::vector<std::string>& channels() const noexcept { return channels_; }
  const ImageWindow& window() const noexcept { return window_; }
  bool isCropped() const noexcept { return window_ != ImageWindow{0, 0, width_, height_}; }

  /// Not checked. x in [0, width), y in [0, height) count within this image, not within the full picture.
  float& at(int x, int y, int channel) { return data_[index(x, y) + static_cast<std::size_t>(channel)]; }
  float at(int x, int y, int channel) const { return data_[index(x, y) + static_cast<std::size_t>(channel)]; }

  /// The channels of one pixel.
  std::span<float> pixel(int x, int y) { return {data_.data() + index(x, y), channels_.size()}; }
  std::span<const float> pixel(int x, int y) const { return {data_.data() + index(x, y), channels_.size()}; }
  /// All pixels, width * height * channelCount floats.
  std::span<float> values() noexcept { return data_; }
  std::span<const float> values() const noexcept { return data_; }

  std::optional<int> findChannel(std::string_view name) const;
  /// As `findChannel`, but throws `Error` (kind Usage) with the names that exist.
  int channel(std::string_view name) const;
  /// The indices of "R", "G" and "B" if all three exist.
  std::optional<std::array<int, 3>> findRgb() const;

  Metadata& metadata() noexcept { return metadata_; }
  const Metadata& metadata() const noexcept { return metadata_; }

 private:
  std::size_t index(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) *
           channels_.size();
  }

  int width_;
  int height_;
  std::vector<std::string> channels_;
  ImageWindow window_;
  std::vector<float> data_;
  Metadata metadata_;
};

}  // namespace steradian
