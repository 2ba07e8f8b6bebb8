#include "steradian/apps/montecarlo/direction_picture.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "steradian/apps/montecarlo/svg.h"
#include "steradian/core/samplers/sampler.h"
#include "steradian/core/sampling/warp.h"

namespace steradian::montecarlo {

namespace {

constexpr double kSize = 320.0, kRadius = 140.0;

/// Seen from 25 degrees above the equator, without perspective.
struct Seen {
  double x, y, depth;  ///< to the right, up, towards the eye
};
Seen seen(double x, double y, double z) {
  constexpr double angle = 25.0 / 180.0 * std::numbers::pi;
  return {x, z * std::cos(angle) - y * std::sin(angle), z * std::sin(angle) + y * std::cos(angle)};
}

struct Globe {
  double x, y;  ///< its centre

  double across(const Seen& p) const { return x + kRadius * p.x; }
  double down(const Seen& p) const { return y - kRadius * p.y; }
};

/// A circle of latitude, its near half solid.
void drawLatitude(Svg& svg, const Globe& globe, double z) {
  constexpr int steps = 120;
  std::string nearer, farther;
  const double radius = std::sqrt(1.0 - z * z);
  const auto at = [&](int i) {
    const double phi = 2.0 * std::numbers::pi * i / steps;
    return seen(radius * std::cos(phi), radius * std::sin(phi), z);
  };
  for (int i = 0; i < steps; ++i) {
    const Seen a = at(i), b = at(i + 1);
    (a.depth + b.depth > 0.0 ? nearer : farther) +=
        fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", globe.across(a), globe.down(a), globe.across(b), globe.down(b));
  }
  if (!farther.empty()) svg.path(farther, "fill=\"none\" stroke=\"#e6e6e6\"");
  if (!nearer.empty()) svg.path(nearer, "fill=\"none\" stroke=\"#bbbbbb\"");
}

void drawGlobe(Svg& svg, const Globe& globe, SamplerType type, std::uint32_t count, std::uint32_t seed) {
  for (const double z : {-0.5, 0.0, 0.5}) drawLatitude(svg, globe, z);
  svg.circle(globe.x, globe.y, kRadius, "fill=\"none\" stroke=\"#888888\"");
  for (const bool nearer : {false, true}) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const Sampler<float> point({type, seed, count}, 0u, i);
      const Vec3f w = UniformSphere<float>::sample(point.get2D(0u));
      const Seen p = seen(w.x, w.y, w.z);
      if ((p.depth > 0.0) != nearer) continue;
      svg.circle(globe.across(p), globe.down(p), nearer ? 3.0 : 2.2, nearer ? "fill=\"#0072b2\"" : "fill=\"#a8cbe2\"");
    }
  }
  svg.text(globe.x, globe.y + kRadius + 26.0, 14.0, "middle", nameOf(type));
}

}  // namespace

std::string directionsSvg(std::uint32_t count, std::uint32_t seed) {
  Svg svg(3.0 * kSize, kSize + 60.0);
  svg.text(1.5 * kSize, 24.0, 15.0, "middle", fmt::format("{} uniform directions", count), "font-weight=\"bold\"");
  double x = 0.5 * kSize;
  for (const SamplerType type : {SamplerType::Independent, SamplerType::Stratified, SamplerType::Sobol}) {
    drawGlobe(svg, {x, 0.5 * kSize + 30.0}, type, count, seed);
    x += kSize;
  }
  return svg.finish();
}

}  // namespace steradian::montecarlo
