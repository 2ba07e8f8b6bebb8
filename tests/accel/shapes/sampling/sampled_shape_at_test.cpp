#include "steradian/accel/shapes/sampling/sampled_shape_at.h"

#include <gtest/gtest.h>

#include <cmath>

#include "steradian/core/base/diagnostics.h"

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

TEST(SampledShapeAt, MovesWhatMoves) {
  ShapeDescription shape;
  SphereSet set;
  set.add({0.0f, 0.0f, 0.0f}, 1.0f);
  set.addMoving({0.0f, 0.0f, 0.0f}, {0.0f, 4.0f, 0.0f}, 1.0f);
  shape.geometry = set;
  Matrix moved, far, farther;
  moved.setTranslation(Imath::V3f(0.0f, 0.0f, 10.0f));
  far.setTranslation(Imath::V3f(100.0f, 0.0f, 0.0f));
  farther.setTranslation(Imath::V3f(300.0f, 0.0f, 0.0f));
  const InstanceSet still{0, {far, far}}, moving{0, {far, far}, {far, farther}};
  const auto in = [](const InstanceSet& of, std::size_t copy) { return InstancePlacement{&of, copy, 0}; };
  const auto expectCenter = [](const SampledShape& sphere, float time, Vec3f center) {
    for (const Vec2f u : {Vec2f{0.1f, 0.7f}, Vec2f{0.8f, 0.2f}}) {
      const PositionSample<float> p = sphere.samplePosition(u, time);
      EXPECT_NEAR(length(p.position - center), 1.0f, 1e-4f);
      EXPECT_NEAR(dot(p.normal, p.position - center), 1.0f, 1e-4f);
    }
  };
  expectCenter(sampledShapeOf(shape, 0), 0.5f, {0.0f, 0.0f, 0.0f});
  expectCenter(sampledShapeOf(shape, 1), 0.5f, {0.0f, 2.0f, 0.0f});
  expectCenter(sampledShapeOf(shape, 0, in(still, 1)), 0.5f, {100.0f, 0.0f, 0.0f});
  expectCenter(sampledShapeOf(shape, 1, in(still, 1)), 0.5f, {100.0f, 2.0f, 0.0f});
  expectCenter(sampledShapeOf(shape, 0, in(moving, 0)), 0.5f, {100.0f, 0.0f, 0.0f});
  expectCenter(sampledShapeOf(shape, 0, in(moving, 1)), 0.5f, {200.0f, 0.0f, 0.0f});
  shape.motion = Motion{Matrix(), moved};
  expectCenter(sampledShapeOf(shape, 0), 0.25f, {0.0f, 0.0f, 2.5f});
  expectCenter(sampledShapeOf(shape, 1, in(moving, 1)), 0.25f, {150.0f, 1.0f, 2.5f});
}

}  // namespace
}  // namespace steradian
