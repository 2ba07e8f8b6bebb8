#pragma once
/// The flights of several paths at once: segments are traced with all lanes, and what they met is decided lane by lane
/// by the functions of flight.h, so that the bits are those of width 1.
#include <array>
#include <bit>

#include "steradian/integrators/flight.h"
#include "steradian/integrators/wide_scene.h"

namespace steradian {

template <class F>
class WideFlight {
 public:
  using Mask = MaskOf<F>;
  static constexpr int width = widthOf<F>;

  explicit WideFlight(const WideScene& scene) : scene_(scene), volumes_(scene.scene().volumes()) {}

  /// The scene has volumes: there is something to do at all.
  bool needed() const { return !volumes_.empty(); }
  /// A path begins in lane i.
  void start(int i, const Ray<float>& cameraRay) { bodies_[at(i)] = scene_.scene().bodiesAtStart(cameraRay); }

  /// As `fly` in path_loop.h, for the active lanes; throughput and radiance are brought up to date.
  [[gnu::noinline]] SurfacePoint<F> fly(Ray<F>& ray, Mask active, const Vec2<F>& random, Spectrum<F>& throughput,
                                        Spectrum<F>& radiance);
  // Of the last flight:
  Mask inMedium() const { return inMedium_; }  ///< lanes that a medium scatters
  const Flight& flight(int i) const { return flights_[at(i)]; }
  const Bodies& bodies(int i) const { return bodies_[at(i)]; }

  /// The lanes' paths leave these surfaces along wi, or are scattered in a medium.
  [[gnu::noinline]] void scatter(const SurfacePoint<F>& surface, const Vec3<F>& wo, const Vec3<F>& wi, Mask going);
  /// The share of light that arrives through shadow rays which leave where the last flights ended.
  [[gnu::noinline]] Spectrum<F> transmittance(const SurfacePoint<F>& surface, const Vec3<F>& wo, Ray<F> ray, Mask lit);

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  template <class Visit>
  static void forEachLane(Mask mask, const Visit& visit) {
    for (std::uint32_t bits = laneBits(mask); bits != 0; bits &= bits - 1) visit(std::countr_zero(bits));
  }

  const WideScene& scene_;
  const Volumes& volumes_;
  std::array<Bodies, static_cast<std::size_t>(width)> bodies_;  ///< that the rays are inside of
  std::array<Flight, static_cast<std::size_t>(width)> flights_;
  Mask inMedium_{false};
};

template <class F>
SurfacePoint<F> WideFlight<F>::fly(Ray<F>& ray, Mask active, const Vec2<F>& random, Spectrum<F>& throughput,
                                   Spectrum<F>& radiance) {
  inMedium_ = Mask(false);
  forEachLane(active, [&](int i) { flights_[at(i)] = Flight(lane(throughput, i), lane(random, i)); });
  SurfacePoint<F> arrivals;
  for (Mask left = active; any(left);) {
    const SurfacePoint<F> met = scene_.intersect(ray, left);
    forEachLane(left, [&](int i) {
      Flight& flight = flights_[at(i)];
      Ray<float> one = lane(ray, i);
      SurfacePoint<float> surface = lane(met, i);
      if (flight.advance(volumes_, surface, one, bodies_[at(i)])) {
        setLane(ray.tMin, i, one.tMin);
        return;
      }
      setLane(left, i, false);
      setLane(radiance, i, lane(radiance, i) + lane(throughput, i) * flight.emitted());
      setLane(throughput, i, lane(throughput, i) * flight.weight());
      setLane(inMedium_, i, flight.scatteredBy() != nullptr);
      surface.valid = surface.valid && flight.scatteredBy() == nullptr;
      setLane(arrivals, i, surface);
    });
  }
  return arrivals;
}

template <class F>
void WideFlight<F>::scatter(const SurfacePoint<F>& surface, const Vec3<F>& wo, const Vec3<F>& wi, Mask going) {
  forEachLane(going & surface.valid,
              [&](int i) { volumes_.scatter(lane(surface, i), lane(wo, i), lane(wi, i), bodies_[at(i)]); });
}

template <class F>
Spectrum<F> WideFlight<F>::transmittance(const SurfacePoint<F>& surface, const Vec3<F>& wo, Ray<F> ray, Mask lit) {
  Spectrum<F> result;
  if (!volumes_.passable()) lit = lit & !scene_.occluded(ray, lit);
  std::array<Bodies, static_cast<std::size_t>(width)> inside;
  std::array<LightWay, static_cast<std::size_t>(width)> ways;
  forEachLane(lit, [&](int i) {
    inside[at(i)] = bodies_[at(i)];
    if (lane(surface.valid, i)) {
      volumes_.scatter(lane(surface, i), lane(wo, i), lane(ray.direction, i), inside[at(i)]);
    }
  });
  while (any(lit)) {
    SurfacePoint<F> met;
    if (volumes_.passable()) met = scene_.intersect(ray, lit);
    forEachLane(lit, [&](int i) {
      Ray<float> one = lane(ray, i);
      if (ways[at(i)].advance(volumes_, lane(met, i), one, inside[at(i)])) {
        setLane(ray.tMin, i, one.tMin);
      } else {
        setLane(lit, i, false);
        setLane(result, i, ways[at(i)].transmittance());
      }
    });
  }
  return result;
}

}  // namespace steradian
