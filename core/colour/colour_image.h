#pragma once
/// Images as colours to look up: what textures and skies are made of.
#include <filesystem>
#include <memory>

#include "steradian/core/image/image.h"
#include "steradian/core/transport/spectrum.h"

namespace STERADIAN_API steradian {

/// The colours of an image: R, G and B, or its only channel for all three. It refers to the image's pixels, so any
/// number of pictures may share them.
class ColourImage {
 public:
  /// Throws Error (Usage) for an image without such channels (or none at all), or of more than 2^31 - 1 values, which
  /// no index of a lane reaches.
  explicit ColourImage(std::shared_ptr<const Image> image);

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }

  /// The pixel in a column, counted from the left, and a row, from the top. Not checked.
  template <class F>
  Spectrum<F> texel(UintOf<F> column, UintOf<F> row) const {
    const UintOf<F> index = (row * UintOf<F>(width_) + column) * UintOf<F>(stride_);
    return {gather(red_, index), gather(green_, index), gather(blue_, index)};
  }

  /// Two neighbouring columns (or rows), and how far between their centres a place lies: 0 at the first.
  template <class F>
  struct Neighbours {
    UintOf<F> first, second;
    F between;
  };
  /// Interpolates between four pixels.
  template <class F>
  Spectrum<F> blend(const Neighbours<F>& column, const Neighbours<F>& row) const {
    const auto along = [&](UintOf<F> y) {
      return texel<F>(column.first, y) * (F(1.0f) - column.between) + texel<F>(column.second, y) * column.between;
    };
    return along(row.first) * (F(1.0f) - row.between) + along(row.second) * row.between;
  }

 private:
  std::shared_ptr<const Image> image_;
  std::uint32_t width_, height_, stride_;
  const float *red_, *green_, *blue_;  ///< of the first pixel
};

/// Reads a picture for textures and skies: linear colours in the channels R, G and B or, if it is grey, in one; alpha
/// and other channels are left out. Formats and errors are those of readImage; besides, Error (Scene), with the path,
/// for an image without colours, for a part of a larger picture, and for a colour that is not finite.
std::shared_ptr<const Image> readColourImage(const std::filesystem::path& path);

}  // namespace steradian
