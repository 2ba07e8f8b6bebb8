#pragma once
/// Image textures, prepared for lookup by (u, v).
#include "steradian/core/colour/colour_image.h"
#include "steradian/core/scene/description.h"

namespace STERADIAN_API steradian {

/// The centre of the pixel in column i is at u = (i + 1/2) / width; v = 0 is the lower edge of the picture. There are
/// no mip maps and no filter over the footprint of a ray: averaging the samples of a pixel does that.
class ImageTextureLookup {
 public:
  /// The texture must be valid (see validate()).
  explicit ImageTextureLookup(const ImageTexture& texture);

  /// The colour at (u, v), which may be any numbers; each channel is clamped to [0, 1] (see ImageTexture).
  Rgb value(Vec2f uv) const;

 private:
  ColourImage picture_;
  ImageTexture::Wrap wrapU_, wrapV_;
  ImageTexture::Filter filter_;
  float repeatU_, repeatV_;
};

}  // namespace steradian
