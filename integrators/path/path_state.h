#pragma once
/// Where a path is on its way from one vertex to the next.
#include "steradian/core/math/ray.h"
#include "steradian/core/transport/scattering.h"
#include "steradian/core/transport/spectrum.h"

namespace STERADIAN_API steradian {

template <class F>
struct PathState {
  Ray<F> ray;
  ScatterPoint<F> from;  ///< that the ray leaves
  Spectrum<F> throughput = grey(F(1.0f));
  F fromDensity{kDirac};  ///< competingDensity (path_loop.h) of the ray's direction
  F refraction{1.0f};     ///< see survivalProbability, there

  PathState() = default;
  /// Of a path that begins at the camera.
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
