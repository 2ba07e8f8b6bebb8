#pragma once
/// The statistical proof of a sampling target, by the harness of tests/support.
#include <algorithm>
#include <cmath>
#include <functional>

#include "steradian/core/math/frame.h"
#include "steradian/tests/accel/shapes/target_check.h"
#include "steradian/tests/support/proof.h"

namespace steradian::test {

/// The directions in which a target is seen: around the mean of its samples, as wide as they spread.
template <class S>
SphereGrid gridAbout(const S& shape, Vec3f from) {
  Vec3f sum{};
  for (std::uint32_t i = 0; i < 500; ++i)
    sum += sampleDirection(shape, from, {randomFloat(i, 1), randomFloat(i, 2)}).wi;
  SphereGrid grid;
  if (length(sum) < 50.0f) return grid;  // all around
  grid.axis = normalize(sum);
  double widest = 0.0;
  for (std::uint32_t i = 0; i < 500; ++i) {
    const Vec3f wi = sampleDirection(shape, from, {randomFloat(i, 1), randomFloat(i, 2)}).wi;
    widest = std::max(widest, 2.0 * std::asin(std::min(1.0, 0.5 * static_cast<double>(length(wi - grid.axis)))));
  }
  grid.focus = std::min(grid.focus, 1.1 * widest);
  return grid;
}

/// A shape seen from a point, in the form that prove() takes.
template <template <class> class S, class F>
struct Seen {
  S<F> shape;
  Vec3<F> from;

  DirectionSample<F> sample(Vec2<F> u) const { return sampleDirection(shape, from, u); }
  F pdf(Vec3<F> wi) const { return pdfDirection(shape, from, wi); }
  Vec2<F> invert(Vec3<F> wi) const { return invertDirection(shape, from, wi); }
};

/// The ladder for a target; its pdf may jump on the edges that the samples end at.
template <template <class> class S>
testing::AssertionResult proveTarget(const S<float>& shape, Vec3f from, CheckOptions options = {}) {
  options.grid = gridAbout(shape, from);
  options.edgeShare = 0.005;
  options.inverseTolerance = std::max(options.inverseTolerance, 2e-4);
  return prove([&]<class F>(F) { return Seen<S, F>{broadcastShape<F, S>(shape), broadcast<F>(from)}; }, options);
}

/// The same in the parameters (u, v) of a hit in [0, 1]^2, where pdfDirection becomes a smooth density, however thin
/// the shape is seen: times the solid angle per area, times `areaPerParameters` (m^2 per unit of (u, v)). For flat
/// shapes.
template <class S>
testing::AssertionResult checkFlatTarget(const S& shape, Vec3f from, float areaPerParameters,
                                         const std::function<Vec3f(Vec2f)>& pointAt, CheckOptions options = {}) {
  const Vec3f normal = normalAt(shape, from);
  const auto density = [&, from, normal, areaPerParameters](Vec2f uv) {
    const Vec3f d = pointAt(uv) - from;
    const float distance = length(d);
    const Vec3f wi = d / distance;
    return static_cast<double>(pdfDirection(shape, from, wi) * absDot(wi, normal) * areaPerParameters / sqr(distance));
  };
  options.domain = {-1e-3, 1.001, -1e-3, 1.001};
  options.edgeShare = 0.02;
  options.pdfTolerance = 5e-3;
  return checkPlaneSampler(
      [&](float, Vec2f u) {
        const DirectionSample<float> s = sampleDirection(shape, from, u);
        if (!(s.pdf > 0.0f)) return PlaneSample{};
        const ShapeHit<float> hit = intersect(shape, Ray<float>{from, s.wi});
        // A miss lies on an edge, where rounding decides: it counts there.
        const Vec2f uv = hit.valid ? Vec2f{hit.u, hit.v} : Vec2f{0.0f, 0.0f};
        return PlaneSample{uv, static_cast<double>(s.pdf * absDot(s.wi, normal) * areaPerParameters / sqr(s.distance))};
      },
      density, options);
}

}  // namespace steradian::test
