#pragma once
/// What a path carries from one vertex to the next.
#include "steradian/core/math/ray.h"
#include "steradian/core/transport/scattering.h"
#include "steradian/core/transport/spectrum.h"

namespace STERADIAN_API steradian {

template <class F>
struct PathState {
  Ray<F> ray;
  ScatterPoint<F> from;                    ///< the point that the ray leaves
  Spectrum<F> throughput = grey(F(1.0f));  ///< radiance at the camera per radiance that arrives along the ray
  F fromDensity{kDirac};                   ///< competingDensity() (mis_weights.h) of the ray's direction
  F refraction{1.0f};                      ///< see survivalProbability() (path_loop.h)

  PathState() = default;
  /// A path that begins at the camera.
  explicit PathState(const Ray<F>& cameraRay) : ray(cameraRay) {
    from.position = ray.origin;
    from.time = ray.time;
  }
};

template <class F>
PathState<float> lane(const PathState<F>& path, int i) {
  PathState<float> r;
  r.ray = lane(path.ray, i);
  r.from = lane(path.from, i);
  r.throughput = lane(path.throughput, i);
  r.fromDensity = lane(path.fromDensity, i);
  r.refraction = lane(path.refraction, i);
  return r;
}
template <class F>
void setLane(PathState<F>& path, int i, const PathState<float>& value) {
  setLane(path.ray, i, value.ray);
  setLane(path.from, i, value.from);
  setLane(path.throughput, i, value.throughput);
  setLane(path.fromDensity, i, value.fromDensity);
  setLane(path.refraction, i, value.refraction);
}

}  // namespace steradian
