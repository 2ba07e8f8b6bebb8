#include "steradian/apps/bench/books_renderer.h"

#include <cmath>

#include "steradian/core/base/parallel.h"
#include "steradian/core/statistics/running_mean.h"

namespace steradian::bench::books {
namespace {

/// Nearer hits are ignored: they would be on the surface that the ray leaves.
constexpr double kNearest = 0.001;

class Lens {
 public:
  Lens(const PerspectiveCamera& camera, PictureSize size) : origin_(inDoubles(camera.lookFrom)) {
    const auto radians = [](float degrees) { return static_cast<double>(degrees) * 3.14159265358979323846 / 180.0; };
    const Vec back = unit(origin_ - inDoubles(camera.lookAt));
    const Vec right = unit(cross(inDoubles(camera.up), back)), up = cross(back, right);
    const auto focus = static_cast<double>(camera.focusDistance);
    const double pixel = 2.0 * std::tan(0.5 * radians(camera.verticalFov)) * focus / size.height;
    across_ = right * pixel;
    down_ = -up * pixel;
    corner_ = origin_ - back * focus - across_ * (0.5 * size.width) - down_ * (0.5 * size.height);
    const double radius = focus * std::tan(0.5 * radians(camera.defocusAngle));
    hasLens_ = camera.defocusAngle > 0.0f;
    lensRight_ = right * radius;
    lensUp_ = up * radius;
  }

  Ray ray(int x, int y, Random& random) const {
    const double u = x + random.next(), v = y + random.next();
    const Vec seen = corner_ + across_ * u + down_ * v;
    Vec from = origin_;
    if (hasLens_) {
      const Vec onLens = random.inDisk();
      from += lensRight_ * onLens.x + lensUp_ * onLens.y;
    }
    return {from, seen - from, random.next()};
  }

 private:
  Vec origin_, corner_, across_, down_, lensRight_, lensUp_;
  bool hasLens_ = false;
};

Colour radiance(const World& world, const Ray& ray, int raysLeft, Random& random) {
  if (raysLeft <= 0) return {};
  Hit hit;
  if (!world.root->hit(ray, {kNearest, kFar}, hit, random)) return world.background.value(ray.direction);
  const Colour emitted = hit.material->emitted(hit);
  Scattered scattered;
  if (!hit.material->scatter(ray, hit, scattered, random)) return emitted;
  return emitted + scattered.attenuation * radiance(world, scattered.ray, raysLeft - 1, random);
}

double luminance(Colour c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

}  // namespace

Image render(const World& world, PictureSize size, std::uint32_t samplesPerPixel, std::uint32_t seed) {
  Image image(size.width, size.height, {"R", "G", "B", "StdErr.Y"});
  const Lens lens(world.camera, size);
  const auto n = static_cast<double>(samplesPerPixel);
  const auto renderRow = [&](int y) {
    Random random(seed, static_cast<std::uint32_t>(y));
    for (int x = 0; x < size.width; ++x) {
      Colour sum;
      RunningMean luminances;
      for (std::uint32_t i = 0; i < samplesPerPixel; ++i) {
        const Colour sample = radiance(world, lens.ray(x, y, random), world.maxDepth, random);
        sum += sample;
        luminances.add(luminance(sample));
      }
      const Colour mean = sum / n;
      const auto pixel = image.pixel(x, y);
      pixel[0] = static_cast<float>(mean.r);
      pixel[1] = static_cast<float>(mean.g);
      pixel[2] = static_cast<float>(mean.b);
      pixel[3] = static_cast<float>(luminances.standardError());
    }
  };
  parallelForEach(static_cast<std::size_t>(size.height), [&](std::size_t y) { renderRow(static_cast<int>(y)); });
  return image;
}

}  // namespace steradian::bench::books
