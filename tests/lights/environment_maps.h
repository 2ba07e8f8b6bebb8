#pragma once
/// Pictures of skies.
#include <memory>

#include "steradian/core/samplers/rng.h"
#include "steradian/lights/skies.h"

namespace steradian::test {

/// Random colours, some pixels black.
inline std::shared_ptr<const Image> randomSky(int width, int height) {
  Image image(width, height, {"R", "G", "B"});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto w = randomWords<std::uint32_t>(static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 5u, 6u);
      if (w[3] % 4 == 0) continue;
      for (int c = 0; c < 3; ++c) image.at(x, y, c) = toUnitFloat<float>(w[static_cast<std::size_t>(c)]);
    }
  }
  return std::make_shared<const Image>(std::move(image));
}

/// Black but for one pixel.
inline std::shared_ptr<const Image> sunAt(int width, int height, int column, int row, float radiance = 1.0f) {
  Image image(width, height, {"Y"});
  image.at(column, row, 0) = radiance;
  return std::make_shared<const Image>(std::move(image));
}

/// The direction that the middle of a pixel shows, for a picture that is not turned.
inline Vec3f pixelDirection(const Image& image, int column, int row) {
  const float x = (static_cast<float>(column) + 0.5f) / static_cast<float>(image.width());
  const float y = (static_cast<float>(row) + 0.5f) / static_cast<float>(image.height());
  const SinCos<float> theta = sinCosTwoPi(0.5f * y), phi = sinCosTwoPi(x - 0.5f);
  return {theta.sin * phi.sin, theta.cos, -theta.sin * phi.cos};
}

}  // namespace steradian::test
