#include "steradian/core/math/vec.h"

#include <gtest/gtest.h>

#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using test::numbers;
using test::sameInLanes;

void expectEqual(Vec3f a, Vec3f b) {
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.z, b.z);
}

TEST(Vec, Arithmetic) {
  const Vec3f a{1.0f, -2.0f, 3.0f}, b{4.0f, 5.0f, -6.0f};
  expectEqual(a + b, {5.0f, 3.0f, -3.0f});
  expectEqual(a - b, {-3.0f, -7.0f, 9.0f});
  expectEqual(a * b, {4.0f, -10.0f, -18.0f});
  expectEqual(a * 2.0f, {2.0f, -4.0f, 6.0f});
  expectEqual(2.0f * a, a * 2.0f);
  expectEqual(a / 2.0f, {0.5f, -1.0f, 1.5f});
  expectEqual(-a, {-1.0f, 2.0f, -3.0f});
  Vec3f c = a;
  c += b;
  c -= a;
  c *= 0.5f;
  expectEqual(c, {2.0f, 2.5f, -3.0f});
}

TEST(Vec, Products) {
  const Vec3f a{1.0f, -2.0f, 3.0f}, b{4.0f, 5.0f, -6.0f};
  EXPECT_EQ(dot(a, b), -24.0f);
  EXPECT_EQ(absDot(a, b), 24.0f);
  expectEqual(cross(a, b), {-3.0f, 18.0f, 13.0f});
  expectEqual(cross(Vec3f{1.0f, 0.0f, 0.0f}, Vec3f{0.0f, 1.0f, 0.0f}), {0.0f, 0.0f, 1.0f});
  EXPECT_EQ(lengthSquared(a), 14.0f);
  EXPECT_EQ(length(Vec3f{2.0f, 3.0f, 6.0f}), 7.0f);
  expectEqual(normalize(Vec3f{0.0f, -4.0f, 0.0f}), {0.0f, -1.0f, 0.0f});
}

TEST(Vec, ComponentsAndSides) {
  const Vec3f a{1.0f, -2.0f, 3.0f}, b{4.0f, -5.0f, -6.0f};
  expectEqual(absolute(a), {1.0f, 2.0f, 3.0f});
  expectEqual(minimum(a, b), {1.0f, -5.0f, -6.0f});
  expectEqual(maximum(a, b), {4.0f, -2.0f, 3.0f});
  EXPECT_EQ(maxComponent(a), 3.0f);
  expectEqual(faceForward(a, {0.0f, 0.0f, 1.0f}), a);
  expectEqual(faceForward(a, {0.0f, 0.0f, -1.0f}), -a);
  expectEqual(select(false, a, b), b);
}

TEST(Vec, LanesHoldVectors) {
  using F = Lanes<4>;
  Vec3<F> v = broadcast<F>(Vec3f{1.0f, 2.0f, 3.0f});
  setLane(v, 2, {7.0f, 8.0f, 9.0f});
  expectEqual(lane(v, 2), {7.0f, 8.0f, 9.0f});
  expectEqual(lane(v, 1), {1.0f, 2.0f, 3.0f});
  Vec2<F> p;
  setLane(p, 3, Vec2f{5.0f, 6.0f});
  EXPECT_EQ(lane(p, 3).y, 6.0f);
  EXPECT_EQ(lane(p, 0).y, 0.0f);
}

TEST(Vec, LanesAgreeWithScalars) {
  const auto a = numbers(128, -2.0f, 3.0f), b = numbers(128, -1.0f, 1.0f, 1), c = numbers(128, 0.5f, 2.0f, 2);
  EXPECT_TRUE(sameInLanes<4>([](auto x, auto y, auto z) { return normalize(Vec3{x, y, z}); }, a, b, c));
  EXPECT_TRUE(sameInLanes<4>([](auto x, auto y, auto z) { return cross(Vec3{x, y, z}, Vec3{z, x, y}); }, a, b, c));
  EXPECT_TRUE(sameInLanes<4>(
      [](auto x, auto y, auto z) {
        return faceForward(Vec3{x, y, z}, Vec3{y, z, x});
      },
      a, b, c));
  EXPECT_TRUE(sameInLanes<4>([](auto x, auto y, auto z) { return select(x < y, Vec2{x, z}, Vec2{y, x}); }, a, b, c));
}

}  // namespace
}  // namespace steradian
