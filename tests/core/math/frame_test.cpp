#include "steradian/core/math/frame.h"

#include <gtest/gtest.h>

#include "steradian/core/sampling/warp.h"
#include "steradian/tests/support/lanes_check.h"

namespace steradian {
namespace {

using test::unitNumbers;

void expectOrthonormal(const Frame<float>& f) {
  EXPECT_NEAR(lengthSquared(f.x), 1.0f, 1e-6f);
  EXPECT_NEAR(lengthSquared(f.y), 1.0f, 1e-6f);
  EXPECT_NEAR(dot(f.x, f.y), 0.0f, 5e-7f);
  EXPECT_NEAR(dot(f.y, f.z), 0.0f, 5e-7f);
  EXPECT_NEAR(dot(f.z, f.x), 0.0f, 5e-7f);
  EXPECT_NEAR(dot(cross(f.x, f.y), f.z), 1.0f, 1e-6f) << "right-handed";
}

TEST(Frame, IsOrthonormalAndRightHanded) {
  const auto u = unitNumbers(2000), v = unitNumbers(2000, 1);
  for (std::size_t i = 0; i < u.size(); ++i)
    expectOrthonormal(Frame<float>::fromZ(UniformSphere<float>::sample({u[i], v[i]})));
}

TEST(Frame, IsRobustAtThePolesAndAtTheEquator) {
  for (const float z : {1.0f, -1.0f}) expectOrthonormal(Frame<float>::fromZ({0.0f, 0.0f, z}));
  for (const float tiny : {1e-3f, 1e-10f, 1e-30f, 0.0f}) {
    expectOrthonormal(Frame<float>::fromZ(normalize(Vec3f{tiny, -tiny, -1.0f})));
    expectOrthonormal(Frame<float>::fromZ(normalize(Vec3f{tiny, tiny, 1.0f})));
    expectOrthonormal(Frame<float>::fromZ(normalize(Vec3f{0.6f, -0.8f, tiny})));
    expectOrthonormal(Frame<float>::fromZ(normalize(Vec3f{0.6f, -0.8f, -tiny})));
  }
}

TEST(Frame, LocalAndWorldAreInverse) {
  const Frame<float> f = Frame<float>::fromZ(normalize(Vec3f{0.3f, -0.5f, -0.8f}));
  const Vec3f v{0.2f, -1.5f, 3.0f}, back = f.toWorld(f.toLocal(v));
  EXPECT_NEAR(length(back - v), 0.0f, 2e-6f);
  EXPECT_NEAR(length(f.toLocal(f.z) - Vec3f{0.0f, 0.0f, 1.0f}), 0.0f, 1e-6f);
  EXPECT_NEAR(length(f.toWorld({1.0f, 0.0f, 0.0f}) - f.x), 0.0f, 1e-6f);
}

TEST(Frame, LanesAgreeWithScalars) {
  const auto u = unitNumbers(256), v = unitNumbers(256, 1);
  const auto turned = [](auto x, auto y) {
    using F = decltype(x);
    const auto frame = Frame<F>::fromZ(UniformSphere<F>::sample({x, y}));
    return frame.toWorld(frame.toLocal(Vec3<F>{y, x, x}) + Vec3<F>{x, x, y});
  };
  EXPECT_TRUE(test::sameInLanes<8>(turned, u, v));
}

}  // namespace
}  // namespace steradian
