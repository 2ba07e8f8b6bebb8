#pragma once
/// Free flight of several paths at once. Segments are traced, and media computed, with all lanes at once. Surfaces that
/// may not be real to a ray, and the closed shapes that rays are inside of, are dealt with lane by lane: few segments
/// end at such surfaces.
#include <array>
#include <bit>

#include "steradian/integrators/path/wide_scene.h"
#include "steradian/integrators/volumes/crossings.h"
#include "steradian/integrators/volumes/free_flight.h"

namespace STERADIAN_API steradian {

/// Calls visit(i) for the lanes of the mask, in order.
template <class Mask, class Visit>
void forEachLane(Mask mask, const Visit& visit) {
  for (std::uint32_t bits = laneBits(mask); bits != 0; bits &= bits - 1) visit(std::countr_zero(bits));
}

template <class F>
class WideFreeFlight {
 public:
  using Mask = MaskOf<F>;
  static constexpr int width = widthOf<F>;

  WideFreeFlight(const WideScene& scene, PathCounts& counts)
      : scene_(scene), volumes_(scene.scene().volumes()), counts_(counts) {}

  /// Whether the scene has volumes. If not, rays go straight from surface to surface.
  bool needed() const { return !volumes_.empty(); }
  /// Lane i begins a path at the camera.
  void start(int i, const Ray<float>& cameraRay) {
    interior_[at(i)] = scene_.scene().interiorAtStart(cameraRay);
    setLane(inside_, i, volumes_.mediumIn(interior_[at(i)]));
  }

  /// As traceThroughMedia() in path_loop.h, for the active lanes. `radiance` grows by what media emit, `throughput` is
  /// weakened by them.
  [[gnu::noinline]] SurfacePoint<F> traceThroughMedia(Ray<F> ray, Mask active, const Vec2<F>& random,
                                                      Spectrum<F>& throughput, Spectrum<F>& radiance);
  // After that, of the lanes' last flights:
  Mask inMedium() const { return inMedium_; }            ///< a medium scatters the path
  const Medium<F>& medium() const { return medium_; }    ///< that medium
  const Vec3<F>& position() const { return position_; }  ///< where it does so
  F distance() const { return distance_; }               ///< of that position from the ray's origin
  F outsideEta() const { return outsideEta_; }           ///< of the surface met otherwise: see Boundary
  const InteriorStack& interior(int i) const { return interior_[at(i)]; }  ///< what the ray of lane i is inside of

  /// The paths of the lanes go on along wi from these surfaces, or from where a medium scatters them.
  [[gnu::noinline]] void scatter(const SurfacePoint<F>& surface, const Vec3<F>& wo, const Vec3<F>& wi, Mask going);
  /// As in path_loop.h, for shadow rays from where the last flights ended.
  [[gnu::noinline]] Spectrum<F> shadowTransmittance(const SurfacePoint<F>& surface, const Vec3<F>& wo, Ray<F> ray,
                                                    Mask lit);

 private:
  /// For each lane: what a ray is inside of, and what becomes of it at surfaces.
  using InteriorStacks = std::array<InteriorStack, static_cast<std::size_t>(width)>;
  using AllCrossings = std::array<Crossings, static_cast<std::size_t>(width)>;

  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  /// Lanes whose paths go through a closed surface.
  Mask changesInterior(const SurfacePoint<F>& surface, const Vec3<F>& wo, const Vec3<F>& wi, Mask lanes) const {
    const Vec3<F>& n = surface.geometricNormal;
    return lanes & surface.valid & (dot(wi, n) * dot(wo, n) < F(0.0f)) & isMoreThanWall(surface, lanes);
  }
  Mask isMoreThanWall(const SurfacePoint<F>& surface, Mask lanes) const {
    return volumes_.template isMoreThanWall<F>(select(lanes & surface.valid, surface.shape, UintOf<F>(0u)));
  }

  const WideScene& scene_;
  const Volumes& volumes_;
  PathCounts& counts_;
  InteriorStacks interior_;  ///< that the rays are inside of
  UintOf<F> inside_{0u};     ///< the number of the medium there
  AllCrossings crossings_;

  Mask inMedium_{false};
  Medium<F> medium_;
  Vec3<F> position_;
  F distance_{0.0f}, outsideEta_{1.0f};
};

template <class F>
SurfacePoint<F> WideFreeFlight<F>::traceThroughMedia(Ray<F> ray, Mask active, const Vec2<F>& random,
                                                     Spectrum<F>& throughput, Spectrum<F>& radiance) {
  FreeFlight<F> flight(throughput, random);
  inMedium_ = Mask(false);
  outsideEta_ = F(1.0f);
  Mask crossed(false), lost(false);
  // Ends segments of these lanes at the surfaces met, in this medium; returns the lanes whose rays go on behind them.
  const auto endSegments = [&](const SurfacePoint<F>& met, const Medium<F>& medium, Mask lanes) {
    const Mask scattered = flight.sampleSegment(medium, ray, select(met.valid, met.distance, F(kInfinity)), lanes);
    inMedium_ = inMedium_ | scattered;
    const Mask here = lanes & met.valid & !scattered;
    Mask onward(false);
    forEachLane(here & (crossed | isMoreThanWall(met, here)), [&](int i) {
      Crossings& crossings = crossings_[at(i)];
      if (!lane(crossed, i)) crossings.restart();
      Ray<float> one = lane(ray, i);
      if (crossings.pass(volumes_, lane(met, i), one, interior_[at(i)])) {
        setLane(ray.tMin, i, one.tMin);
        setLane(onward, i, true);
      } else {
        setLane(outsideEta_, i, crossings.outsideEta());
        setLane(lost, i, crossings.isLost());
      }
      setLane(inside_, i, volumes_.mediumIn(interior_[at(i)]));
    });
    crossed = crossed | onward;
    return onward;
  };
  SurfacePoint<F> arrivals = scene_.intersect(ray, active, &counts_.embree);
  medium_ = volumes_.media().template at<F>(inside_);
  for (Mask left = endSegments(arrivals, medium_, active); any(left);) {
    const SurfacePoint<F> met = scene_.intersect(ray, left, &counts_.embree);
    const Medium<F> medium = volumes_.media().template at<F>(inside_);
    forEachLane(left, [&](int i) { setLane(arrivals, i, lane(met, i)); });
    medium_ = select(left, medium, medium_);
    left = endSegments(met, medium, left);
  }
  distance_ = flight.distance();
  position_ = ray.at(distance_);
  arrivals.valid = arrivals.valid & !inMedium_;
  radiance = select(active, radiance + throughput * flight.emitted(), radiance);
  throughput = select(active, select(lost, Spectrum<F>{}, throughput * flight.weight()), throughput);
  return arrivals;
}

template <class F>
void WideFreeFlight<F>::scatter(const SurfacePoint<F>& surface, const Vec3<F>& wo, const Vec3<F>& wi, Mask going) {
  forEachLane(changesInterior(surface, wo, wi, going), [&](int i) {
    volumes_.scatter(lane(surface, i), lane(wo, i), lane(wi, i), interior_[at(i)]);
    setLane(inside_, i, volumes_.mediumIn(interior_[at(i)]));
  });
}

template <class F>
Spectrum<F> WideFreeFlight<F>::shadowTransmittance(const SurfacePoint<F>& surface, const Vec3<F>& wo, Ray<F> ray,
                                                   Mask lit) {
  if (!volumes_.passable()) lit = lit & !scene_.occluded(ray, lit, &counts_.embree);
  InteriorStacks interior;  // of the lanes in `own`, whose rays are no longer inside of what they started in
  Mask own = changesInterior(surface, wo, ray.direction, lit);
  UintOf<F> inside = inside_;
  forEachLane(own, [&](int i) {
    interior[at(i)] = interior_[at(i)];
    volumes_.scatter(lane(surface, i), lane(wo, i), lane(ray.direction, i), interior[at(i)]);
    setLane(inside, i, volumes_.mediumIn(interior[at(i)]));
  });
  Spectrum<F> share = select(lit, grey(F(1.0f)), Spectrum<F>{});
  Mask crossed(false);
  while (any(lit)) {
    SurfacePoint<F> met;
    if (volumes_.passable()) met = scene_.intersect(ray, lit, &counts_.embree);
    const F length = select(met.valid, met.distance, ray.tMax) - ray.tMin;
    share = select(lit, share * volumes_.media().template at<F>(inside).transmittance(length), share);
    lit = lit & met.valid;
    const Mask inQuestion = lit & !isBlack(share) & isMoreThanWall(met, lit);
    share = select(lit & !inQuestion, Spectrum<F>{}, share);
    lit = inQuestion;
    forEachLane(inQuestion, [&](int i) {
      if (!lane(own, i)) interior[at(i)] = interior_[at(i)];
      if (!lane(crossed, i)) crossings_[at(i)].restart();
      setLane(own, i, true);
      setLane(crossed, i, true);
      Ray<float> one = lane(ray, i);
      if (crossings_[at(i)].pass(volumes_, lane(met, i), one, interior[at(i)])) {
        setLane(ray.tMin, i, one.tMin);
        setLane(inside, i, volumes_.mediumIn(interior[at(i)]));
      } else {
        setLane(share, i, Rgb{});
        setLane(lit, i, false);
      }
    });
  }
  return share;
}

}  // namespace steradian
