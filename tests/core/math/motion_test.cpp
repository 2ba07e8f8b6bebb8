#include "steradian/core/math/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace steradian {
namespace {

struct Random {
  std::mt19937 engine{5};
  float in(float low, float high) { return std::uniform_real_distribution<float>(low, high)(engine); }
  Vec3f point(float reach) {
    const float x = in(-reach, reach), y = in(-reach, reach);
    return {x, y, in(-reach, reach)};
  }
};

Matrix scaled(Vec3f s) {
  Matrix m;
  m.setScale(toImath(s));
  return m;
}
Matrix turned(Vec3f radians) {
  Matrix m;
  m.setEulerAngles(toImath(radians));
  return m;
}
Matrix moved(Vec3f v) {
  Matrix m;
  m.setTranslation(toImath(v));
  return m;
}
/// Scaled and sheared, turned and moved at random; a mirror or not.
Matrix randomKey(Random& random, bool mirror) {
  const auto size = [&] { return std::exp(random.in(-1.5f, 1.5f)); };
  const float x = size(), y = size(), z = size();
  return scaled({mirror ? -x : x, y, z}) * turned(random.point(4.0f)) * scaled({1.0f, random.in(0.5f, 2.0f), 1.0f}) *
         turned(random.point(4.0f)) * moved(random.point(10.0f));
}

void expectNear(const Matrix& a, const Matrix& b, float tolerance) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) ASSERT_NEAR(a[i][j], b[i][j], tolerance) << i << ", " << j;
  }
}

TEST(AffineInverse, IsTheInverse) {
  Random random;
  for (int i = 0; i < 500; ++i) {
    const Matrix m = randomKey(random, i % 2 == 0), inverse = affineInverse(m);
    const Matrix expected(Imath::M44d(m).inverse());
    for (int r = 0; r < 4; ++r) {
      for (int c = 0; c < 4; ++c) ASSERT_NEAR(inverse[r][c], expected[r][c], 1e-6f * absolute(expected[r][c]));
    }
  }
}

TEST(MovingTransform, StartsAndEndsAtItsKeys) {
  Random random;
  for (int i = 0; i < 500; ++i) {
    const Motion motion{randomKey(random, i % 2 == 0), randomKey(random, i % 2 == 0)};
    const MovingTransform transform(motion);
    ASSERT_NO_FATAL_FAILURE(expectNear(transform.at(0.0f), motion.open, 2e-5f));
    ASSERT_NO_FATAL_FAILURE(expectNear(transform.at(1.0f), motion.close, 2e-5f));
  }
}

TEST(MovingTransform, SameKeysAreExact) {
  Random random;
  const Matrix key = randomKey(random, false);
  for (const float time : {0.0f, 0.3f, 1.0f}) EXPECT_EQ(MovingTransform({key, key}).at(time), key);
}

TEST(MovingTransform, TranslationsAndScalesChangeLinearly) {
  const MovingTransform slide({moved({1.0f, 2.0f, 3.0f}), moved({3.0f, 2.0f, -5.0f})});
  EXPECT_EQ(slide.at(0.25f), moved({1.5f, 2.0f, 1.0f}));
  const MovingTransform grow({scaled({1.0f, 2.0f, 1.0f}), scaled({3.0f, 2.0f, 1.0f})});
  expectNear(grow.at(0.75f), scaled({2.5f, 2.0f, 1.0f}), 1e-6f);
  const MovingTransform mirror({scaled({-1.0f, 2.0f, 1.0f}), scaled({-3.0f, 2.0f, 1.0f})});
  expectNear(mirror.at(0.5f), scaled({-2.0f, 2.0f, 1.0f}), 1e-6f);
}

TEST(MovingTransform, RotationsTurnAtConstantSpeedTheShorterWay) {
  const auto about = [](int axis, float radians) {
    return turned({axis == 0 ? radians : 0.0f, axis == 1 ? radians : 0.0f, axis == 2 ? radians : 0.0f});
  };
  for (const int axis : {0, 1, 2}) {
    for (const float end : {0.01f, 1.0f, 3.1f}) {
      const MovingTransform turn({about(axis, 0.5f), about(axis, 0.5f + end)});
      for (const float time : {0.1f, 0.5f, 0.9f}) {
        ASSERT_NO_FATAL_FAILURE(expectNear(turn.at(time), about(axis, 0.5f + end * time), 1e-6f));
      }
    }
    // 4 radians one way are 2 pi - 4 the other.
    const MovingTransform shorter({about(axis, 0.0f), about(axis, 4.0f)});
    expectNear(shorter.at(0.5f), about(axis, 2.0f + kPi), 1e-6f);
  }
}

TEST(MovingTransform, RotationAndStretchAreSeparate) {
  // Half-way, a quarter turn with scaling by 2 is an eighth of a turn with scaling by 1.5, and no shear.
  const MovingTransform both({Matrix(), scaled({2.0f, 1.0f, 1.0f}) * turned({0.0f, kPiOver2, 0.0f})});
  expectNear(both.at(0.5f), scaled({1.5f, 1.0f, 1.0f}) * turned({0.0f, kPiOver4, 0.0f}), 1e-6f);
}

TEST(MovingTransform, IsInvertibleAtAllTimes) {
  Random random;
  for (int i = 0; i < 300; ++i) {
    const MovingTransform transform({randomKey(random, i % 2 == 0), randomKey(random, i % 2 == 0)});
    for (int k = 0; k <= 20; ++k) {
      const Matrix m = transform.at(static_cast<float>(k) / 20.0f);
      const Matrix product = m * affineInverse(m);
      ASSERT_NO_FATAL_FAILURE(expectNear(product, Matrix(), 1e-4f));
    }
  }
}

TEST(MovingTransform, WorksAtAnyScale) {
  Random random;
  for (const float scale : {1e-6f, 1e6f}) {
    const Matrix open = scaled({scale, scale, 2.0f * scale}) * turned({0.1f, 0.2f, 0.3f});
    const Matrix close = scaled({scale, 3.0f * scale, scale}) * turned({0.5f, -0.2f, 0.3f});
    const MovingTransform transform({open, close});
    expectNear(transform.at(0.0f), open, 1e-6f * scale);
    expectNear(transform.at(1.0f), close, 2e-6f * scale);
  }
}

/// Random points within the bounds, random times. The bounds must hold all, and not be much too wide.
TEST(MovingTransform, BoundsHoldAllTimes) {
  Random random;
  double looseness = 0.0;
  const int rounds = 300;
  for (int round = 0; round < rounds; ++round) {
    const bool mirror = round % 3 == 0;
    const MovingTransform transform({randomKey(random, mirror), randomKey(random, mirror)});
    const Vec3f center = random.point(5.0f);
    const Vec3f half{random.in(0.0f, 2.0f), random.in(0.0f, 2.0f), random.in(0.0f, 2.0f)};
    const Bounds3 local{center - half, center + half}, world = transform.bounds(local);
    Bounds3 seen;
    for (int i = 0; i < 2000; ++i) {
      // Corners reach furthest.
      const auto side = [&](float reach) {
        return i % 2 == 0 ? random.in(-reach, reach) : std::copysign(reach, random.in(-1, 1));
      };
      const Vec3f p{center.x + side(half.x), center.y + side(half.y), center.z + side(half.z)};
      const float time = i % 5 == 0 ? 0.2f * static_cast<float>(i % 6) : random.in(0.0f, 1.0f);
      seen.include(transformPoint(transform.at(time), p));
    }
    ASSERT_LE(world.low.x, seen.low.x);
    ASSERT_LE(world.low.y, seen.low.y);
    ASSERT_LE(world.low.z, seen.low.z);
    ASSERT_GE(world.high.x, seen.high.x);
    ASSERT_GE(world.high.y, seen.high.y);
    ASSERT_GE(world.high.z, seen.high.z);
    looseness += static_cast<double>(maxComponent(world.extent()) / maxComponent(seen.extent())) / rounds;
  }
  EXPECT_LT(looseness, 1.1);
  EXPECT_TRUE(MovingTransform({Matrix(), moved({1, 0, 0})}).bounds({}).empty());
}

// The acceleration term alone must suffice: a point makes a full turn between two samples of a naive bound.
TEST(MovingTransform, BoundsOfATurnAreThoseOfTheArc) {
  const MovingTransform turn({turned({0.0f, 0.0f, -0.3f}), turned({0.0f, 0.0f, 2.5f})});
  const Bounds3 arc = turn.bounds({{1.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}});
  EXPECT_GE(arc.high.y, 1.0f);
  EXPECT_GE(arc.high.x, 1.0f);
  EXPECT_LT(arc.high.y, 1.01f);
  EXPECT_LE(arc.low.x, std::cos(2.5f));
  EXPECT_GT(arc.low.x, std::cos(2.5f) - 0.01f);
}

// A point that moves out along an arm that turns slowly dips below both of its end points, because of the growth.
TEST(MovingTransform, BoundsHoldWhatGrowsAndTurns) {
  const MovingTransform arm({turned({0.0f, 0.0f, -0.1f}), scaled({10.0f, 1.0f, 1.0f}) * turned({0.0f, 0.0f, 0.09f})});
  const Vec3f end{1.0f, 0.0f, 0.0f};
  const Bounds3 bounds = arm.bounds({end, end});
  float lowest = 0.0f;
  for (int i = 0; i <= 100; ++i) {
    lowest = std::min(lowest, transformPoint(arm.at(static_cast<float>(i) / 100.0f), end).y);
  }
  EXPECT_LT(lowest, -0.17f);
  EXPECT_LE(bounds.low.y, lowest);
}

TEST(MovingTransform, LocalMagnitudesAreBounded) {
  Random random;
  for (int round = 0; round < 300; ++round) {
    const MovingTransform transform({randomKey(random, false), randomKey(random, false)});
    const float bound = transform.localMagnitude(20.0f);
    float largest = 0.0f;
    for (int i = 0; i < 500; ++i) {
      const Vec3f p = transformPoint(affineInverse(transform.at(random.in(0.0f, 1.0f))), random.point(20.0f));
      largest = std::max(largest, maxComponent(absolute(p)));
    }
    ASSERT_LE(largest, bound);
    ASSERT_GT(largest, 0.02f * bound);
  }
}

TEST(MovingTransform, HandednessIsToldApart) {
  Random random;
  EXPECT_TRUE(sameHandedness(randomKey(random, false), randomKey(random, false)));
  EXPECT_TRUE(sameHandedness(randomKey(random, true), randomKey(random, true)));
  EXPECT_FALSE(sameHandedness(randomKey(random, true), randomKey(random, false)));
}

}  // namespace
}  // namespace steradian
