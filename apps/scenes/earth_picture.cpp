#include "steradian/apps/scenes/earth_picture.h"

#include "steradian/materials/perlin_noise.h"

namespace steradian::scenes {
namespace {

constexpr std::uint32_t kSeed = 0x65617274u;

using F = Lanes<4>;

Spectrum<F> blend(const Spectrum<F>& from, Rgb to, F share) {
  return from * (F(1.0f) - share) + broadcast<F>(to) * share;
}
/// 0 below `low`, 1 above `high`, smooth in between.
F step(F x, float low, float high) {
  const F t = clamp((x - F(low)) * F(1.0f / (high - low)), 0.0f, 1.0f);
  return t * t * (F(3.0f) - F(2.0f) * t);
}

/// The sum of noises, each of twice the frequency and `gain` times the size.
F layers(const PerlinNoise& noise, Vec3<F> p, float frequency, float gain, int count) {
  F sum(0.0f);
  float size = 1.0f;
  for (int i = 0; i < count; ++i) {
    sum = sum + F(size) * noise.noise(p * F(frequency));
    frequency *= 2.0f;
    size *= gain;
  }
  return sum;
}

Spectrum<F> colourAt(const PerlinNoise& terrain, const PerlinNoise& climate, Vec3<F> p) {
  const F height = layers(terrain, p, 1.4f, 0.55f, 8) - F(0.08f);
  const F weather = layers(climate, p, 3.0f, 0.5f, 4);
  const F latitude = absolute(p.y);  // its sine

  const Spectrum<F> sea =
      blend(broadcast<F>(Rgb{0.005f, 0.022f, 0.075f}), {0.012f, 0.09f, 0.15f}, step(height, -0.3f, 0.0f));
  Spectrum<F> land = broadcast<F>(Rgb{0.045f, 0.11f, 0.02f});               // forest
  land = blend(land, {0.19f, 0.17f, 0.055f}, step(weather, -0.05f, 0.3f));  // steppe
  const F belt = F(1.0f) - absolute(latitude - F(0.4f)) * F(5.0f);          // of deserts
  land = blend(land, {0.46f, 0.32f, 0.16f}, step(belt + weather, 0.3f, 0.7f));
  land = blend(land, {0.16f, 0.13f, 0.09f}, step(latitude + F(0.3f) * weather, 0.75f, 0.9f));  // tundra
  land = blend(land, {0.14f, 0.11f, 0.085f}, step(height, 0.35f, 0.5f));                       // rock
  land = blend(land, {0.8f, 0.82f, 0.85f}, step(height + F(0.3f) * latitude, 0.62f, 0.7f));    // snow on it

  const Spectrum<F> ground = select(height > F(0.0f), land, sea);
  return blend(ground, {0.82f, 0.86f, 0.9f}, step(latitude + F(0.12f) * weather + F(0.06f) * height, 0.92f, 0.94f));
}

}  // namespace

Image earthPicture(int width, int height) {
  Image image(width, height, {"R", "G", "B"});
  image.metadata().emplace("encoding", std::string("linear"));
  const PerlinNoise terrain(kSeed), climate(kSeed + 1);
  F steps;
  for (int i = 0; i < widthOf<F>; ++i) setLane(steps, i, static_cast<float>(i) + 0.5f);
  for (int y = 0; y < height; ++y) {
    const float v = 1.0f - (static_cast<float>(y) + 0.5f) / static_cast<float>(height);
    const SinCos<float> theta = sinCosTwoPi(0.5f * v);
    for (int x = 0; x < width; x += widthOf<F>) {
      const SinCos<F> phi = sinCosTwoPi((F(static_cast<float>(x)) + steps) * F(1.0f / static_cast<float>(width)));
      const Vec3<F> p{-phi.cos * F(theta.sin), F(-theta.cos), phi.sin * F(theta.sin)};
      const Spectrum<F> colour = colourAt(terrain, climate, p);
      for (int i = 0; i < widthOf<F>; ++i) {
        const Rgb c = lane(colour, i);
        image.at(x + i, y, 0) = c.r, image.at(x + i, y, 1) = c.g, image.at(x + i, y, 2) = c.b;
      }
    }
  }
  return image;
}

}  // namespace steradian::scenes
