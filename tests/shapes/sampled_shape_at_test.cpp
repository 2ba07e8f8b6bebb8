#include "steradian/accel/shapes/sampled_shape_at.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/core/diagnostics.h"

namespace steradian {
namespace {

TEST(SampledShapeAt, TakesPrimitivesFromTheirSets) {
  const SampledShape sphere = sampledShapeOf(SphereSet{{0.0f, 1.0f}, {0.0f, 2.0f}, {0.0f, 3.0f}, {9.0f, 0.5f}}, 1);
  EXPECT_EQ(std::get<Sphere<float>>(sphere.shape()).center.z, 3.0f);
  EXPECT_FLOAT_EQ(sphere.area(), 3.14159265f);
  QuadSet quads{{1.0f}, {2.0f}, {3.0f}, {2.0f}, {0.0f}, {0.0f}, {0.0f}, {0.0f}, {3.0f}};
  EXPECT_FLOAT_EQ(sampledShapeOf(quads, 0).area(), 6.0f);
  EXPECT_FLOAT_EQ(sampledShapeOf(quads, 0).normalAt({}).y, -1.0f);
  EXPECT_FLOAT_EQ(sampledShapeOf(DiskSet{{0.0f}, {0.0f}, {0.0f}, {0.0f}, {1.0f}, {0.0f}, {2.0f}}, 0).area(),
                  12.566371f);
  BoxSet boxes{{1.0f}, {2.0f}, {3.0f}, {0.5f}, {1.0f}, {2.0f}, {}, {}, {}, {}};
  EXPECT_FLOAT_EQ(sampledShapeOf(boxes, 0).area(), 28.0f);
  boxes.rotationW = {std::sqrt(0.5f)};
  boxes.rotationX = {0.0f};
  boxes.rotationY = {std::sqrt(0.5f)};
  boxes.rotationZ = {0.0f};
  EXPECT_NEAR(sampledShapeOf(boxes, 0).normalAt({3.0f, 2.0f, 3.0f}).x, 1.0f, 1e-6);
  const TriangleMesh mesh{
      {{0.0f, 0.0f, 0.0f}, {1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {2.0f, 2.0f, 0.0f}}, {0, 1, 2, 1, 3, 2}, {}, {}};
  EXPECT_FLOAT_EQ(sampledShapeOf(mesh, 0).area(), 0.5f);
  EXPECT_FLOAT_EQ(sampledShapeOf(mesh, 1).area(), 1.5f);
  EXPECT_THROW(sampledShapeOf(CustomShapeSet{}, 0), Error);
}

}  // namespace
}  // namespace steradian
