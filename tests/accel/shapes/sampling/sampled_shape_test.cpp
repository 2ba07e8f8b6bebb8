#include "steradian/accel/shapes/sampling/sampled_shape.h"

#include <algorithm>
#include <cmath>

#include "steradian/tests/accel/shapes/target_check.h"

namespace steradian {

// The checks call free functions.
DirectionSample<float> sampleDirection(const SampledShape& s, Vec3f from, Vec2f u) {
  return s.sampleDirection(from, u);
}

namespace test {
namespace {

Matrix linear(Vec3f x, Vec3f y, Vec3f z, Vec3f translation = {}) {
  return {x.x, x.y, x.z, 0.0f, y.x,           y.y,           y.z,           0.0f,
          z.x, z.y, z.z, 0.0f, translation.x, translation.y, translation.z, 1.0f};
}
const Matrix kShear = linear({2.0f, 0.3f, 0.0f}, {-0.4f, 0.7f, 0.2f}, {0.1f, 0.0f, 1.5f}, {1.0f, -2.0f, 0.5f});
const Matrix kMirror = linear({0.0f, 2.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 0.0f, 2.0f}, {1.0f, -2.0f, 0.5f});
const Matrix kStretch = linear({3.0f, 0.0f, 0.0f}, {0.0f, 0.5f, 0.0f}, {0.0f, 0.0f, 1.0f});

const Sphere<float> kSphere{{0.5f, 0.2f, -0.3f}, 0.8f};
const Disk<float> kDisk{{0.5f, 0.2f, -0.3f}, {0.6f, 0.8f, 0.0f}, 0.8f};
const Box<float> kBox{{0.5f, 0.2f, -0.3f}, {0.5f, 0.8f, 1.0f}, Frame<float>::fromZ({0.6f, 0.0f, 0.8f})};
const Quad<float> kQuad{{-0.5f, 0.2f, -0.3f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.8f, 0.6f}};
const Triangle<float> kTriangle{{-0.5f, 0.2f, -0.3f}, {1.0f, 0.0f, 0.0f}, {0.0f, 0.8f, 0.6f}};

template <class S>
bool is(const SampledShape& shape) {
  return std::holds_alternative<S>(shape.shape());
}
using SharedTransformed = std::shared_ptr<const TransformedShape>;

TEST(SampledShape, StaysWhatItIsWhereTheMapAllows) {
  for (const Matrix& m : {kMirror, Matrix()}) {
    EXPECT_TRUE(is<Sphere<float>>(transformed(SampledShape(kSphere), m)));
    EXPECT_TRUE(is<Disk<float>>(transformed(SampledShape(kDisk), m)));
    EXPECT_TRUE(is<Box<float>>(transformed(SampledShape(kBox), m)));
  }
  const Box<float> straight{{}, {1.0f, 2.0f, 3.0f}, Frame<float>::fromZ({0.0f, 0.0f, 1.0f})};
  EXPECT_TRUE(is<Box<float>>(transformed(SampledShape(straight), kStretch)));
  EXPECT_TRUE(is<Disk<float>>(transformed(SampledShape(Disk<float>{{}, {0.0f, 0.0f, 1.0f}, 1.0f}),
                                          linear({2.0f, 0.0f, 0.0f}, {0.0f, 2.0f, 0.0f}, {0.5f, 0.0f, 9.0f}))));
  for (const Matrix& m : {kShear, kStretch}) {
    EXPECT_TRUE(is<SharedTransformed>(transformed(SampledShape(kSphere), m)));
    EXPECT_TRUE(is<SharedTransformed>(transformed(SampledShape(kDisk), m)));
    EXPECT_TRUE(is<SharedTransformed>(transformed(SampledShape(kBox), m)));
    EXPECT_TRUE(is<PreparedQuad<float>>(transformed(SampledShape(kQuad), m)));
    EXPECT_TRUE(is<Triangle<float>>(transformed(SampledShape(kTriangle), m)));
  }
  // One axis alone that differs is enough.
  for (const Vec3f scale : {Vec3f{0.5f, 2.0f, 2.0f}, Vec3f{2.0f, 0.5f, 2.0f}, Vec3f{2.0f, 2.0f, 0.5f}}) {
    const Matrix m = linear({scale.x, 0.0f, 0.0f}, {0.0f, scale.y, 0.0f}, {0.0f, 0.0f, scale.z});
    EXPECT_TRUE(is<SharedTransformed>(transformed(SampledShape(kSphere), m)));
  }
  // There and back again.
  EXPECT_TRUE(is<Sphere<float>>(transformed(transformed(SampledShape(kSphere), kShear), kShear.inverse())));
}

std::vector<SampledShape> allShapes() {
  return {SampledShape(kSphere), SampledShape(kDisk), SampledShape(kBox), SampledShape(kQuad), SampledShape(kTriangle)};
}

TEST(SampledShape, PositionsAndNormalsFollowTheMap) {
  for (const SampledShape& local : allShapes()) {
    for (const Matrix& m : {kShear, kMirror, kStretch}) {
      const SampledShape world = transformed(local, m);
      const Matrix inverse = m.inverse();
      for (std::uint32_t i = 0; i < 50; ++i) {
        const PositionSample<float> p = world.samplePosition({randomFloat(i, 1), randomFloat(i, 2)});
        const Vec3f back = transformPoint(inverse, p.position);
        const Vec3f expected = normalize(transformNormal(inverse, local.normalAt(back)));
        EXPECT_NEAR(dot(p.normal, expected), 1.0, 1e-4);
        EXPECT_NEAR(dot(world.normalAt(p.position), expected), 1.0, 1e-4);
        EXPECT_NEAR(p.pdf / world.pdfPosition(p.position), 1.0, 1e-3);
      }
    }
  }
}

TEST(SampledShape, TheMeanInversePositionDensityIsTheArea) {
  for (const SampledShape& local : allShapes()) {
    for (const Matrix& m : {kShear, kMirror, kStretch}) {
      const SampledShape world = transformed(local, m);
      double sum = 0.0;
      const int columns = 2000, rows = 16;  // the first number chooses the face of a box
      for (int i = 0; i < columns * rows; ++i) {
        const int column = i % columns, row = i / columns;
        const Vec2f u{(static_cast<float>(column) + 0.5f) / columns, (static_cast<float>(row) + 0.5f) / rows};
        sum += 1.0 / static_cast<double>(world.samplePosition(u).pdf);
      }
      EXPECT_NEAR(sum / (columns * rows) / static_cast<double>(world.area()), 1.0, 1e-3);
    }
  }
}

// At each time it equals the shape under the map of that time.
TEST(SampledShape, InMotionIsTheMappedShapeOfTheTime) {
  const MovingTransform first({Matrix(), kShear}),
      then({kStretch, linear({0.0f, 0.0f, -1.0f}, {0.0f, 2.0f, 0.0f}, {1.0f, 0.0f, 0.0f})});
  for (const SampledShape& local : allShapes()) {
    const SampledShape once = inMotion(local, first), twice = inMotion(once, then), last = transformed(once, kMirror);
    for (const float time : {0.0f, 0.4f, 1.0f}) {
      const Matrix m = first.at(time);
      const struct {
        const SampledShape& moving;
        Matrix matrix;
      } cases[]{{once, m}, {twice, m * then.at(time)}, {last, m * kMirror}};
      for (const auto& c : cases) {
        const SampledShape still = transformed(local, c.matrix);
        const Vec3f from = transformPoint(c.matrix, Vec3f{1.5f, 1.4f, 0.4f});
        double movingSum = 0.0, stillSum = 0.0;
        const int n = 64;
        for (int i = 0; i < n * n; ++i) {
          const int column = i % n, row = i / n;
          const Vec2f u{(static_cast<float>(column) + 0.5f) / n, (static_cast<float>(row) + 0.5f) / n};
          const DirectionSample<float> s = c.moving.sampleDirection(from, u, time), t = still.sampleDirection(from, u);
          movingSum += s.pdf > 0.0f ? 1.0 / static_cast<double>(s.pdf) : 0.0;
          stillSum += t.pdf > 0.0f ? 1.0 / static_cast<double>(t.pdf) : 0.0;
          if (i % 16 != 0 || s.pdf == 0.0f) continue;
          ASSERT_NEAR(c.moving.pdfDirection(from, s.wi, time) / s.pdf, 1.0, 2e-3);
          const Vec3f position = from + s.wi * s.distance;
          ASSERT_NEAR(dot(c.moving.normalAt(position, time), still.normalAt(position)), 1.0, 1e-4);
          const PositionSample<float> p = c.moving.samplePosition(u, time);
          ASSERT_NEAR(p.pdf / c.moving.pdfPosition(p.position, time), 1.0, 1e-3);
          ASSERT_NEAR(dot(p.normal, still.normalAt(p.position)), 1.0, 1e-4);
        }
        EXPECT_NEAR(movingSum / stillSum, 1.0, 5e-3);  // the solid angle
      }
    }
    EXPECT_NEAR(once.area() / transformed(local, first.at(0.5f)).area(), 1.0, 1e-5);
  }
}

TEST(SampledShape, AreaOfAnEllipsoid) {
  // Prolate, 2 : 1 : 1: 2 pi (1 + 2 / e asin e), e = sqrt(3) / 2.
  const SampledShape egg = transformed(SampledShape(Sphere<float>{{}, 1.0f}),
                                       linear({2.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}));
  const double e = std::sqrt(3.0) / 2.0;
  EXPECT_NEAR(egg.area(), 2.0 * 3.14159265 * (1.0 + 2.0 / e * std::asin(e)), 2e-3);
  // An ellipse has pi a b.
  const SampledShape ellipse = transformed(SampledShape(Disk<float>{{}, {0.0f, 0.0f, 1.0f}, 1.0f}), kStretch);
  EXPECT_NEAR(ellipse.area(), 3.14159265 * 1.5, 1e-5);
}

// The ray under the inverse map hits the local shape exactly where the ray hits the mapped one.
TEST(SampledShape, DirectionsHitTheMappedShape) {
  const auto check = [](const auto& local, const Matrix& m, Vec3f from, double noSample) {
    const SampledShape world = transformed(SampledShape(local), m);
    const Matrix inverse = m.inverse();
    const std::vector<Vec2f> points = unitPoints(400);
    int edges = 0, none = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const DirectionSample<float> s = world.sampleDirection(from, points[i]);
      ASSERT_TRUE(std::isfinite(s.pdf + s.wi.x + s.wi.y + s.wi.z + s.distance) && s.pdf >= 0.0f);
      none += s.pdf == 0.0f ? 1 : 0;
      if (s.pdf == 0.0f || i < kAwkwardPoints) continue;
      const Ray<float> ray{transformPoint(inverse, from), transformVector(inverse, s.wi)};
      const ShapeHit<float> hit = intersect(local, ray);
      const float pdf = world.pdfDirection(from, s.wi);
      const bool good =
          hit.valid && std::abs(hit.t / s.distance - 1.0f) < 1e-3f && std::abs(pdf / s.pdf - 1.0f) < 2e-3f;
      edges += good ? 0 : 1;
    }
    EXPECT_LE(edges, 3);
    EXPECT_NEAR(none / 449.0, noSample, noSample > 0.0 ? 0.1 : 0.0);
    // pdf and sample agree: the mean of 1 / pdf is the solid angle, found by rays of all directions.
    double hits = 0.0;
    const int n = 256;
    for (int i = 0; i < n * n; ++i) {
      const int column = i % n, row = i / n;
      const Vec2f u{(static_cast<float>(column) + 0.5f) / n, (static_cast<float>(row) + 0.5f) / n};
      const Vec3f wi = UniformSphere<float>::sample(u);
      const bool hit = intersect(local, Ray<float>{transformPoint(inverse, from), transformVector(inverse, wi)}).valid;
      hits += hit ? 1.0 : 0.0;
    }
    const double omega = hits / (n * n) * 4.0 * 3.14159265;
    const double tolerance = std::max(0.01, 2.0 / std::sqrt(hits));  // the silhouette on the grid of rays
    EXPECT_NEAR(integrateTarget(world, from, [](Vec3f) { return 1.0f; }) / omega, 1.0, tolerance);
  };
  for (const Matrix& m : {kShear, kMirror, kStretch}) {
    const auto place = [&](Vec3f p) { return transformPoint(m, p); };
    const Vec3f near = place({1.5f, 1.4f, 0.4f}), far = place({5.0f, -6.0f, 3.0f}), inside = place({0.5f, 0.4f, 0.0f});
    check(kSphere, m, near, 0.0);
    check(kSphere, m, far, 0.0);
    check(kSphere, m, inside, 0.0);
    check(kDisk, m, near, 0.0);
    check(kDisk, m, far, 0.0);
    check(kBox, m, near, 0.0);
    check(kBox, m, far, 0.0);
    check(kBox, m, inside, 0.0);
    check(kQuad, m, near, 0.0);
    check(kTriangle, m, near, 0.0);
  }
}

// Powers of two scale floats exactly: any dependence on units would show.
TEST(SampledShape, NothingDependsOnTheUnitOfLength) {
  const auto scaled = [](const auto& shape, float s) {
    auto copy = shape;
    if constexpr (requires { copy.a; }) {
      copy = {shape.a * s, shape.b * s, shape.c * s};
    } else if constexpr (requires { copy.corner; }) {
      copy = {shape.corner * s, shape.u * s, shape.v * s};
    } else {
      copy.center = shape.center * s;
      if constexpr (requires { copy.radius; }) copy.radius = shape.radius * s;
      if constexpr (requires { copy.half; }) copy.half = shape.half * s;
    }
    return SampledShape(copy);
  };
  const auto check = [&](const auto& shape) {
    for (const float s : {0x1p-10f, 0x1p20f}) {
      for (const Vec3f from : {Vec3f{0.5f, 1.5f, 0.4f}, Vec3f{9.0f, -8.0f, 5.0f}, Vec3f{0.5f, 0.3f, -0.2f}}) {
        for (const Vec2f u : unitPoints(20)) {
          const DirectionSample<float> d = SampledShape(shape).sampleDirection(from, u);
          const DirectionSample<float> e = scaled(shape, s).sampleDirection(from * s, u);
          ASSERT_EQ(d.pdf, e.pdf);
          ASSERT_EQ(d.wi.x, e.wi.x);
          ASSERT_EQ(d.distance * s, e.distance);
          ASSERT_EQ(SampledShape(shape).pdfDirection(from, d.wi), scaled(shape, s).pdfDirection(from * s, d.wi));
        }
      }
    }
  };
  check(kSphere);
  check(kDisk);
  check(kBox);
  check(kQuad);
  check(kTriangle);
}

TEST(SampledShape, DensitiesVanishBesideTheShape) {
  for (const SampledShape& local : allShapes()) {
    const SampledShape world = transformed(local, kShear);
    const Vec3f from{20.0f, 30.0f, 10.0f};
    const Vec3f away = normalize(from - transformPoint(kShear, Vec3f{0.5f, 0.2f, -0.3f}));
    EXPECT_EQ(world.pdfDirection(from, away), 0.0f);
  }
}

}  // namespace
}  // namespace test
}  // namespace steradian
