#include "steradian/apps/bench/books_materials.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace steradian::bench::books {
namespace {

Vec reflected(Vec direction, Vec normal) { return direction - normal * (2.0 * dot(direction, normal)); }

/// `ratio`: index of the side that the ray comes from over that of the other.
double schlickReflectance(double cosine, double ratio) {
  const double r = (1.0 - ratio) / (1.0 + ratio), atNormal = r * r;
  return atNormal + (1.0 - atNormal) * std::pow(1.0 - cosine, 5.0);
}

double fresnelReflectance(double cosine, double refractedCosine, double ratio) {
  const double s = (ratio * cosine - refractedCosine) / (ratio * cosine + refractedCosine);
  const double p = (cosine - ratio * refractedCosine) / (cosine + ratio * refractedCosine);
  return 0.5 * (s * s + p * p);
}

}  // namespace

// --- Textures ---------------------------------------------------------------------------------------------------

Colour Checker::value(const Hit& hit) const {
  double cells = std::floor(frequency_ * hit.u) + std::floor(frequency_ * hit.v);
  if (inSpace_) {
    cells = std::floor(frequency_ * hit.position.x) + std::floor(frequency_ * hit.position.y) +
            std::floor(frequency_ * hit.position.z);
  }
  const bool isEven = static_cast<long>(cells) % 2 == 0;
  return (isEven ? even_ : odd_)->value(hit);
}

Colour Picture::value(const Hit& hit) const {
  const Image& image = *texture_.image;
  const double u = hit.u * static_cast<double>(texture_.repeatU), v = hit.v * static_cast<double>(texture_.repeatV);
  const auto pixel = [](double place, int count) {
    return std::min(static_cast<int>((place - std::floor(place)) * count), count - 1);
  };
  const int x = pixel(u, image.width()), y = image.height() - 1 - pixel(v, image.height());
  const auto rgb = image.findRgb();
  if (!rgb) return inDoubles(grey(image.at(x, y, 0)));
  return inDoubles(Rgb{image.at(x, y, (*rgb)[0]), image.at(x, y, (*rgb)[1]), image.at(x, y, (*rgb)[2])});
}

Noise::Noise(const NoiseTexture& texture) : texture_(texture) {
  Random random(texture.seed, 0x6e6f6973u);
  for (Vec& v : vectors_) v = random.onSphere();
  for (auto& permutation : permutations_) {
    std::iota(permutation.begin(), permutation.end(), 0);
    for (int i = kVectors - 1; i > 0; --i) {
      const int other = static_cast<int>(random.next() * (i + 1));
      std::swap(permutation[static_cast<std::size_t>(i)], permutation[static_cast<std::size_t>(other)]);
    }
  }
}

double Noise::noise(Vec p) const {
  const double floors[3] = {std::floor(p.x), std::floor(p.y), std::floor(p.z)};
  const double place[3] = {p.x - floors[0], p.y - floors[1], p.z - floors[2]};
  double sum = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    int index = 0;
    double weight = 1.0;
    double offset[3];
    for (unsigned axis = 0; axis < 3; ++axis) {
      const int step = (corner >> axis & 1u) != 0 ? 1 : 0;
      const double t = place[axis], blend = t * t * (3.0 - 2.0 * t);
      const auto cell = static_cast<unsigned>(static_cast<int>(floors[axis]) + step) & (kVectors - 1u);
      index ^= permutations_[axis][cell];
      weight *= step == 1 ? blend : 1.0 - blend;
      offset[axis] = t - step;
    }
    sum += weight * dot(vectors_[static_cast<std::size_t>(index)], Vec{offset[0], offset[1], offset[2]});
  }
  return sum;
}

double Noise::turbulence(Vec p) const {
  double sum = 0.0, weight = 1.0;
  for (int i = 0; i < texture_.octaves; ++i) {
    sum += weight * noise(p);
    weight *= 0.5;
    p = p * 2.0;
  }
  return std::fabs(sum);
}

Colour Noise::value(const Hit& hit) const {
  const Vec p = hit.position;
  const auto scale = static_cast<double>(texture_.scale);
  double share = 0.0;
  switch (texture_.pattern) {
    case NoiseTexture::Pattern::Noise:
      share = 0.5 * (1.0 + noise(p * scale));
      break;
    case NoiseTexture::Pattern::Turbulence:
      share = std::min(turbulence(p * scale), 1.0);
      break;
    case NoiseTexture::Pattern::Marble:
      share = 0.5 * (1.0 + std::sin(scale * p.z + 10.0 * turbulence(p)));
      break;
  }
  return inDoubles(texture_.colour) * share;
}

// --- Materials --------------------------------------------------------------------------------------------------

bool Lambertian::scatter(const Ray& ray, const Hit& hit, Scattered& scattered, Random& random) const {
  Vec direction = hit.normal + random.onSphere();
  if (lengthSquared(direction) < 1e-16) direction = hit.normal;
  scattered = {reflectance_->value(hit), {hit.position, direction, ray.time}};
  return true;
}

bool Hemispherical::scatter(const Ray& ray, const Hit& hit, Scattered& scattered, Random& random) const {
  const Vec direction = random.onSphere();
  const bool above = dot(direction, hit.normal) > 0.0;
  scattered = {reflectance_->value(hit), {hit.position, above ? direction : -direction, ray.time}};
  return true;
}

bool Metal::scatter(const Ray& ray, const Hit& hit, Scattered& scattered, Random& random) const {
  const Vec direction = unit(reflected(ray.direction, hit.normal)) + random.onSphere() * fuzz_;
  scattered = {reflectance_->value(hit), {hit.position, direction, ray.time}};
  return dot(direction, hit.normal) > 0.0;
}

bool Glass::scatter(const Ray& ray, const Hit& hit, Scattered& scattered, Random& random) const {
  const double ratio = hit.front ? 1.0 / eta_ : eta_;
  const Vec direction = unit(ray.direction);
  const double cosine = std::min(-dot(direction, hit.normal), 1.0);
  const double sineSquared = ratio * ratio * (1.0 - cosine * cosine);  // behind the surface
  double reflectance = 1.0, refractedCosine = 0.0;
  if (sineSquared < 1.0) {
    refractedCosine = std::sqrt(1.0 - sineSquared);
    reflectance = schlick_ ? schlickReflectance(cosine, ratio) : fresnelReflectance(cosine, refractedCosine, ratio);
  }
  const Vec through = (direction + hit.normal * cosine) * ratio - hit.normal * refractedCosine;
  const bool reflects = random.next() < reflectance;
  scattered = {{1.0, 1.0, 1.0}, {hit.position, reflects ? reflected(direction, hit.normal) : through, ray.time}};
  return true;
}

bool Isotropic::scatter(const Ray& ray, const Hit& hit, Scattered& scattered, Random& random) const {
  scattered = {albedo_, {hit.position, random.onSphere(), ray.time}};
  return true;
}

}  // namespace steradian::bench::books
