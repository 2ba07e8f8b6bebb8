#include "steradian/materials/perlin_noise.h"

#include "steradian/core/sampling/warp.h"

namespace steradian {

PerlinNoise::PerlinNoise(std::uint32_t seed) {
  auto vectors = std::make_shared<std::vector<float>>(std::size_t{4} * kVectors);
  for (std::uint32_t i = 0; i < kVectors; ++i) {
    const auto words = randomWords<std::uint32_t>(i, 0, 0, seed);
    const Vec3f v = UniformSphere<float>::sample({toUnitFloat<float>(words[0]), toUnitFloat<float>(words[1])});
    float* to = vectors->data() + std::size_t{4} * i;
    to[0] = v.x, to[1] = v.y, to[2] = v.z;
  }
  vectors_ = std::move(vectors);
  const auto keys = randomWords<std::uint32_t>(kVectors, 0, 0, seed);
  keyX_ = keys[0], keyY_ = keys[1], keyZ_ = keys[2];
}

NoisePattern::NoisePattern(const NoiseTexture& texture)
    : noise_(texture.seed),
      pattern_(texture.pattern),
      colour_(texture.colour),
      scale_(texture.scale),
      octaves_(texture.octaves) {}

}  // namespace steradian
