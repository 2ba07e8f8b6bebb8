#include "steradian/accel/shapes/primitives/box.h"

#include <algorithm>
#include <cmath>

#include "steradian/tests/accel/shapes/leaf_test.h"

namespace steradian::test {
namespace {

struct BoxTruth : Truth {
  int face = 0;
};

/// The nearest of the six faces, each as a rectangle.
BoxTruth truthOf(const Box<float>& box, const Ray<float>& ray) {
  const Vec3d axes[3] = {toDouble(box.axes.x), toDouble(box.axes.y), toDouble(box.axes.z)};
  const double half[3] = {box.half.x, box.half.y, box.half.z};
  const Vec3d d = toDouble(ray.direction), f = toDouble(ray.origin) - toDouble(box.center);
  BoxTruth truth;
  truth.t = ray.tMax;
  truth.margin = 1.0;
  for (int face = 0; face < kBoxFaces; ++face) {
    const int k = face / 2, i = (k + 1) % 3, j = (k + 2) % 3;
    const double side = face % 2 == 0 ? -half[k] : half[k];
    const double cosine = dot(d, axes[k]);
    const double t = (side - dot(f, axes[k])) / cosine;
    const Vec3d p = f + d * t;
    const double inside = std::min(half[i] - std::abs(dot(p, axes[i])), half[j] - std::abs(dot(p, axes[j])));
    truth.margin = std::min({truth.margin, std::abs(inside), std::abs(t), std::abs(cosine)});
    if (inside < 0.0 || t <= static_cast<double>(ray.tMin) || t >= truth.t) continue;
    truth.t = t;
    truth.face = face;
    truth.hit = true;
  }
  return truth;
}

Frame<float> randomAxes(Random& random) {
  const float x = random.uniform(-1.0f, 1.0f), y = random.uniform(-1.0f, 1.0f), z = random.uniform(-1.0f, 1.0f);
  const float w = random.uniform(0.2f, 1.0f), scale = 1.0f / std::sqrt(w * w + x * x + y * y + z * z);
  return axesOfQuaternion(w * scale, x * scale, y * scale, z * scale);
}

Box<float> randomBox(Random& random) {
  return {random.point(1.0f),
          {random.uniform(0.1f, 1.0f), random.uniform(0.1f, 1.0f), random.uniform(0.1f, 1.0f)},
          randomAxes(random)};
}

TEST(Box, QuaternionsGiveRightHandedOrthonormalAxes) {
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    const Frame<float> f = randomAxes(random);
    EXPECT_NEAR(length(f.x), 1.0f, 1e-6f);
    EXPECT_NEAR(length(f.y), 1.0f, 1e-6f);
    EXPECT_NEAR(length(cross(f.x, f.y) - f.z), 0.0f, 1e-6f);
  }
  // A right angle about y turns z into x.
  const float h = std::sqrt(0.5f);
  const Frame<float> turned = axesOfQuaternion(h, 0.0f, h, 0.0f);
  EXPECT_NEAR(turned.z.x, 1.0f, 1e-6f);
  EXPECT_NEAR(turned.x.z, -1.0f, 1e-6f);
}

TEST(Box, AgreesWithDoublePrecisionOnRandomRays) {
  Random random(1);
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const Box<float> box = randomBox(random);
    const Ray<float> ray = random.rayTowards(box.center, 1.0f, 3.0f);
    const BoxTruth truth = truthOf(box, ray);
    const ShapeHit<float> hit = intersect(box, ray);
    ASSERT_NO_FATAL_FAILURE(expectAgrees(hit, truth, 1e-4, 2e-2));
    ASSERT_NO_FATAL_FAILURE(expectAgrees(hit, truth, 2e-2, 1e-4));
    if (truth.hit && truth.margin > 1e-3) {
      ASSERT_EQ(static_cast<int>(hit.u), truth.face);
    }
    hits += truth.hit;
  }
  EXPECT_GT(hits, 5000);
}

TEST(Box, FromInsideTheExitFaceIsHit) {
  Random random(2);
  for (int i = 0; i < 5000; ++i) {
    const Box<float> box = randomBox(random);
    const Vec3f inside{0.9f * random.uniform(-1, 1), 0.9f * random.uniform(-1, 1), 0.9f * random.uniform(-1, 1)};
    const Ray<float> ray{box.center + box.axes.toWorld(inside * box.half), random.direction()};
    const BoxTruth truth = truthOf(box, ray);
    const ShapeHit<float> hit = intersect(box, ray);
    ASSERT_TRUE(hit.valid);
    ASSERT_NEAR(hit.t, truth.t, 1e-4);
    if (truth.margin > 1e-3) {
      ASSERT_EQ(static_cast<int>(hit.u), truth.face);
    }
  }
}

TEST(Box, AxisParallelRaysAreExact) {
  const Box<float> box{{0.0f, 0.0f, 0.0f}, {1.0f, 2.0f, 3.0f}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  const ShapeHit<float> front = intersect(box, Ray<float>{{0.5f, 0.5f, 5.0f}, {0.0f, 0.0f, -1.0f}});
  EXPECT_TRUE(front.valid);
  EXPECT_EQ(front.t, 2.0f);
  EXPECT_EQ(front.u, 5.0f);
  const ShapeHit<float> left = intersect(box, Ray<float>{{-4.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}});
  EXPECT_EQ(left.t, 3.0f);
  EXPECT_EQ(left.u, 0.0f);
  EXPECT_FALSE(intersect(box, Ray<float>{{1.5f, 0.0f, 5.0f}, {0.0f, 0.0f, -1.0f}}).valid);
  EXPECT_FALSE(intersect(box, Ray<float>{{0.0f, 0.0f, 5.0f}, {0.0f, 0.0f, 1.0f}}).valid);
  // Along a face, in its plane: either result is acceptable, but not NaN.
  const ShapeHit<float> along = intersect(box, Ray<float>{{1.0f, 0.0f, 5.0f}, {0.0f, 0.0f, -1.0f}});
  if (along.valid) {
    EXPECT_EQ(along.t, 2.0f);
  }
  const ShapeHit<float> beside = intersect(box, Ray<float>{{1.0f, 0.0f, 5.0f}, {-0.0f, 1.0f, 0.0f}});
  EXPECT_FALSE(beside.valid);
}

TEST(Box, AxesAboutYAreTheQuaternions) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const float angle = random.uniform(-3.0f, 3.0f), w = std::cos(angle / 2), y = std::sin(angle / 2);
    const Box<float> box{random.point(1.0f), {0.5f, 0.6f, 0.7f}, axesOfQuaternion(w, 0.0f, y, 0.0f)};
    const AxesAboutY<float> axes{box.axes.x.x, box.axes.z.x};
    const Ray<float> ray = random.rayTowards(box.center, 0.7f, 3.0f);
    const BoxCrossing<float> crossing = crossBox(UprightBox<float>{box.center, box.half, axes}, ray);
    const ShapeHit<float> hit{crossing.valid, crossing.t, crossing.face(), 0.0f};
    ASSERT_NO_FATAL_FAILURE(expectLane(hit, 0, intersect(box, ray)));
  }
}

TEST(Box, NaNIsNeverHit) {
  const float nan = std::nanf("");
  const Vec3f all{nan, nan, nan};
  EXPECT_FALSE(intersect(Box<float>{all, all, {all, all, all}}, Ray<float>{{}, {0.0f, 0.0f, 1.0f}}).valid);
}

TEST(Box, EveryWidthGivesTheSameBits) {
  expectWidthsAgree(4, randomBox, [](const auto& b) {
    Box<Lanes<8>> wide{gatherVectors(b, &Box<float>::center), gatherVectors(b, &Box<float>::half), {}};
    for (int i = 0; i < 8; ++i) {
      steradian::setLane(wide.axes.x, i, b[i].axes.x);
      steradian::setLane(wide.axes.y, i, b[i].axes.y);
      steradian::setLane(wide.axes.z, i, b[i].axes.z);
    }
    return wide;
  });
}

}  // namespace
}  // namespace steradian::test
