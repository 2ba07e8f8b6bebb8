#pragma once
/// Checks that every shape must pass as a sampling target.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>
#include <vector>

#include "steradian/accel/shapes/primitives/quad.h"
#include "steradian/accel/shapes/primitives/triangle.h"
#include "steradian/core/samplers/rng.h"
#include "steradian/core/sampling/warp.h"
#include "steradian/core/transport/scattering.h"
#include "steradian/tests/support/lanes_check.h"

namespace steradian::test {

inline float randomFloat(std::uint32_t index, std::uint32_t key) {
  return toUnitFloat<float>(randomWords<std::uint32_t>(index, key, 7, 11)[0]);
}

/// Random points of the unit square, after kAwkwardPoints pairs of extreme numbers, at which samplers tend to fail.
inline constexpr int kAwkwardPoints = 49;
inline std::vector<Vec2f> unitPoints(std::uint32_t count) {
  std::vector<Vec2f> points;
  const std::array<float, 7> awkward{0.0f, 0x1p-24f, 0.25f, 0.5f - 0x1p-25f, 0.5f, 0x1.fffffcp-1f, kOneMinusEpsilon};
  for (float x : awkward) {
    for (float y : awkward) points.push_back({x, y});
  }
  for (std::uint32_t i = 0; i < count; ++i) points.push_back({randomFloat(i, 1), randomFloat(i, 2)});
  return points;
}

struct TargetOptions {
  double pdfTolerance = 2e-4;  ///< relative
  /// Share of the random samples that may lie on an edge, where rounding decides about hit or miss or the face of a
  /// box.
  double edgeShare = 0.002;
  double noSample = 0.0;  ///< share of the samples; negative: any
};

/// Finite samples of unit length that hit the shape at their distance, with the pdf that pdfDirection gives.
template <class S>
void expectSoundTarget(const S& shape, Vec3f from, const TargetOptions& options = {}) {
  int index = 0, edges = 0, none = 0;
  const std::vector<Vec2f> points = unitPoints(1000);
  for (const Vec2f u : points) {
    ++index;
    const DirectionSample<float> s = sampleDirection(shape, from, u);
    ASSERT_TRUE(std::isfinite(s.pdf) && s.pdf >= 0.0f) << s.pdf << " at " << u.x << ", " << u.y;
    ASSERT_TRUE(std::isfinite(s.wi.x + s.wi.y + s.wi.z + s.distance)) << "at " << u.x << ", " << u.y;
    if (s.pdf == 0.0f) {
      ++none;
      continue;
    }
    ASSERT_NEAR(length(s.wi), 1.0, 2e-6);
    ASSERT_GT(s.distance, 0.0f);
    const float pdf = pdfDirection(shape, from, s.wi);
    const ShapeHit<float> hit = intersect(shape, Ray<float>{from, s.wi});
    const bool same = std::abs(pdf / s.pdf - 1.0f) <= options.pdfTolerance;
    const bool isHit = hit.valid && std::abs(hit.t / s.distance - 1.0f) <= 1e-3f;
    if ((!same || !isHit) && index > kAwkwardPoints) ++edges;  // awkward points make corners
  }
  const double count = static_cast<double>(points.size());
  EXPECT_LE(edges / count, options.edgeShare);
  if (options.noSample >= 0.0) {
    EXPECT_NEAR(none / count, options.noSample, options.noSample > 0.0 ? 0.05 : 0.0);
  }
}

/// The mean over the unit square of f(direction) / pdf by a grid of n x n midpoints: the integral of f over the solid
/// angle of the target if sample and pdf agree.
template <class S, class Function>
double integrateTarget(const S& shape, Vec3f from, const Function& f, int n = 256) {
  double sum = 0.0;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const Vec2f u{(static_cast<float>(i) + 0.5f) / static_cast<float>(n),
                    (static_cast<float>(j) + 0.5f) / static_cast<float>(n)};
      const DirectionSample<float> s = sampleDirection(shape, from, u);
      if (s.pdf > 0.0f) sum += static_cast<double>(f(s.wi)) / static_cast<double>(s.pdf);
    }
  }
  return sum / (static_cast<double>(n) * n);
}

/// Irradiance on a surface with that normal from a target of radiance 1, nothing in between.
template <class S>
double irradiance(const S& shape, Vec3f from, Vec3f normal) {
  return integrateTarget(shape, from, [&](Vec3f wi) { return std::max(0.0f, dot(wi, normal)); });
}

/// Eight values of a struct of floats as one struct of Lanes<8>.
template <template <class> class S>
S<Lanes<8>> packLanes(const std::array<S<float>, 8>& values) {
  constexpr std::size_t count = sizeof(S<float>) / sizeof(float);
  static_assert(sizeof(S<Lanes<8>>) == count * sizeof(Lanes<8>) && std::is_trivially_copyable_v<S<float>>);
  std::array<std::array<float, count>, 8> in;
  std::memcpy(&in, &values, sizeof(in));
  std::array<std::array<float, 8>, count> out;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < 8; ++k) out[i][k] = in[k][i];
  }
  S<Lanes<8>> packed;
  std::memcpy(static_cast<void*>(&packed), &out, sizeof(packed));
  return packed;
}

/// The same shape in every lane.
template <class F, template <class> class S>
S<F> broadcastShape(const S<float>& shape) {
  if constexpr (widthOf<F> == 1) {
    return shape;
  } else {
    std::array<S<float>, 8> values;
    values.fill(shape);
    return packLanes<S>(values);
  }
}

/// Every function gives the same bits at width 8, where all lanes differ, as at width 1. `make(i)` is the i-th shape.
template <template <class> class S, class Make>
void expectSameAtAllWidths(const Make& make) {
  using F = Lanes<8>;
  const std::vector<Vec2f> points = unitPoints(200);
  std::uint32_t next = 0;
  for (int round = 0; round < 100; ++round) {
    std::array<S<float>, 8> shapes;
    std::array<Vec3<float>, 8> viewers, guesses;
    std::array<Vec2<float>, 8> numbers;
    for (std::size_t k = 0; k < 8; ++k, ++next) {
      shapes[k] = make(next);
      const float scale = std::pow(10.0f, -1.0f + 3.0f * randomFloat(next, 3));
      viewers[k] = (UniformSphere<float>::sample({randomFloat(next, 4), randomFloat(next, 5)})) * scale;
      guesses[k] = UniformSphere<float>::sample({randomFloat(next, 6), randomFloat(next, 7)});
      numbers[k] = points[next % points.size()];
    }
    const S<F> shape = packLanes<S>(shapes);
    const Vec3<F> from = packLanes<Vec3>(viewers), guess = packLanes<Vec3>(guesses);
    const Vec2<F> u = packLanes<Vec2>(numbers);
    const DirectionSample<F> direction = sampleDirection(shape, from, u);
    const PositionSample<F> position = samplePosition(shape, u);
    const F again = pdfDirection(shape, from, direction.wi), other = pdfDirection(shape, from, guess);
    const Vec2<F> numbersAgain = invertDirection(shape, from, direction.wi);
    const F size = area(shape), density = pdfPosition(shape);
    const Vec3<F> normal = normalAt(shape, position.position);
    for (int k = 0; k < 8; ++k) {
      const S<float>& one = shapes[static_cast<std::size_t>(k)];
      const Vec3f viewer = lane(from, k);
      const DirectionSample<float> d = sampleDirection(one, viewer, lane(u, k));
      const PositionSample<float> p = samplePosition(one, lane(u, k));
      const auto same = [&](Vec3f a, Vec3f b) { return a.x == b.x && a.y == b.y && a.z == b.z; };
      ASSERT_TRUE(same(d.wi, lane(direction.wi, k)) && d.pdf == direction.pdf[k] && d.distance == direction.distance[k])
          << "round " << round << ", lane " << k << ": pdf " << d.pdf << " and " << direction.pdf[k];
      ASSERT_TRUE(same(p.position, lane(position.position, k)) && same(p.normal, lane(position.normal, k)));
      ASSERT_EQ(p.pdf, position.pdf[k]);
      ASSERT_EQ(pdfDirection(one, viewer, d.wi), again[k]) << "round " << round << ", lane " << k;
      ASSERT_TRUE(sameBits(invertDirection(one, viewer, d.wi), lane(numbersAgain, k))) << "round " << round;
      ASSERT_EQ(pdfDirection(one, viewer, lane(guess, k)), other[k]) << "round " << round << ", lane " << k;
      ASSERT_EQ(area(one), size[k]);
      ASSERT_EQ(pdfPosition(one), density[k]);
      ASSERT_TRUE(same(normalAt(one, p.position), lane(normal, k)));
    }
  }
}

/// A random vector in [-1, 1]^3.
inline Vec3f randomVector(std::uint32_t index, std::uint32_t key) {
  const auto w = randomWords<std::uint32_t>(index, key, 13, 17);
  return {2.0f * toUnitFloat<float>(w[0]) - 1.0f, 2.0f * toUnitFloat<float>(w[1]) - 1.0f,
          2.0f * toUnitFloat<float>(w[2]) - 1.0f};
}

/// Solid angle of the triangle (a, b, c) seen from the origin, in double.
inline double triangleSolidAngle(const std::array<double, 3>& a, const std::array<double, 3>& b,
                                 const std::array<double, 3>& c) {
  const auto dot3 = [](const auto& x, const auto& y) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; };
  const std::array<double, 3> bc{b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]};
  const double la = std::sqrt(dot3(a, a)), lb = std::sqrt(dot3(b, b)), lc = std::sqrt(dot3(c, c));
  const double volume = std::abs(dot3(a, bc));
  return 2.0 * std::atan2(volume, la * lb * lc + dot3(a, b) * lc + dot3(b, c) * la + dot3(c, a) * lb);
}
inline std::array<double, 3> relative(Vec3f p, Vec3f from) {
  return {static_cast<double>(p.x) - static_cast<double>(from.x),
          static_cast<double>(p.y) - static_cast<double>(from.y),
          static_cast<double>(p.z) - static_cast<double>(from.z)};
}
inline double solidAngleOfTriangle(const Triangle<float>& t, Vec3f from) {
  return triangleSolidAngle(relative(t.a, from), relative(t.b, from), relative(t.c, from));
}
inline double solidAngleOfQuad(const Quad<float>& q, Vec3f from) {
  const auto a = relative(q.corner, from), b = relative(q.corner + q.u, from), c = relative(q.corner + q.u + q.v, from),
             d = relative(q.corner + q.v, from);
  return triangleSolidAngle(a, b, c) + triangleSolidAngle(a, c, d);
}

}  // namespace steradian::test
