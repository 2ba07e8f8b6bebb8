#pragma once
/// SampledShape for several viewers at once, each at a time of its own: the same numbers as width 1 gives, lane by
/// lane.
#include "steradian/accel/shapes/primitives/in_lanes.h"
#include "steradian/accel/shapes/sampling/box_sampling.h"
#include "steradian/accel/shapes/sampling/disk_sampling.h"
#include "steradian/accel/shapes/sampling/quad_sampling.h"
#include "steradian/accel/shapes/sampling/sampled_shape.h"
#include "steradian/accel/shapes/sampling/sphere_sampling.h"
#include "steradian/accel/shapes/sampling/triangle_sampling.h"

namespace STERADIAN_API steradian {

/// Lanes that are not active may have any sample.
template <class F>
DirectionSample<F> sampleDirection(const SampledShape& shape, Vec3<F> from, Vec2<F> u, F time,
                                   MaskOf<F> active = MaskOf<F>(true)) {
  if constexpr (widthOf<F> == 1) {
    return shape.sampleDirection(from, u, time);
  } else {
    return std::visit(
        [&]<class S>(const S& s) {
          if constexpr (std::is_same_v<S, Sphere<float>>) {
            return sampleDirection(inLanes<F>(s), from, u, active);
          } else if constexpr (requires { inLanes<F>(s); }) {
            return sampleDirection(inLanes<F>(s), from, u);
          } else {
            DirectionSample<F> samples;
            for (int i = 0; i < widthOf<F>; ++i) {
              const DirectionSample<float> one = s->sampleDirection(lane(from, i), lane(u, i), lane(time, i));
              setLane(samples.wi, i, one.wi);
              setLane(samples.pdf, i, one.pdf);
              setLane(samples.distance, i, one.distance);
            }
            return samples;
          }
        },
        shape.shape());
  }
}

/// The density of sampleDirection, per sr; undefined in lanes that are not active.
template <class F>
F pdfDirection(const SampledShape& shape, Vec3<F> from, Vec3<F> wi, F time, MaskOf<F> active = MaskOf<F>(true)) {
  if constexpr (widthOf<F> == 1) {
    return shape.pdfDirection(from, wi, time);
  } else {
    return std::visit(
        [&]<class S>(const S& s) {
          if constexpr (std::is_same_v<S, Sphere<float>>) {
            return pdfDirection(inLanes<F>(s), from, wi, active);
          } else if constexpr (requires { inLanes<F>(s); }) {
            return pdfDirection(inLanes<F>(s), from, wi);
          } else {
            F densities(0.0f);
            for (int i = 0; i < widthOf<F>; ++i)
              setLane(densities, i, s->pdfDirection(lane(from, i), lane(wi, i), lane(time, i)));
            return densities;
          }
        },
        shape.shape());
  }
}

/// Unit outward normals at points of the surface.
template <class F>
Vec3<F> normalAt(const SampledShape& shape, Vec3<F> position, F time) {
  if constexpr (widthOf<F> == 1) {
    return shape.normalAt(position, time);
  } else {
    return std::visit(
        [&]<class S>(const S& s) {
          if constexpr (requires { inLanes<F>(s); }) {
            return normalAt(inLanes<F>(s), position);
          } else {
            Vec3<F> normals;
            for (int i = 0; i < widthOf<F>; ++i) setLane(normals, i, s->normalAt(lane(position, i), lane(time, i)));
            return normals;
          }
        },
        shape.shape());
  }
}

}  // namespace steradian
