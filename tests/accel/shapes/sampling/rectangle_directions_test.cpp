#include "steradian/accel/shapes/sampling/rectangle_directions.h"

#include <cmath>

#include "steradian/tests/accel/shapes/target_check.h"

namespace steradian::test {
namespace {

/// Rectangles of edges, heights and places from 1e-3 to 1e2.
SeenRectangle<float> rectangle(std::uint32_t i) {
  const auto size = [&](std::uint32_t key) { return std::pow(10.0f, 5.0f * randomFloat(i, key) - 3.0f); };
  const float x = (2.0f * randomFloat(i, 1) - 1.0f) * size(2), y = (2.0f * randomFloat(i, 3) - 1.0f) * size(4);
  return {x, x + size(5), y, y + size(6), 0.1f * size(7)};
}

double exactSolidAngle(const SeenRectangle<float>& r) {
  const auto corner = [&](float x, float y) { return relative({x, y, r.z}, {}); };
  const auto a = corner(r.x0, r.y0), b = corner(r.x1, r.y0), c = corner(r.x1, r.y1), d = corner(r.x0, r.y1);
  return triangleSolidAngle(a, b, c) + triangleSolidAngle(a, c, d);
}

TEST(RectangleDirections, SolidAnglesAreAsExactAsStated) {
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const SeenRectangle<float> r = rectangle(i);
    const double exact = exactSolidAngle(r);
    EXPECT_NEAR(solidAngleOf(r), exact, std::max(2e-6, 2e-5 * exact)) << i;
    EXPECT_GE(r.solidAngleBound(), exact * (1.0 - 1e-5)) << i;
  }
}

TEST(RectangleDirections, NothingIsSeenInThePlane) {
  for (std::uint32_t i = 0; i < 100; ++i) {
    SeenRectangle<float> r = rectangle(i);
    r.z = 0.0f;
    EXPECT_EQ(solidAngleOf(r), 0.0f);
    EXPECT_EQ(r.solidAngleBound(), 0.0f);
  }
}

// Of a rectangle that is sampled uniformly, the part left of the sampled point has the share u.x of the solid angle,
// and of the line through it the part below has the share u.y of the distances y / r.
TEST(RectangleDirections, NumbersAreSharesOfTheSolidAngle) {
  int uniform = 0;
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const SeenRectangle<float> r = rectangle(i);
    const RectangleDirections<float> directions(r, true);
    if (!directions.uniform()) continue;
    ++uniform;
    const Vec2f u{randomFloat(i, 8), randomFloat(i, 9)}, p = directions.sample(u);
    const SeenRectangle<float> left{r.x0, p.x, r.y0, r.y1, r.z};
    EXPECT_NEAR(exactSolidAngle(left), static_cast<double>(u.x) * exactSolidAngle(r), 5e-4) << i;
    const double z = std::hypot(static_cast<double>(p.x), static_cast<double>(r.z));
    const auto height = [&](float y) { return y / std::hypot(z, static_cast<double>(y)); };
    const double whole = height(r.y1) - height(r.y0);
    EXPECT_NEAR(height(p.y) - height(r.y0), static_cast<double>(u.y) * whole, 1e-6) << i;
  }
  EXPECT_GT(uniform, 3000);
}

}  // namespace
}  // namespace steradian::test
