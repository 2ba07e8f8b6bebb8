#include "steradian/core/sampling/ggx.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>

#include "steradian/tests/support/proof.h"

namespace steradian {
namespace {

using namespace test;

struct Case {
  float alphaX, alphaY;
  Vec3f wo;
};
const std::array<Case, 9> kCases{Case{0.5f, 0.5f, {0.0f, 0.0f, 1.0f}},
                                 Case{1.0f, 1.0f, normalize(Vec3f{1.0f, 2.0f, 1.0f})},
                                 Case{0.3f, 0.7f, normalize(Vec3f{-2.0f, 0.5f, 0.3f})},
                                 Case{0.7f, 0.15f, normalize(Vec3f{1.0f, 1.0f, 2.0f})},
                                 Case{0.4f, 0.4f, {1.0f, 0.0f, 0.0f}},
                                 Case{0.2f, 0.6f, normalize(Vec3f{0.6f, -0.8f, 1e-4f})},
                                 Case{0.02f, 0.02f, normalize(Vec3f{1.0f, 0.0f, 1.0f})},
                                 Case{1e-3f, 1e-3f, normalize(Vec3f{0.2f, 0.5f, 1.0f})},
                                 Case{3.0f, 5.0f, normalize(Vec3f{1.0f, 0.0f, 0.5f})}};

template <class F>
GgxVisibleNormals<F> normalsOf(const Case& c) {
  return {{F(c.alphaX), F(c.alphaY)}, broadcast<F>(c.wo)};
}
CheckOptions optionsFor(const Case& c, double lobe) {
  CheckOptions options;
  const double widest = 3.0 * lobe * static_cast<double>(std::max(c.alphaX, c.alphaY));
  if (widest < 1.0) options.grid.focus = widest;
  options.noSample = std::nullopt;  // the cosines of grazing normals round to 0
  options.inverseTolerance = 1e-5;
  return options;
}

TEST(GgxStatistics, VisibleNormals) {
  for (const Case& c : kCases) {
    EXPECT_TRUE(prove([&c](auto f) { return normalsOf<decltype(f)>(c); }, optionsFor(c, 1.0)))
        << c.alphaX << ' ' << c.alphaY << ' ' << c.wo.z;
  }
}

TEST(GgxStatistics, Reflections) {
  for (const Case& c : kCases) {
    CheckOptions options = optionsFor(c, 2.0);
    options.grid.axis = {-c.wo.x, -c.wo.y, c.wo.z};
    options.inverseTolerance = 1e-4;
    EXPECT_TRUE(prove([&c](auto f) { return GgxReflection<decltype(f)>{normalsOf<decltype(f)>(c)}; }, options))
        << c.alphaX << ' ' << c.alphaY << ' ' << c.wo.z;
  }
}

}  // namespace
}  // namespace steradian
